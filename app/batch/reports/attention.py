"""Which lines somebody should check, why, how urgently, and what can be done about each reason.

A line that is performed a little otherwise than it was planned, as most are, needs no check; one of which a movement is
missing or late does (`Measures.unplayed`). Nor are gestures that were offered and gave way to others a reason: most
lines have some.
"""

from collections.abc import Iterator, Mapping
from types import MappingProxyType

from ..manifest.entries import ManifestEntry, State

FLAT_ST = 1.2
"""A take whose pitch deviates less than this, in semitones, is hardly acted."""

SHORTEST_JUDGED_S = 1.0
"""Shorter lines are not called flat."""

_WEIGHTS = {
    "transcript_suspect": 50,
    "alignment_low_confidence": 30,
    "audio_clipped": 15,
    "audio_quiet": 12,
    "audio_antiphase": 12,
    "word_unreadable": 10,
    "agitation_unsure": 2,
    "pronunciation_guessed": 0,
    "listener_unknown": 0,
    "tags_unread": 0,
    "script_start": 0,
    "audio_length_unstated": 0,
}
"""The urgency of warnings; others weigh 5. With 0 nobody has to look: the line says so itself."""

_OTHER = 5
_FAILED, _FLAT, _UNPLAYED, _STILL = 1000, 20, 3, 8


def reasons(entry: ManifestEntry) -> tuple[tuple[int, str], ...]:
    """Why somebody should check the line, the most urgent reason first, each with its weight."""
    return tuple(sorted(_reasons(entry), reverse=True))


def attention(entry: ManifestEntry) -> int:
    """How urgently somebody should check the line; 0 is not at all."""
    return sum(weight for weight, _reason in _reasons(entry))


def _reasons(entry: ManifestEntry) -> Iterator[tuple[int, str]]:
    if entry.state is not State.DONE:
        yield _FAILED, entry.state.value
    for code in sorted({notice.code for notice in entry.warnings}):
        yield _WEIGHTS.get(code, _OTHER), code
    measures = entry.measures
    if measures is None:
        return
    spread_st = measures.pitch_spread_st
    if measures.duration_s >= SHORTEST_JUDGED_S and spread_st is not None and spread_st < FLAT_ST:
        yield _FLAT, "flat_take"
    if measures.gestures == 0 and measures.gestures_dropped:
        yield _STILL, "no_gesture_left"
    if measures.unplayed:
        yield _UNPLAYED, "not_played_as_asked"


_SAID = "listen; correct the words in the script, or record the line again"
_LEVEL = "record it again, or deliver it at another level"
_NOTES = "change the notes for this line, or leave it as it is"
_EDITS = "open the line in the studio and make the change again"

PLAIN: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        "failed": ("not performed", "fix what the message says and run the same command again"),
        "waiting": ("not performed yet", "run the same command again"),
        "transcript_suspect": ("the recording may say other words", _SAID),
        "alignment_low_confidence": ("word times are guessed", _SAID),
        "word_unreadable": ("a word cannot be read", "write it in Latin letters, as it is spoken"),
        "pronunciation_guessed": (
            "a pronunciation is a guess",
            "nothing, if the lips fit; else spell the word as it sounds",
        ),
        "audio_clipped": ("the recording is clipped", _LEVEL),
        "audio_quiet": ("the recording is very quiet", _LEVEL),
        "audio_antiphase": ("the channels cancel each other", "deliver one channel, or invert one of the two"),
        "audio_rescaled": ("the recording was far too loud and is scaled down", "nothing, if it sounds right"),
        "audio_length_unstated": ("the recording states no length", "nothing, if it is all there"),
        "agitation_unsure": ("too much noise to judge the voice", "set agitation for the line, or record it again"),
        "flat_take": ("a flat reading", "listen; there may be a livelier take"),
        "no_gesture_left": ("no gesture is left", "look; lower stillness or note a gesture for the line"),
        "not_played_as_asked": (
            "a movement is missing or late",
            "look at it; the performance (json) says which and why",
        ),
        "visemes_missing": ("the mouth stays shut for some words", "give words without times, or phones with them"),
        "listener_unknown": (
            "a listener has no character of that name",
            "cast the listener, or leave it to the default",
        ),
        "direction_strokes": ("two notes want the same word", _NOTES),
        "direction_still": ("a note wants a gesture where another wants none", _NOTES),
        "direction_avoided": ("a note wants what another forbids", _NOTES),
        "direction_unplayed": ("there is no room for what a note asks for", _NOTES),
        "gesture_unknown": ("no gesture has this name", "take the nearest name that the message gives"),
        "gesture_not_played": ("a gesture gave way", "move one of the two, as the message says"),
        "tags_unread": ("tags of the text are not understood", "nothing, if the words are right"),
        "smartbody_text": ("signs that SmartBody cannot read are left out", "nothing"),
        "smartbody_gaze": ("gazes without a target are left out for SmartBody", "name listeners or targets"),
        "smartbody_unnamed": ("SmartBody cannot find the recording", "name it"),
        "pose_out_of_reach": ("a hand cannot reach that far", "check that the gesture is still clear"),
    }
)
"""Of each code what it means, and what to do."""

_EDIT = ("a change made in the studio no longer fits", _EDITS)


def plain_words(code: str) -> tuple[str, str]:
    """What a code means and what to do; for those of no entry, the code in words."""
    if code in PLAIN:
        return PLAIN[code]
    return _EDIT if code.startswith("edit_") else (code.replace("_", " "), "see the message")

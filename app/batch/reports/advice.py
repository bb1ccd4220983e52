"""What the codes of a report mean to those who record and direct, and what they can do about them."""

from collections.abc import Mapping
from types import MappingProxyType

_SAID = "listen; mend the words in the script, or record the line again"
_LEVEL = "record it again, or deliver it at another level"
_NOTES = "change the notes for this line, or leave it as it is"
_EDITS = "open the line in the studio and make the change again"

PLAIN: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        "failed": ("not performed", "mend what the message says and run the same command again"),
        "waiting": ("not performed yet", "run the same command again"),
        "transcript_suspect": ("other words may be said", _SAID),
        "alignment_low_confidence": ("where the words are is a guess", _SAID),
        "word_unreadable": ("a word cannot be read", "write it in Latin letters, as it is spoken"),
        "pronunciation_guessed": (
            "a pronunciation is a guess",
            "nothing, if the lips fit; else spell the word as it sounds",
        ),
        "audio_clipped": ("the recording is clipped", _LEVEL),
        "audio_quiet": ("the recording is very quiet", _LEVEL),
        "audio_antiphase": ("the channels cancel each other", "deliver one channel, or turn the phase of one"),
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
        "smartbody_text": ("signs that SmartBody cannot read are left out", "nothing"),
        "smartbody_gaze": ("looks at nobody are left out for SmartBody", "name listeners or targets"),
        "smartbody_unnamed": ("SmartBody cannot find the recording", "name it"),
        "pose_out_of_reach": ("a hand cannot reach that far", "look whether the gesture reads"),
    }
)
"""Of each code what it means, and what to do."""

_EDIT = ("a change made in the studio no longer fits", _EDITS)


def plain_words(code: str) -> tuple[str, str]:
    """What a code means and what to do; for those of no entry, the code in words."""
    if code in PLAIN:
        return PLAIN[code]
    return _EDIT if code.startswith("edit_") else (code.replace("_", " "), "see the message")

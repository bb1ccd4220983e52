"""Which lines somebody should check, why, and how urgently.

A line that is performed a little otherwise than it was planned, as most are, needs no check; one of which a movement is
missing or late does (`Measures.unplayed`). Nor are gestures that were offered and gave way to others a reason: most
lines have some.
"""

from collections.abc import Iterator

from ..manifest.entries import Entry, State

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


def reasons(entry: Entry) -> tuple[tuple[int, str], ...]:
    """Why somebody should check the line, the most urgent reason first, each with its weight."""
    return tuple(sorted(_reasons(entry), reverse=True))


def attention(entry: Entry) -> int:
    """How urgently somebody should check the line; 0 is not at all."""
    return sum(weight for weight, _reason in _reasons(entry))


def _reasons(entry: Entry) -> Iterator[tuple[int, str]]:
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

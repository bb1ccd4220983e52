"""Strips as a director's notes (docs/directing.md), so that a line is performed again around them.

A strip that was moved, or is marked to be kept, is a moment with what an audience reads in it, its stroke on the word
that is spoken then; where one was muted, its part of the body does nothing over its words.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from .behaviors import Behavior

KEPT = 3
"""The importance of a note: the line fails without it."""

_NOTHING = {
    "gesture": ("hands",),
    "head": ("nod", "shake", "tilt", "toss", "turn"),
    "posture": ("lean_in", "lean_back"),
    "face": ("brows_up", "frown", "smile", "sad", "squint", "wide_eyes", "lips_pressed", "disgust"),
    "gaze": ("away", "up", "down", "target"),
}
"""All that a part of the body can do, by the words that notes have for it."""
_CHANNELS = {"gesture": "gesture", "head": "head", "posture": "head", "face": "face", "gaze": "gaze"}


def notes(
    kept: Sequence[tuple[Behavior, float]], muted: Sequence[Behavior], words: Sequence[Mapping[str, Any]]
) -> dict[str, Any]:
    """Notes for what is kept, each with how much later it is, and what is muted; `words` are those of the trace.

    Behaviours in which an audience reads nothing that the notes have a word for (blinks, looks around) are left out.
    """
    moments = [note for behavior, shift_s in kept if (note := _moment(behavior, shift_s, words))]
    avoid = [
        {
            "first": behavior.first,
            "last": behavior.last,
            "what": list(_NOTHING[behavior.kind]),
            "why": f"{behavior.lexeme.lower()}, muted in Blender",
        }
        for behavior in muted
        if behavior.kind in _NOTHING and behavior.families and behavior.first is not None
    ]
    return {"moments": moments, "avoid": avoid}


def _moment(behavior: Behavior, shift_s: float, words: Sequence[Mapping[str, Any]]) -> dict[str, Any] | None:
    channel = _CHANNELS.get(behavior.kind)
    if channel is None or not behavior.families or behavior.first is None or behavior.last is None:
        return None
    was, now = _word_at(behavior.stroke_s, words), _word_at(behavior.stroke_s + shift_s, words)
    if was is None or now is None:
        return None
    moved, final = now - was, len(words) - 1
    first, last = (min(max(word + moved, 0), final) for word in (behavior.first, behavior.last))
    return {
        "first": min(first, now),
        "last": max(last, now),
        "stroke": now,
        "importance": KEPT,
        "idea": f"{behavior.lexeme.lower()}, kept in Blender",
        channel: [behavior.families[0]],
    }


def _word_at(time_s: float, words: Sequence[Mapping[str, Any]]) -> int | None:
    """The word that is spoken at a time, else the nearest."""
    timed = [word for word in words if "start_s" in word]
    if not timed:
        return None
    nearest = min(timed, key=lambda word: max(word["start_s"] - time_s, time_s - word["end_s"], 0.0))
    return int(nearest["index"])

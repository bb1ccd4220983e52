"""An artist's notes on a line: strips that were moved, made longer, locked or muted, as edits (docs/edits.md).

A note says what is meant by the word that a behaviour goes with and by what it shows, so that it holds for every take:
each is sent with the line whenever it is performed again, until it is cleared. A note has a number for life; in the
edits that are sent it has a place, by which a take says which behaviours it made.
"""

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .behaviors import Behavior

Json = dict[str, Any]
_LEADING = ("stroke", "ready", "start")
"""The first of these points that a behaviour has takes the others with it."""
_WITHOUT_AMOUNT = {"posture", "gaze"}
_HANDS = {"left", "right", "both"}


@dataclass(frozen=True, slots=True)
class Note:
    """A note: its number, what it asks for as an edit, what it is called, and when what it places should be fully seen,
    seconds of the recording (None: it places nothing)."""

    number: int
    edit: Json
    label: str
    wanted_s: float | None = None

    def to_json(self) -> str:
        return json.dumps({"number": self.number, "edit": self.edit, "label": self.label, "wanted_s": self.wanted_s})

    @classmethod
    def from_json(cls, text: str) -> "Note":
        return cls(**json.loads(text))


@dataclass(frozen=True, slots=True)
class Done:
    """What was done to a behaviour's strip: moved by `shift_s`, its end by `longer_s` more, muted or deleted, or locked
    as it is."""

    behavior: Behavior
    shift_s: float = 0.0
    longer_s: float = 0.0
    omitted: bool = False


def with_done(
    notes: Sequence[Note], done: Iterable[Done], trace: Mapping[str, Any], sent: Sequence[int]
) -> tuple[Note, ...]:
    """The notes with what was done since; `trace` is the record of the take, and `sent` are the numbers of the notes
    that it was performed with, in their order.

    What was done to a behaviour again takes the place of its note. Behaviours without a word cannot be noted.
    """
    kept = {note.number: note for note in notes}
    for each in done:
        of = _reference(each.behavior, trace)
        if of is None:
            continue
        known = _note_of(each.behavior, of, kept, sent)
        number = known.number if known else max(kept, default=0) + 1
        kept[number] = _note(number, each, known.edit if known else {"of": of}, trace)
    return tuple(kept.values())


def note_on(behavior: Behavior, notes: Sequence[Note], trace: Mapping[str, Any], sent: Sequence[int]) -> Note | None:
    """The note of a behaviour of a take, if it has one; arguments as for `with_done`."""
    of = _reference(behavior, trace)
    return None if of is None else _note_of(behavior, of, {note.number: note for note in notes}, sent)


def edits_of(notes: Sequence[Note]) -> Json | None:
    """The notes as a file of edits, in their order; None where there are none."""
    return {"version": 1, "behaviors": [note.edit for note in notes]} if notes else None


def made_by(note: Note, behaviors: Iterable[Behavior], sent: Sequence[int]) -> Behavior | None:
    """The behaviour of a take that a note made or moved."""
    place = sent.index(note.number) if note.number in sent else -1
    return next((each for each in behaviors if each.edit == place), None)


def landed(note: Note, behavior: Behavior | None, at_least_s: float) -> str:
    """What to say where a behaviour is not played when its note wants it, by `at_least_s` or more; else nothing."""
    if note.wanted_s is None or behavior is None:
        return ""
    off_s = behavior.stroke_s - note.wanted_s
    if abs(off_s) < at_least_s:
        return ""
    why = "; ".join(behavior.decisions) or behavior.reason or "there is no room for it where it was put"
    late = "later" if off_s > 0 else "earlier"
    return f"{behavior.label} is fully seen {abs(off_s):.2f} s {late} than its strip was put: {why}"


def in_words(warning: str, notes: Sequence[Note]) -> str:
    """A warning about the edits that were sent, with the names of the notes in the place of their numbers."""
    for place, note in reversed(list(enumerate(notes))):
        warning = warning.replace(f"behaviors[{place}]", note.label)
    return warning


def _note_of(behavior: Behavior, of: Mapping[str, Any], kept: Mapping[int, Note], sent: Sequence[int]) -> Note | None:
    """The note of a behaviour: the one that made it in this take, or one that means the same."""
    if behavior.edit is not None and behavior.edit < len(sent) and sent[behavior.edit] in kept:
        return kept[sent[behavior.edit]]
    return next((note for note in kept.values() if note.edit["of"] == of), None)


def _note(number: int, done: Done, before: Json, trace: Mapping[str, Any]) -> Note:
    behavior = done.behavior
    about = f"{behavior.label}, “{behavior.words}”"
    if done.omitted:
        return Note(number, {"of": before["of"], "omit": "muted"}, f"{about}: muted")
    marks = dict(before.get("marks", {}))
    point = next(name for name in _LEADING if name in behavior.points_s)
    wanted_s = behavior.points_s[point] + done.shift_s
    marks[point] = _place(wanted_s, trace["words"])
    if done.longer_s or "end" in marks:
        marks["end"] = _place(behavior.end_s + done.shift_s + done.longer_s, trace["words"])
    edit = {"of": before["of"], **_as_made(behavior, trace), "marks": marks, "lock": True}
    is_moved = done.shift_s or done.longer_s or "marks" in before
    what = f"moved to {wanted_s:.2f} s" if is_moved else "locked"
    return Note(number, edit, f"{about}: {what}", wanted_s)


def _as_made(behavior: Behavior, trace: Mapping[str, Any]) -> Json:
    """What keeps the behaviour itself, whatever another take would make in its place."""
    told = _told(behavior, trace)
    found: Json = {"lexeme": behavior.lexeme}
    if behavior.kind == "gesture" and told.get("hand") in _HANDS:
        found["hand"] = told["hand"]
    if behavior.kind not in _WITHOUT_AMOUNT and told.get("amount") is not None:
        found["amount"] = told["amount"]
    if behavior.kind == "gaze" and told.get("direction"):
        found["direction"] = told["direction"]
    return found


def _reference(behavior: Behavior, trace: Mapping[str, Any]) -> Json | None:
    """How edits name a behaviour: by its channel, the first of its words, and what it shows."""
    told, words = _told(behavior, trace), trace.get("words", ())
    if behavior.first is None or behavior.first >= len(words) or not told:
        return None
    word = words[behavior.first]
    functions = {each["id"]: each["class"] for each in trace.get("functions", ())}
    named = {
        "function": functions.get(told.get("function") or ""),
        "family": behavior.families[0] if behavior.families else None,
        "lexeme": behavior.lexeme,
    }
    start_s = told["sync"].get("start", 0.0) - word.get("start_s", 0.0)
    return {
        "channel": behavior.kind,
        "at": {"word": behavior.first, "text": word["text"]},
        **{name: value for name, value in named.items() if value},
        "offset_s": round(start_s, 3),
    }


def _told(behavior: Behavior, trace: Mapping[str, Any]) -> Mapping[str, Any]:
    return next((each for each in trace.get("behaviors", ()) if each["id"] == behavior.id and each["kept"]), {})


def _place(time_s: float, words: Sequence[Mapping[str, Any]]) -> Json:
    """A moment, from the nearest edge of a word, so that it goes with the word."""
    edges = [(word, edge) for word in words for edge in ("start", "end") if f"{edge}_s" in word]
    if not edges:
        return {"at": {"word": 0}, "offset_s": round(time_s, 3)}
    word, edge = min(edges, key=lambda each: abs(each[0][f"{each[1]}_s"] - time_s))
    at = {"word": word["index"], "text": word["text"]}
    return {"at": at, "edge": edge, "offset_s": round(time_s - word[f"{edge}_s"], 3)}

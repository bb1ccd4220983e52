"""The speech of a BML document and the positions of its sync marks.

A mark precedes the word that follows it: mark `w3` of "I <sync id='w1'/>have …" is the time at which "have" begins.
SmartBody's marks, `sync` of its text or `mark` of its speech, may state their time; those of the core get theirs from
the recording.

The sync marks of the speech, and times relative to them.

Every word has a mark at its start. With `TimeForm.SYNC` all points of a behaviour refer to one mark, that of the word
in which its stroke (or else its start) falls: wherever a realizer's speech places the word, the phases keep their
durations, and the stroke its word. Points before the first word refer to the start of the speech. Nothing resolves
below `FIRST_MOMENT_S`: strict realizers drop a behaviour that begins before 0, as a sum of decimals may by a rounding
error (.35 + .25 − .6 is −5.6e-17).
"""

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType

from ...model import SyncPoints, Word
from ...model.formats import TimeForm
from .documents import Document, Element, Reference, Time

_NAMES: Mapping[str, str] = MappingProxyType({"sync": "id", "mark": "name"})
"""The marks of a text, and the attribute that names them."""


@dataclass(frozen=True, slots=True)
class Speech:
    """The first speech of a document: its text, its start and end as stated, in `marks` the number of words before each
    mark, and in `mark_times_s` the stated times of marks, in seconds from the start of the speech."""

    id: str
    text: str
    start: Time | None
    end: Time | None
    marks: Mapping[str, int]
    mark_times_s: Mapping[str, float]


def block_of(document: Document) -> Element:
    """The document's first block."""
    return next((part for part in document.root.children if part.name == "bml"), document.root)


def behaviors_of(document: Document) -> Iterator[Element]:
    """The behaviours and constraints of the document's block, including those in `required`."""
    for part in block_of(document).children:
        if part.name == "required":
            yield from part.children
        else:
            yield part


def speech_of(document: Document) -> Speech | None:
    """The document's first speech, or None."""
    found = next((element for element in behaviors_of(document) if element.name == "speech"), None)
    return None if found is None else _speech(found)


def mark_s(mark: str, speech: Speech, words: tuple[Word, ...]) -> float | None:
    """The time of a mark in seconds from the start of the speech; None if unknown."""
    if mark in speech.mark_times_s:
        return speech.mark_times_s[mark]
    if mark not in speech.marks:
        return None
    timed = [word for word in words if word.interval]
    for word in timed:
        if word.interval and word.index >= speech.marks[mark]:
            return word.interval.start_s
    last = timed[-1].interval if timed else None
    return last.end_s if last else None


def _speech(element: Element) -> Speech:
    text, marks, times_s = "", {}, {}
    whole = next((part for part in element.children if part.name == "text"), element)
    for part in whole.content:
        if isinstance(part, str):
            text += part
            continue
        name, time_s = part.attributes.get(_NAMES.get(part.name, "")), part.attributes.get("time")
        if isinstance(name, str):
            marks[name] = len(text.split())
            if isinstance(time_s, float):
                times_s[name] = time_s
    start, end = (element.attributes.get(name) for name in ("start", "end"))
    return Speech(
        id=element.id or "speech",
        text=" ".join(text.split()),
        start=None if isinstance(start, str) else start,
        end=None if isinstance(end, str) else end,
        marks=MappingProxyType(marks),
        mark_times_s=MappingProxyType(times_s),
    )


SPEECH = "speech1"
"""The id of the speech behaviour."""

FIRST_MOMENT_S = 0.001
"""The earliest time that a point relative to a mark resolves to."""

TimeFormatter = Callable[[SyncPoints], dict[str, Time]]
"""Expresses the sync points that are set, by name, in order."""


def time_formatter(
    words: tuple[Word, ...], timing: TimeForm, mark: Callable[[int], str], *, speech_start_s: float = 0.0
) -> TimeFormatter:
    """The function that expresses times in a document; `mark` gives the id of the mark before the word with an
    index."""
    if timing is TimeForm.ABSOLUTE:
        return _absolute
    starts = [(to_milli(speech_start_s), "start")]
    starts += [(to_milli(word.interval.start_s), mark(word.index)) for word in words if word.interval]
    return partial(_from_mark, starts)


def to_milli(number: float) -> float:
    """The number rounded to three decimals; never -0.0."""
    return round(number, 3) + 0.0


def _absolute(sync: SyncPoints) -> dict[str, Time]:
    return {name: to_milli(time_s) for name, time_s in sync.in_order()}


def _from_mark(starts: list[tuple[float, str]], sync: SyncPoints) -> dict[str, Time]:
    anchor_s = to_milli(sync.start if sync.stroke is None else sync.stroke)
    mark_s, mark = starts[max(bisect_right(starts, anchor_s, key=lambda start: start[0]) - 1, 0)]
    points_s = {name: max(FIRST_MOMENT_S, to_milli(time_s)) for name, time_s in sync.in_order()}
    return {name: Reference(SPEECH, mark, to_milli(point_s - mark_s)) for name, point_s in points_s.items()}

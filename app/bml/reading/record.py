"""Reads the record that our writer puts into the description of a speech (`understudy.bml.writing.blocks`).

Behaviours that were added by hand have no record, and records of deleted behaviours are ignored. If the words of the
speech have changed since, their times are not known.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from math import inf
from types import MappingProxyType

from ...model import Behavior, Channel, Interval, Level, Manner, Notice, Phone, SyncPoints, Word
from ..markup.documents import Document, Element, Value
from ..markup.elements import RECORD_TYPE
from ..markup.speech import FIRST_MOMENT_S, behaviors_of, speech_of
from ..markup.values import read_slots


@dataclass(frozen=True, slots=True)
class Record:
    """What a file says about its performance beyond the core; times are seconds from the start of the recording."""

    words: tuple[Word, ...]
    duration_s: float | None
    agitation: Level | None
    stillness: float
    seed: int | None
    notices: tuple[Notice, ...]
    behaviors: Mapping[str, Element]

    def completed(self, behavior: Behavior) -> Behavior:
        """The behaviour with what its own element cannot express."""
        own = self.behaviors.get(behavior.id)
        if own is None:
            return behavior
        found = own.attributes
        gesture = behavior.kind is Channel.GESTURE
        return replace(
            behavior,
            sync=_from_the_first_moment(behavior.sync, _text(found, "phases") or ""),
            priority=_number(found, "priority") or 0.0,
            first=_count(found, "first") or 0,
            last=_count(found, "last") or 0,
            amount=_number(found, "amount") if gesture else behavior.amount,
            target=behavior.target or (_text(found, "target") if gesture else None),
            after_strokes_s=_times_s(found, "afterStrokes") if gesture else None,
            curved=gesture and "path" in found,
            manner=_manner(found) if gesture else None,
            slots=read_slots(_text(found, "slots") or "") if gesture else None,
            rule=_text(found, "rule"),
            function=_text(found, "function"),
            moment=_text(found, "moment"),
            reason=_text(found, "reason"),
        )

    def is_as_scheduled(self, behavior: Behavior) -> bool:
        """Whether the behaviour is recorded, and is no gesture whose end was moved by hand."""
        own = self.behaviors.get(behavior.id)
        if own is None or behavior.kind is not Channel.GESTURE:
            return own is not None
        lasting_s = (_text(own.attributes, "phases") or "").split()
        relax_s = behavior.sync.end if behavior.sync.relax is None else behavior.sync.relax
        return not lasting_s or abs(float(lasting_s[-1]) - (behavior.sync.end - relax_s)) <= 2 * FIRST_MOMENT_S


def _from_the_first_moment(sync: SyncPoints, phases: str) -> SyncPoints:
    """The points as scheduled: those at 0 are written at `FIRST_MOMENT_S` where times are relative to marks."""
    lasting_s = sum(float(length) for length in phases.split())
    if sync.start != FIRST_MOMENT_S or round(sync.end - lasting_s, 3) != 0:
        return sync
    return replace(sync, **{name: 0.0 for name, time_s in sync.in_order() if time_s == FIRST_MOMENT_S})


def read_record(document: Document) -> Record | None:
    """The record of a document, if it has one."""
    found = next((each for each in behaviors_of(document) if each.name == "speech"), None)
    descriptions = (part for part in found.children if part.attributes.get("type") == RECORD_TYPE) if found else ()
    performance = next((part for each in descriptions for part in each.children if part.name == "performance"), None)
    if performance is None:
        return None
    level = _text(performance.attributes, "agitation")
    parts = list(performance.children)
    return Record(
        words=tuple(_words(document, [part for part in parts if part.name == "word"])),
        duration_s=_number(performance.attributes, "duration"),
        agitation=Level(level) if level else None,
        stillness=_number(performance.attributes, "stillness") or 0.0,
        seed=_count(performance.attributes, "seed"),
        notices=tuple(_notice(part.attributes) for part in parts if part.name == "notice"),
        behaviors=MappingProxyType(
            {str(part.attributes.get("ref")): part for part in parts if part.name == "behavior"}
        ),
    )


def _words(document: Document, recorded: list[Element]) -> Iterator[Word]:
    speech = speech_of(document)
    texts = speech.text.split() if speech else []
    if len(texts) == len(recorded):
        for index, (text, element) in enumerate(zip(texts, recorded, strict=True)):
            yield _word(index, text, element.attributes)


def _word(index: int, text: str, found: Mapping[str, Value]) -> Word:
    start_s, end_s = _number(found, "start"), _number(found, "end")
    return Word(
        index=index,
        text=text,
        interval=None if start_s is None or end_s is None else Interval(start_s, end_s),
        phones=tuple(_phones(_text(found, "phones") or "")),
        stressed_ratio=_number(found, "stressedRatio"),
        prominence=_number(found, "prominence"),
        emphasis=_number(found, "emphasis"),
        focus=_number(found, "focus"),
        spread="spread" in found,
    )


def _phones(text: str) -> Iterator[Phone]:
    parts = text.split()
    for name, start_s, end_s in zip(parts[::3], parts[1::3], parts[2::3], strict=True):
        label = name.rstrip("0123456789")
        yield Phone(label, Interval(float(start_s), float(end_s)), int(name[len(label) :]) if name != label else None)


def _notice(found: Mapping[str, Value]) -> Notice:
    return Notice(_text(found, "code") or "", _text(found, "message") or "")


def _number(found: Mapping[str, Value], name: str) -> float | None:
    value = found.get(name)
    return float(value) if isinstance(value, int | float) else None


def _times_s(found: Mapping[str, Value], name: str) -> tuple[float, ...] | None:
    """The times of a list; 0 stands for an empty one."""
    value = _text(found, name)
    return None if value is None else tuple(float(part) for part in value.split() if float(part) > 0)


def _manner(found: Mapping[str, Value]) -> Manner | None:
    """The amplitude, speed and tension in the record, if they are three positive numbers."""
    words = (_text(found, "manner") or "").split()
    try:
        numbers = [float(part) for part in words]
    except ValueError:
        return None
    return Manner(*numbers) if len(numbers) == len(fields(Manner)) and all(0 < each < inf for each in numbers) else None


def _count(found: Mapping[str, Value], name: str) -> int | None:
    value = found.get(name)
    return value if isinstance(value, int) else None


def _text(found: Mapping[str, Value], name: str) -> str | None:
    value = found.get(name)
    return value if isinstance(value, str) else None

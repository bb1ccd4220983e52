"""The record of a performance in the description of its speech: what our realizer needs and the core cannot express.

With it, `realize` of our own BML gives the same result as `perform --realize`, byte for byte. It contains only what the
rest of the file does not, so that somebody who edits the file finds everything in one place: the word times, and for
each behaviour its function, priority, gesture size, reason, and the durations of its phases as scheduled, from which
the reader detects points moved by hand. Times are seconds from the start of the recording, not rounded.
"""

from collections.abc import Iterator
from itertools import pairwise

from ...model import Behavior, Channel, Performance, Phone, Target, Word
from ...model.lead_in import later_s, later_word
from ..markup.documents import Element, Value
from ..markup.elements import OURS, RECORD_TYPE
from ..markup.marks import to_milli
from ..markup.slots import written_slots
from ..markup.values import text_of


def record(performance: Performance) -> Element:
    """The description with the record."""
    utterance = performance.utterance
    attributes: dict[str, Value] = {
        "agitation": utterance.level.value,
        "stillness": float(performance.stillness),
        "seed": performance.seed,
    }
    if utterance.duration_s is not None:
        attributes["duration"] = later_s(utterance.duration_s, -utterance.lead_in_s)
    content = (
        *(_word(later_word(word, -utterance.lead_in_s)) for word in utterance.words),
        *(_pawn(target) for target in performance.targets),
        *(_behavior(behavior) for behavior in performance.behaviors if behavior.kept),
        *(Element("notice", {"code": each.code, "message": each.message}) for each in performance.notices),
    )
    return Element("description", {"priority": 1, "type": RECORD_TYPE}, (Element("performance", attributes, content),))


def _pawn(target: Target) -> Element:
    place = dict(zip("xyz", target.position_m, strict=True))
    return Element(f"{{{OURS}}}pawn", {"name": target.name, **place})


def _word(word: Word) -> Element:
    return Element("word", dict(_of_word(word)))


def _of_word(word: Word) -> Iterator[tuple[str, Value]]:
    if word.interval:
        yield "start", float(word.interval.start_s)
        yield "end", float(word.interval.end_s)
    measures = (
        ("emphasis", word.emphasis),
        ("focus", word.focus),
        ("prominence", word.prominence),
        ("stressedRatio", word.stressed_ratio),
    )
    yield from ((name, float(measure)) for name, measure in measures if measure is not None)
    if word.spread:
        yield "spread", "true"
    if word.phones:
        yield "phones", " ".join(map(_phone, word.phones))


def _phone(phone: Phone) -> str:
    stress = "" if phone.stress is None else str(phone.stress)
    times = text_of(float(phone.interval.start_s)), text_of(float(phone.interval.end_s))
    return " ".join((f"{phone.label}{stress}", *times))


def _behavior(behavior: Behavior) -> Element:
    return Element("behavior", dict(_of_behavior(behavior)))


def _of_behavior(behavior: Behavior) -> Iterator[tuple[str, Value]]:
    yield "ref", behavior.id
    yield "priority", float(behavior.priority)
    yield "first", behavior.first
    yield "last", behavior.last
    if behavior.kind is Channel.GESTURE:
        if behavior.amount is not None:
            yield "amount", behavior.amount
        if behavior.target is not None:
            yield "target", behavior.target
        if behavior.after_strokes_s is not None:
            yield "afterStrokes", " ".join(map(text_of, behavior.after_strokes_s or (0.0,)))
        if behavior.curved:
            yield "path", "curved"
        if behavior.manner is not None:
            manner = behavior.manner
            yield "manner", " ".join(map(text_of, (manner.amplitude, manner.speed, manner.tension)))
        if behavior.slots is not None:
            yield "slots", written_slots(behavior.slots)
    times_s = [time_s for _name, time_s in behavior.sync.in_order()]
    yield "phases", " ".join(text_of(to_milli(end_s - start_s)) for start_s, end_s in pairwise(times_s))
    why = {"rule": behavior.rule, "function": behavior.function, "moment": behavior.moment, "reason": behavior.reason}
    yield from ((name, value) for name, value in why.items() if value)

"""Constraints of a BML block: points that coincide, and points that precede others.

A `synchronize` determines those of its points that have no time otherwise. `before` and `after` move nothing:
violations are reported.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from ...model import Notice
from ..markup.documents import Document, Element, Reference, Time, Value
from ..markup.speech import behaviors_of
from ..markup.values import text_of
from .phase_completion import Points, StatedPoints


def synchronized(stated: Sequence[StatedPoints], document: Document) -> list[StatedPoints]:
    """The behaviours with points of each `synchronize` set to the first of them that has a time, or to the first."""
    by_id = {each.id: each for each in stated}
    for constraint in behaviors_of(document):
        for tie in constraint.children if constraint.name == "constraint" else ():
            if tie.name == "synchronize":
                _tie([ref for ref in _refs(tie) if isinstance(ref, Reference)], by_id)
    return list(by_id.values())


def _tie(refs: list[Reference], by_id: dict[str, StatedPoints]) -> None:
    """Express the points of `refs` that have no time relative to one of them; there may be none."""
    if not refs:
        return
    told = [ref for ref in refs if ref.behavior not in by_id or ref.point in by_id[ref.behavior].times]
    anchor = (told or refs)[0]
    for ref in refs:
        each = by_id.get(ref.behavior)
        if ref is not anchor and each and ref.point in each.names and ref.point not in each.times:
            time = replace(anchor, offset_s=anchor.offset_s - ref.offset_s)
            by_id[each.id] = replace(each, times={**each.times, ref.point: time})


def _refs(element: Element) -> list[Time]:
    found = (part.attributes.get("ref") for part in element.children if part.name == "sync")
    return [ref for ref in found if isinstance(ref, float | Reference)]


def violated_constraints(document: Document, points: Mapping[str, Points]) -> Iterator[Notice]:
    """Notices about `before` and `after` constraints that the times violate."""
    for constraint in behaviors_of(document):
        for offer in constraint.children if constraint.name == "constraint" else ():
            at_s = _time_s(offer.attributes.get("ref"), points)
            if offer.name not in ("before", "after") or at_s is None:
                continue
            sign = 1 if offer.name == "after" else -1
            for ref in _refs(offer):
                time_s = _time_s(ref, points)
                if time_s is not None and sign * (time_s - at_s) < 0:
                    message = f"{text_of(ref)} comes at {time_s:.3f} s, which is not {offer.name} {at_s:.3f} s as asked"
                    yield Notice("bml_constraint_missed", message)


def _time_s(time: Value | None, points: Mapping[str, Points]) -> float | None:
    if isinstance(time, Reference):
        at_s = points.get(time.behavior, {}).get(time.point)
        return None if at_s is None else at_s + time.offset_s
    return float(time) if isinstance(time, int | float) else None

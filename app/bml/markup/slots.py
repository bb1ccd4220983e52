"""Slots as text in our own namespace: `height=child height_m=0.95 side=left`, in the order of `Slots`.

Anything that is not a slot or one of its values is left out in reading: a file may be edited by hand, and a gesture
without a slot is still a gesture.
"""

from dataclasses import fields
from enum import StrEnum
from math import isfinite
from typing import TypeVar

from ...model.slots import Distance, Height, Side, Size, Slots, Which
from .values import text_of

_Class = TypeVar("_Class", bound=StrEnum)


def written_slots(slots: Slots) -> str:
    """The slots that are filled, as text."""
    filled = ((each.name, getattr(slots, each.name)) for each in fields(slots))
    return " ".join(f"{name}={text_of(value)}" for name, value in filled if value is not None)


def read_slots(text: str) -> Slots | None:
    """The slots in a text; None if there are none."""
    told = dict(part.partition("=")[::2] for part in text.split())
    slots = Slots(
        height=_of(Height, told.get("height")),
        height_m=_number(told.get("height_m")),
        size=_of(Size, told.get("size")),
        size_m=_number(told.get("size_m")),
        count=_count(told.get("count")),
        side=_of(Side, told.get("side")),
        distance=_of(Distance, told.get("distance")),
        elevation_deg=_number(told.get("elevation_deg")),
        which=_of(Which, told.get("which")),
        referent=told.get("referent") or None,
        listener=told.get("listener") or None,
    )
    return slots or None


def _of(kind: type[_Class], told: str | None) -> _Class | None:
    return next((each for each in kind if each.value == told), None)


def _count(told: str | None) -> int | None:
    return int(told) if told and told.isascii() and told.isdigit() and len(told) < 3 else None


def _number(told: str | None) -> float | None:
    try:
        number = float(told or "nan")
    except ValueError:
        return None
    return number if isfinite(number) else None

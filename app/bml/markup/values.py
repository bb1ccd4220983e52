"""Converts between attribute values and text; the slots of a gesture are text in our own namespace: `height=child
height_m=0.95 side=left`, in the order of `Slots`.
"""

import re
from collections.abc import Mapping
from dataclasses import fields
from decimal import Decimal
from enum import StrEnum
from functools import lru_cache
from math import isfinite
from typing import TypeVar

from ...model.slots import Distance, Height, Side, Size, Slots, Which
from .documents import Reference, Value
from .elements import Attribute, ValueKind

PLACES = 3

_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)", re.ASCII)
_DECIMAL = r"\d+(?:\.\d*)?"
_PHONE = rf"[A-Z]+\d? {_DECIMAL} {_DECIMAL}"
_TEXTS: Mapping[ValueKind, re.Pattern[str]] = {
    ValueKind.TEXT: re.compile(".*"),
    ValueKind.ID: re.compile(r"[A-Za-z][A-Za-z0-9_.]*"),
    ValueKind.PHONES: re.compile(rf"{_PHONE}(?: {_PHONE})*", re.ASCII),
    ValueKind.DURATIONS: re.compile(rf"{_DECIMAL}(?: {_DECIMAL})*", re.ASCII),
}
_WHOLES: Mapping[ValueKind, re.Pattern[str]] = {
    ValueKind.COUNT: re.compile(r"\d{1,9}", re.ASCII),
    ValueKind.WHOLE: re.compile(r"-?\d{1,19}", re.ASCII),
}
_REFERENCE = re.compile(
    r"(?:(?P<block>[A-Za-z_][\w.-]*):)?(?P<behavior>[A-Za-z_][\w.-]*):(?P<point>[A-Za-z_][\w.-]*?)"
    r"(?:\s*(?P<sign>[+-])\s*(?P<offset>\d+(?:\.\d*)?|\.\d+))?",
    re.ASCII,
)


def value_of(text: str, attribute: Attribute) -> Value:
    """The value that `text` represents. Raises ValueError, with the reason, if it is invalid for `attribute`."""
    text = " ".join(text.split())
    if not text:
        raise ValueError("is empty; leave it out")
    if (
        attribute.one_of
        and text not in attribute.one_of
        and not (attribute.beyond and attribute.beyond.fullmatch(text))
    ):
        raise ValueError(f"is not one of {', '.join(sorted(attribute.one_of))}")
    try:
        return _value(text, attribute.kind)
    except ValueError:
        raise ValueError(f"is not {attribute.kind}") from None


def text_of(value: Value) -> str:
    """The text that represents `value`."""
    if isinstance(value, str):
        return value
    if isinstance(value, float):
        return _fixed(value)
    if isinstance(value, Reference):
        block = f"{value.block}:" if value.block else ""
        offset = f"{'-' if value.offset_s < 0 else '+'}{_fixed(abs(value.offset_s))}" if value.offset_s else ""
        return f"{block}{value.behavior}:{value.point}{offset}"
    return str(value)


def _value(text: str, kind: ValueKind) -> Value:
    match kind:
        case ValueKind.TEXT | ValueKind.ID | ValueKind.PHONES | ValueKind.DURATIONS:
            return _matching(_TEXTS[kind], text)
        case ValueKind.COUNT | ValueKind.WHOLE:
            return int(_matching(_WHOLES[kind], text))
        case ValueKind.NUMBER:
            return _number(text)
        case ValueKind.SHARE:
            return _share(_number(text))
        case ValueKind.TIME:
            return _number(text) if _NUMBER.fullmatch(text) else _reference(text)


def _matching(pattern: re.Pattern[str], text: str) -> str:
    if not pattern.fullmatch(text):
        raise ValueError(text)
    return text


def _number(text: str) -> float:
    number = float(_matching(_NUMBER, text))
    if not isfinite(number):
        raise ValueError(text)
    return number + 0.0  # turns -0.0 into 0.0


def _share(number: float) -> float:
    if not 0 <= number <= 1:
        raise ValueError(number)
    return number


def _reference(text: str) -> Reference:
    found = _REFERENCE.fullmatch(text)
    if found is None:
        raise ValueError(text)
    offset_s = _number(f"{found['sign']}{found['offset']}") if found["offset"] else 0.0
    return Reference(found["behavior"], found["point"], offset_s, found["block"])


@lru_cache(maxsize=4096)
def _fixed(number: float) -> str:
    """Cached, because the times of phones, shapes and words are the same."""
    short = f"{number:.{PLACES}f}"
    return short if float(short) == number else f"{Decimal(repr(number)):f}"


_Class = TypeVar("_Class", bound=StrEnum)


def written_slots(slots: Slots) -> str:
    """The slots that are filled, as text."""
    filled = ((each.name, getattr(slots, each.name)) for each in fields(slots))
    return " ".join(f"{name}={text_of(value)}" for name, value in filled if value is not None)


def read_slots(text: str) -> Slots | None:
    """The slots in a text; None if there are none."""
    parts = dict(part.partition("=")[::2] for part in text.split())
    slots = Slots(
        height=_of(Height, parts.get("height")),
        height_m=_number_or_none(parts.get("height_m")),
        size=_of(Size, parts.get("size")),
        size_m=_number_or_none(parts.get("size_m")),
        count=_count(parts.get("count")),
        side=_of(Side, parts.get("side")),
        distance=_of(Distance, parts.get("distance")),
        elevation_deg=_number_or_none(parts.get("elevation_deg")),
        which=_of(Which, parts.get("which")),
        referent=parts.get("referent") or None,
        listener=parts.get("listener") or None,
    )
    return slots or None


def _of(kind: type[_Class], text: str | None) -> _Class | None:
    return next((each for each in kind if each.value == text), None)


def _count(text: str | None) -> int | None:
    return int(text) if text and text.isascii() and text.isdigit() and len(text) < 3 else None


def _number_or_none(text: str | None) -> float | None:
    try:
        number = float(text or "nan")
    except ValueError:
        return None
    return number if isfinite(number) else None

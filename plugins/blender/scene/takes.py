"""The takes of a performance: one is on the armature, the others are stored with their actions."""

import json
from typing import Any

import bpy

from .layers import lay_again, put_aside

_SHARED = ("bml", "trace", "behaviors", "order")


class NoTakeError(ValueError):
    """A take that a performance does not have."""


def shown_take(record: Any) -> Any:
    """The take that is on the armature; made from the record where a file was saved without takes."""
    if not record.takes:
        _copied(record, _added(record))
    return record.takes[min(record.active_take, len(record.takes) - 1)]


def begin_take(armature: Any, record: Any) -> None:
    """Puts the take that is shown aside and begins another."""
    put_aside(armature, record.name, shown_take(record).strips)
    _added(record)
    _choose(record, len(record.takes) - 1)


def show_take(armature: Any, record: Any, number: int) -> None:
    """Lays another take in the place of the one that is shown. Raises NoTakeError."""
    shown = shown_take(record)
    if not 0 <= number < len(record.takes):
        raise NoTakeError(f"{record.name} has {len(record.takes)} takes")
    if record.takes[number] == shown:
        return
    put_aside(armature, record.name, shown.strips)
    _choose(record, number)
    chosen = record.takes[number]
    lay_again(armature, chosen.strips)
    _copied(chosen, record)


def keep_in_take(record: Any) -> None:
    """Has the take that is shown say what the record says now."""
    _copied(record, shown_take(record))


def remove_take(record: Any, number: int) -> None:
    """Forgets a take that is not shown, with its actions and texts. Raises NoTakeError."""
    if number == record.active_take or not 0 <= number < len(record.takes):
        raise NoTakeError("the take that is shown cannot be removed: show another first")
    forget_take(record.takes[number])
    record.takes.remove(number)
    _choose(record, record.active_take - (number < record.active_take))


def forget_take(take: Any) -> None:
    """Removes a take's texts, and the actions of one that is not shown."""
    for entry in take.strips:
        if entry.action is not None:
            bpy.data.actions.remove(entry.action)
    for text in (take.bml, take.trace):
        if text:
            bpy.data.texts.remove(text)


def next_seed(record: Any) -> int:
    """A seed with which no take was performed yet."""
    shown_take(record)
    return 1 + max(_seed(take) for take in record.takes)


def _choose(record: Any, number: int) -> None:
    """The take that is shown, and the row of the list that is lit."""
    record.active_take = number
    record.active_take_row = number


def _seed(take: Any) -> int:
    return int((json.loads(take.order or "{}").get("options") or {}).get("seed", 0))


def _added(record: Any) -> Any:
    """A new take, called by the lowest number that is free."""
    taken = {take.name for take in record.takes}
    name = next(name for number in range(1, len(taken) + 2) if (name := f"Take {number}") not in taken)
    take = record.takes.add()
    take.name = name
    return take


def _copied(source: Any, target: Any) -> None:
    for name in _SHARED:
        setattr(target, name, getattr(source, name))

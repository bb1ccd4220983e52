"""Stillness: how much of a schedule is left out and how small the rest is, from 0 (nothing, as it is) to 1 (all of it).

The least important goes first: what the body does by itself, then what shows functions, in order of priority, and what
an author changed last. Blinks and breath stay as they are: at 1 nothing else is left, and the realizer leaves the
body's own life out by the same measure. It takes a gesture's amount for what stillness left of that for which there is
time in the schedule.
"""

from collections.abc import Iterable
from dataclasses import replace

from ...model import Behavior, Channel, Listening, Performance

BLINK, BREATH = "BLINK", "OPEN_LIPS"

_KINDS = (Channel.EYES, Channel.GAZE, Channel.POSTURE, Channel.FACE, Channel.HEAD, Channel.GESTURE)
"""Of movements of one priority the first of these goes first."""


USUAL_AMOUNT = 0.5
"""The size of a gesture, head movement or face that says none, in BML of others."""

_SIZED = frozenset({Channel.GESTURE, Channel.HEAD, Channel.FACE})


def with_stillness(performance: Performance, stillness: float) -> Performance:
    """The performance with as much less movement of the speaker and of all who listen."""
    return replace(
        performance,
        behaviors=stilled(performance.behaviors, stillness),
        listeners=tuple(Listening(each.name, stilled(each.behaviors, stillness)) for each in performance.listeners),
        stillness=stillness,
    )


def stilled(behaviors: Iterable[Behavior], stillness: float) -> tuple[Behavior, ...]:
    """The behaviours in their order: of those that are kept the least important share `stillness` is no longer, and the
    amounts of the others are smaller by it."""
    behaviors = tuple(behaviors)
    if not stillness:
        return behaviors
    moving = sorted((each for each in behaviors if each.kept and not _is_involuntary(each)), key=_importance)
    left_out = {each.id for each in moving[: round(stillness * len(moving))]}
    smaller = {each.id for each in moving} - left_out
    return tuple(
        _left_out(each, stillness) if each.id in left_out else _smaller(each, stillness) if each.id in smaller else each
        for each in behaviors
    )


def _is_involuntary(behavior: Behavior) -> bool:
    return behavior.lexeme == BLINK or (behavior.lexeme == BREATH and behavior.function is None)


def _importance(behavior: Behavior) -> tuple[bool, bool, float, int, float, str]:
    authored, shows = behavior.edit is not None, behavior.function is not None
    return authored, shows, behavior.priority, _KINDS.index(behavior.kind), behavior.amount or 0.0, behavior.id


def _left_out(behavior: Behavior, stillness: float) -> Behavior:
    return replace(behavior, kept=False, reason=f"left out: {stillness:g} of all movements are, for stillness")


def _smaller(behavior: Behavior, stillness: float) -> Behavior:
    usual = USUAL_AMOUNT if behavior.kind in _SIZED else None
    amount = usual if behavior.amount is None else behavior.amount
    return behavior if amount is None else replace(behavior, amount=to_thousandths(amount * (1 - stillness)))


def to_thousandths(amount: float) -> float:
    """The amount as BML says it, which is exact enough for any eye."""
    return round(amount, 3)

"""Stillness removes a share of a schedule's behaviours and reduces the others, from 0 (unchanged) to 1 (all removed).

The least important behaviours are removed first: idle behaviours, then those that show functions, in order of priority,
and edited ones last. Blinks and breath are unchanged; at 1 nothing else remains. The realizer reduces the body's idle
motion by the same factor, and takes a gesture's amount as already reduced by stillness.
"""

from collections.abc import Iterable
from dataclasses import replace

from ...model import Behavior, Channel, Limit, Listening, Performance

BLINK, BREATH = "BLINK", "OPEN_LIPS"

_KINDS = (Channel.EYES, Channel.GAZE, Channel.POSTURE, Channel.FACE, Channel.HEAD, Channel.GESTURE)
"""The order of removal among behaviours of equal priority."""


USUAL_AMOUNT = 0.5
"""The default size of a gesture, head movement or facial expression, for BML from other programs."""

_SIZED = frozenset({Channel.GESTURE, Channel.HEAD, Channel.FACE})


def with_stillness(performance: Performance, stillness: float) -> Performance:
    """The performance with the movement of the speaker and of all listeners reduced by stillness."""
    return replace(
        performance,
        behaviors=stilled(performance.behaviors, stillness),
        listeners=tuple(Listening(each.name, stilled(each.behaviors, stillness)) for each in performance.listeners),
        stillness=stillness,
    )


def stilled(behaviors: Iterable[Behavior], stillness: float) -> tuple[Behavior, ...]:
    """The behaviours in order: of the kept ones the least important share `stillness` is dropped, and the amounts
    of the others are reduced by it."""
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
    reason = f"left out by stillness, which drops {stillness:.0%} of movements"
    return replace(behavior, kept=False, limit=Limit.STILLNESS, reason=reason)


def _smaller(behavior: Behavior, stillness: float) -> Behavior:
    usual = USUAL_AMOUNT if behavior.kind in _SIZED else None
    amount = usual if behavior.amount is None else behavior.amount
    return behavior if amount is None else replace(behavior, amount=to_thousandths(amount * (1 - stillness)))


def to_thousandths(amount: float) -> float:
    """The amount rounded to thousandths, the precision in BML."""
    return round(amount, 3)

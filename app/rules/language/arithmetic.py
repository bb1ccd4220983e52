"""The computations available to rules: built-in functions, the four operations, comparisons.

Numbers are ints and floats of at most 10^15 in magnitude, so that computing on one number is always bounded. Texts can
be compared with anything by `==` and `!=`, but have no order.
"""

import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import TypeAlias

from ...model import Argument

Number: TypeAlias = int | float

LARGEST = 1e15


class ComputationError(Exception):
    """A computation or comparison that is undefined for these values; the step that made it adds the place."""


@dataclass(frozen=True, slots=True)
class Builtin:
    """A numeric function that rules may call with `fewest` to `most` (None: any number of) arguments."""

    apply: Callable[[Sequence[Number]], Number]
    fewest: int
    most: int | None

    @property
    def takes(self) -> str:
        if self.most is None:
            return f"{self.fewest} or more arguments"
        return f"{self.fewest} argument{'s' if self.fewest > 1 else ''}"

    def accepts(self, count: int) -> bool:
        return count >= self.fewest and (self.most is None or count <= self.most)


def _increase_priority(priorities: Sequence[Number]) -> Number:
    """One more than the highest: the priority of a whole above its components (paper §3.3, Figure 3)."""
    return max(priorities) + 1


BUILTINS: Mapping[str, Builtin] = MappingProxyType(
    {
        "increase_priority": Builtin(_increase_priority, 1, None),
        "min": Builtin(min, 2, None),
        "max": Builtin(max, 2, None),
        "abs": Builtin(lambda numbers: abs(numbers[0]), 1, 1),
        "round": Builtin(lambda numbers: round(numbers[0]), 1, 1),
    }
)

OPERATIONS: Mapping[str, Callable[[Number, Number], Number]] = MappingProxyType(
    {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv}
)

_ORDERINGS: Mapping[str, Callable[[Number, Number], bool]] = MappingProxyType(
    {"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
)


def compare(sign: str, left: Argument, right: Argument) -> bool:
    """Whether `left sign right` holds. Raises ComputationError if a text is to be ordered."""
    if sign == "==":
        return left == right
    if sign == "!=":
        return left != right
    return _ORDERINGS[sign](_number(left, sign), _number(right, sign))


def apply_operation(sign: str, left: Argument, right: Argument) -> Number:
    """`left sign right`. Raises ComputationError for texts, division by zero and numbers beyond `LARGEST`."""
    try:
        return _bounded(OPERATIONS[sign](_number(left, sign), _number(right, sign)))
    except ZeroDivisionError:
        raise ComputationError(f"{left} / {right} divides by zero") from None


def apply_builtin(name: str, arguments: Sequence[Argument]) -> Number:
    """`name(arguments)`. Raises ComputationError for texts and numbers beyond `LARGEST`."""
    return _bounded(BUILTINS[name].apply([_number(argument, name) for argument in arguments]))


def is_ordering(sign: str) -> bool:
    return sign in _ORDERINGS


def _number(value: Argument, wanted_by: str) -> Number:
    if isinstance(value, str):
        raise ComputationError(f"`{wanted_by}` takes numbers, and {value!r} is a text")
    return value


def _bounded(number: Number) -> Number:
    if not -LARGEST <= number <= LARGEST:
        raise ComputationError(f"the result {number:g} is beyond {LARGEST:g}")
    return number

"""Targets: named points of the scene that a character looks and points at, and where its listeners are.

Conventions (docs/references.md): metres, Y up. The performer stands at the origin and faces +Z; its left is +X.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from math import isfinite

from ..errors import InputError, shown
from .schedule import Target

LISTENER = "listener"
"""The target that stands for the listener, whoever it is."""

MOST_TARGETS = 64
FARTHEST_M = 1000.0
NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,63}", re.ASCII)
FORM = "NAME=X,Y,Z in metres, Y up, the performer at 0,0,0 facing +Z, such as door=1.2,1.4,2.0"

_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?|[+-]?(nan|inf(inity)?)", re.ASCII | re.IGNORECASE)


def read_target(text: str) -> Target:
    """The target that `text` describes as NAME=X,Y,Z; the values are not checked. Raises InputError `target_wrong`."""
    name, _, place = text.partition("=")
    numbers = [part.strip() for part in place.split(",")]
    if len(numbers) != 3 or not all(_NUMBER.fullmatch(number) for number in numbers):
        raise _wrong(f"target {shown(text)}: write {FORM}")
    x, y, z = map(float, numbers)
    return Target(name.strip(), (x, y, z))


def read_targets(texts: Iterable[str]) -> tuple[Target, ...]:
    """The checked targets that `texts` describe. Raises InputError `target_wrong`."""
    return check_targets([read_target(text) for text in texts])


def targets_of(positions: Mapping[str, Sequence[float]]) -> tuple[Target, ...]:
    """The checked targets at these positions, by name. Raises InputError `target_wrong`."""
    for name, position in positions.items():
        if len(position) != 3:
            raise _wrong(f"target {shown(name)}: {len(position)} coordinates; give x, y and z")
    return check_targets([Target(name, (float(x), float(y), float(z))) for name, (x, y, z) in positions.items()])


def check_targets(targets: Sequence[Target]) -> tuple[Target, ...]:
    """The targets, unchanged. Raises InputError `target_wrong` for a wrong or repeated name, a coordinate that is not
    finite or too far away, and more than `MOST_TARGETS`."""
    if len(targets) > MOST_TARGETS:
        raise _wrong(f"{len(targets)} targets; {MOST_TARGETS} at most")
    names: set[str] = set()
    for target in targets:
        if not NAME.fullmatch(target.name):
            raise _wrong(f"target {shown(target.name)}: a name has letters, digits and _, a letter first, 64 at most")
        if target.name in names:
            raise _wrong(f"target {shown(target.name)} comes twice; place each once")
        for axis, value_m in zip("xyz", target.position_m, strict=True):
            if not isfinite(value_m) or abs(value_m) > FARTHEST_M:
                raise _wrong(f"target {shown(target.name)}: {axis} is {value_m:g}; give metres, {FARTHEST_M:g} at most")
        names.add(target.name)
    return tuple(targets)


def _wrong(message: str) -> InputError:
    return InputError("target_wrong", message, field="targets")

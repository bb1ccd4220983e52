"""Pawns: the targets that a BML file places, and the check that every target of its behaviours is placed.

Core BML names targets and leaves their positions to the scene. Ours has them in elements of our own namespace, which
other realizers skip: `<pawn name="door" x="1.2" y="1.4" z="2.0"/>`, metres as in `understudy.model.targets`, in a
description of the speech, as we write them, or in the block.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import count

from ...errors import InputError, WrongBmlError, did_you_mean, shown
from ...model import Behavior, Channel, Target
from ...model.targets import FARTHEST_M, LISTENER, check_targets, read_target
from ..markup.documents import Element
from ..markup.elements import OURS

PAWN, BEHAVIOR = f"{{{OURS}}}pawn", f"{{{OURS}}}behavior"
_SAYS = ("name", "x", "y", "z")
_COORDINATE = re.compile(r"[+-]?(\d{1,9}(\.\d*)?|\.\d+)", re.ASCII)


def pawns_of(root: Element) -> tuple[Target, ...]:
    """The pawns anywhere in a document. Raises WrongBmlError with the line of a wrong or repeated one."""
    placed: list[Target] = []
    for element in _elements(root, PAWN):
        try:
            placed = list(check_targets([*placed, _target(element)]))
        except InputError as error:
            line = f"line {element.place.line}: " if element.place else ""
            raise WrongBmlError("bml_wrong", f"{line}<pawn>: {error.message}") from None
    return tuple(placed)


def recorded_targets(root: Element) -> dict[str, str]:
    """The targets of gestures, by id, from the records that we write."""
    found = ((part.attributes.get("ref"), part.attributes.get("target")) for part in _elements(root, BEHAVIOR))
    return {str(name): str(target) for name, target in found if name and target}


def placed_by_coordinates(behaviors: Sequence[Behavior]) -> tuple[tuple[Behavior, ...], tuple[Target, ...]]:
    """The behaviours, and the targets of those whose target is not a name but a place, `"1.0,1.5,2.0"`: it is called
    `place1`, `place2` … then, metres as all targets. A place that cannot be one remains a name."""
    taken = {each.target for each in behaviors}
    places: dict[tuple[float, float, float], Target] = {}
    found: list[Behavior] = []
    for each in behaviors:
        place_m = _place_m(each.target or "")
        if place_m is not None and place_m not in places:
            names = (f"place{number}" for number in count(1))
            places[place_m] = Target(next(name for name in names if name not in taken), place_m)
            taken.add(places[place_m].name)
        found.append(each if place_m is None else replace(each, target=places[place_m].name))
    return tuple(found), tuple(places.values())


def _place_m(text: str) -> tuple[float, float, float] | None:
    """The place that three numbers with commas or spaces between them are."""
    parts = re.split(r"\s*,\s*|\s+", text.strip())
    if len(parts) != len("xyz") or not all(_COORDINATE.fullmatch(part) for part in parts):
        return None
    x, y, z = (float(part) for part in parts)
    return (x, y, z) if max(abs(x), abs(y), abs(z)) <= FARTHEST_M else None


def scene_of(
    behaviors: Iterable[Behavior], given: Sequence[Target], pawns: Sequence[Target], places: Sequence[Target] = ()
) -> tuple[Target, ...]:
    """The targets of a scene: those given, the pawns with other names, and places of no name of their own.

    If a scene has any targets, everything that is looked or pointed at must be among them, except the listener. Raises
    InputError `unknown_target`. Without any targets, or with only one person to look at, as in others' BML, nothing is
    required.
    """
    names = {target.name for target in given}
    scene = check_targets([*given, *(pawn for pawn in pawns if pawn.name not in names)])
    known, placed = {target.name for target in scene}, {target.name for target in places}
    aimed = [each for each in behaviors if each.target and each.kind in {Channel.GAZE, Channel.GESTURE}]
    unplaced = [each for each in aimed if each.target not in {LISTENER, *known, *placed}]
    alone = len({each.target for each in aimed if each.kind is Channel.GAZE}) == 1
    if scene and unplaced and not alone:
        behavior = unplaced[0]
        told = f"{behavior.id}: no target is called {shown(behavior.target or '')}"
        near, there = did_you_mean(behavior.target or "", known), ", ".join(sorted(known))
        message = f"{told}{near}; there are {there}; place it with --target NAME=X,Y,Z, `targets` or a pawn"
        raise InputError("unknown_target", message, field="targets")
    return check_targets([*scene, *places])


def _elements(element: Element, name: str) -> Iterator[Element]:
    if element.name == name:
        yield element
    for part in element.children:
        yield from _elements(part, name)


def _target(element: Element) -> Target:
    missing = [name for name in _SAYS if name not in element.attributes]
    if missing:
        raise InputError("target_wrong", f"no {', '.join(missing)}; write name, x, y and z", field="bml")
    name, *place = (str(element.attributes[key]) for key in _SAYS)
    return replace(read_target(f"x={','.join(place)}"), name=name)

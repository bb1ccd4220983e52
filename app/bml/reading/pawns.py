"""Pawns: the targets that a BML file places, and the check that every target of its behaviours is placed.

Core BML names targets and leaves their positions to the scene. Ours has them in elements of our own namespace, which
other realizers skip: `<pawn name="door" x="1.2" y="1.4" z="2.0"/>`, metres as in `understudy.model.targets`, in a
description of the speech, as we write them, or in the block.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from ...behavior.listeners.addressees import LISTENER
from ...errors import InputError, WrongBmlError, shown
from ...model import Behavior, Channel, Target
from ...model.targets import check_targets, read_target
from ...yaml_files import did_you_mean
from ..markup.documents import Element
from ..markup.elements import OURS

PAWN, BEHAVIOR = f"{{{OURS}}}pawn", f"{{{OURS}}}behavior"
_SAYS = ("name", "x", "y", "z")


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


def scene_of(behaviors: Iterable[Behavior], given: Sequence[Target], pawns: Sequence[Target]) -> tuple[Target, ...]:
    """The targets of a scene: those given, and the pawns with other names.

    If a scene has any targets, everything that is looked or pointed at must be among them, except the listener. Raises
    InputError `unknown_target`. Without any targets, or with only one person to look at, as in others' BML, nothing is
    required.
    """
    names = {target.name for target in given}
    scene = check_targets([*given, *(pawn for pawn in pawns if pawn.name not in names)])
    known = {target.name for target in scene}
    aimed = [each for each in behaviors if each.target and each.kind in {Channel.GAZE, Channel.GESTURE}]
    unplaced = [each for each in aimed if each.target not in {LISTENER, *known}]
    alone = len({each.target for each in aimed if each.kind is Channel.GAZE}) == 1
    if scene and unplaced and not alone:
        behavior = unplaced[0]
        told = f"{behavior.id}: no target is called {shown(behavior.target or '')}"
        near, placed = did_you_mean(behavior.target or "", known), ", ".join(sorted(known))
        message = f"{told}{near}; there are {placed}; place it with --target NAME=X,Y,Z, `targets` or a pawn"
        raise InputError("unknown_target", message, field="targets")
    return scene


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

"""Joint names of other rigs, from `lexicon/retarget/*.yaml`: Mixamo, Ready Player Me, Unreal and others.

A table only renames joints. Exported rotations are relative to the T-pose and the world's axes whatever the rig's own
rest pose, unit and axes are; the table records these for whoever retargets.
"""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import Literal

from pydantic import Field

from ...errors import AuthoringError, InputError, all_loaded, shown
from ...yaml_files import Entry, Source
from ..body.skeleton import SIDES, Skeleton

Axis = Literal["+X", "-X", "+Y", "-Y", "+Z", "-Z"]


@dataclass(frozen=True, slots=True)
class Rig:
    """A rig: its joint `names` by our joint names, its unit in metres, its up and forward axes, and its rest pose."""

    name: str
    names: Mapping[str, str]
    unit_m: float
    up: str
    forward: str
    rest: str


class Sides(Entry):
    """The rig's words for left and right."""

    left: str
    right: str


class RigFile(Entry):
    """The file format. The names are the file's own, or those of the rig `like`, each after `prefix`. In `sided`,
    {side} stands for the rig's word for left or right, {SIDE} for the same in capitals."""

    unit_m: float
    up: Literal["Y", "Z"]
    forward: Axis
    rest: Literal["T-pose", "A-pose", "I-pose"]
    like: str | None = None
    prefix: str = ""
    sides: Sides | None = None
    middle: dict[str, str] = Field(default_factory=dict)
    sided: dict[str, str] = Field(default_factory=dict)


def load_rigs(folder: Path, skeleton: Skeleton) -> Mapping[str, Rig]:
    """The rigs in a folder by name. Raises AuthoringError for unknown, missing or duplicate joint names."""
    rigs = all_loaded(partial(_loaded, path, skeleton) for path in sorted(folder.glob("*.yaml")))
    return MappingProxyType({rig.name: rig for rig in rigs})


def find_rig(rigs: Mapping[str, Rig], name: str) -> Rig:
    """The rig of this name. Raises InputError `unknown_skeleton`."""
    if name not in rigs:
        raise InputError(
            "unknown_skeleton", f"no skeleton {shown(name)}: there are {', '.join(rigs)}", field="skeleton"
        )
    return rigs[name]


def _loaded(path: Path, skeleton: Skeleton) -> Rig:
    source = Source(path)
    written = source.validated(RigFile)
    names = dict(_names_like(source, written, path.parent) if written.like else _names(source, written))
    _refuse_wrong_joints(source, names, skeleton)
    in_order = MappingProxyType({joint: names[joint] for joint in skeleton.names})
    return Rig(path.stem, in_order, written.unit_m, written.up, written.forward, written.rest)


def _names(source: Source, written: RigFile) -> Iterator[tuple[str, str]]:
    if written.sides is None:
        raise AuthoringError((source.mistake((), "no `sides`: the rig's words for left and right"),))
    yield from written.middle.items()
    for side in SIDES:
        word = str(getattr(written.sides, side))
        for part, name in written.sided.items():
            yield side + part, name.replace("{side}", word).replace("{SIDE}", word.upper())


def _names_like(source: Source, written: RigFile, folder: Path) -> Iterator[tuple[str, str]]:
    if written.middle or written.sided:
        raise AuthoringError((source.mistake(("like",), "the names are those of another rig: give none here"),))
    path = folder / f"{written.like}.yaml"
    if not path.is_file():
        raise AuthoringError((source.mistake(("like",), f"no rig {written.like} beside this file"),))
    other = Source(path)
    for joint, name in _names(other, other.validated(RigFile)):
        yield joint, written.prefix + name


def _refuse_wrong_joints(source: Source, names: Mapping[str, str], skeleton: Skeleton) -> None:
    mistakes = [
        source.mistake(_place(joint), f"the body has no joint {joint}")
        for joint in names
        if joint not in skeleton.index
    ]
    missing = [joint for joint in skeleton.names if joint not in names]
    if missing:
        mistakes.append(source.mistake((), f"no name for {', '.join(missing)}"))
    counts = Counter(names.values())
    mistakes += [
        source.mistake(_place(joint), f"{name} names two joints") for joint, name in names.items() if counts[name] > 1
    ]
    if mistakes:
        raise AuthoringError(tuple(mistakes))


def _place(joint: str) -> tuple[str, str]:
    """The section and key of a joint's name in the file."""
    for side in SIDES:
        if joint.startswith(side):
            return "sided", joint.removeprefix(side)
    return "middle", joint

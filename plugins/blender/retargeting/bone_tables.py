"""What families of rigs call our joints, from `tables/*.toml`, validated as they are read.

In `sided`, {side} stands for the family's words for left and right, {SIDE} for the same in capitals. A joint may have
several names, the likeliest first. Rigs whose controls hang together by constraints say more: `also` are bones that
take a joint's rotation besides the one it is found as, `follows` bones that are carried by another than their parent,
and `properties` custom properties of bones that must have a value while a clip plays.
"""

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .skeleton import JOINTS, SIDED, SIDES, TRUNK

FOLDER = Path(__file__).parent / "tables"
_NEEDED = ("title", "sides", "middle", "sided")
_KEYS = (*_NEEDED, "also", "follows", "properties")


class WrongTableError(ValueError):
    """A table of bones that cannot be used; the message has every mistake."""


@dataclass(frozen=True, slots=True)
class BoneProperty:
    """A custom property of a bone and the value it must have."""

    bone: str
    name: str
    value: float


@dataclass(frozen=True, slots=True)
class BoneTable:
    """A family of rigs: its names for each joint, the likeliest first, and what its constraints ask for."""

    name: str
    title: str
    names: Mapping[str, tuple[str, ...]]
    also: Mapping[str, str] = field(default_factory=dict)
    follows: Mapping[str, str] = field(default_factory=dict)
    properties: tuple[BoneProperty, ...] = ()


def load_tables(folder: Path = FOLDER) -> tuple[BoneTable, ...]:
    """All tables, in order of their names. Raises WrongTableError."""
    return tuple(read_table(path) for path in sorted(folder.glob("*.toml")))


def read_table(path: Path) -> BoneTable:
    """A table. Raises WrongTableError, which names the file and every mistake."""
    try:
        written = tomllib.loads(path.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise WrongTableError(f"{path.name}: {error}") from None
    mistakes = list(_mistakes(written))
    if mistakes:
        raise WrongTableError("\n".join(f"{path.name}: {mistake}" for mistake in mistakes))
    names = {joint: _listed(name) for joint, name in written["middle"].items()} | dict(_sided(written))
    return BoneTable(
        path.stem,
        written["title"],
        names,
        dict(_on_each_side(written, "also")),
        dict(_on_each_side(written, "follows")),
        tuple(_properties(written)),
    )


def _mistakes(written: Mapping[str, Any]) -> Iterator[str]:
    yield from (f"there is no key {key}; there are {', '.join(_KEYS)}" for key in written if key not in _KEYS)
    yield from (f"the key {key} is missing" for key in _NEEDED if key not in written)
    if not set(SIDES) <= set(written.get("sides", {})):
        yield "sides must give the words for left and right"
    for section, known in (("middle", TRUNK), ("sided", SIDED)):
        for joint, names in written.get(section, {}).items():
            if joint not in known:
                yield f"{section}.{joint}: the body has no such joint"
            if not all(isinstance(name, str) and name for name in _listed(names)):
                yield f"{section}.{joint}: expected a bone's name, or a list of them"
    yield from (
        f"also.{bone}: the body has no joint {joint}"
        for bone, joint in written.get("also", {}).items()
        if joint not in JOINTS
    )
    for number, each in enumerate(written.get("properties", [])):
        if set(each) != {"bone", "name", "value"} or not isinstance(each["value"], float):
            yield f"properties[{number}]: expected bone, name and value (a number with a decimal point)"


def _sided(written: Mapping[str, Any]) -> Iterator[tuple[str, tuple[str, ...]]]:
    for side in SIDES:
        for part, names in written["sided"].items():
            yield side + part, tuple(_with_side(name, written["sides"][side]) for name in _listed(names))


def _on_each_side(written: Mapping[str, Any], section: str) -> Iterator[tuple[str, str]]:
    """The entries of a section; those that name a side stand for one on each."""
    for word in written["sides"].values():
        for key, value in written.get(section, {}).items():
            yield _with_side(key, word), _with_side(value, word)


def _properties(written: Mapping[str, Any]) -> Iterator[BoneProperty]:
    for each in written.get("properties", []):
        bones = dict.fromkeys(_with_side(each["bone"], word) for word in written["sides"].values())
        yield from (BoneProperty(bone, each["name"], each["value"]) for bone in bones)


def _with_side(name: str, word: str) -> str:
    return name.replace("{side}", word).replace("{SIDE}", word.upper())


def _listed(names: object) -> tuple[Any, ...]:
    return tuple(names) if isinstance(names, list) else (names,)

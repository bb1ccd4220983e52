"""Finds those who speak next to a line in its scene, and makes names for listeners."""

import re
import unicodedata
from collections.abc import Iterator, Sequence

from ..model import ScriptLine
from .cast_file import folded

_NO_NAME = re.compile(r"[\W_]+")
_LONGEST = 64


def neighbours(lines: Sequence[ScriptLine]) -> dict[str, tuple[str, ...]]:
    """For each line in a scene, by its id, the nearest other speakers before and after it, the one before first."""
    partners: dict[str, tuple[str, ...]] = {}
    for scene in _scenes(lines):
        for place, line in enumerate(scene):
            found = [_nearest(line, reversed(scene[:place])), _nearest(line, iter(scene[place + 1 :]))]
            partners[line.id] = tuple(dict.fromkeys(name for name in found if name))
    return partners


def listener_name(name: str) -> str:
    """A name of the script as a valid listener's name, for BML and file names: with its letters, whatever they are,
    and underscores between words (Zoë, Jörg_Müller)."""
    plain = _NO_NAME.sub("_", unicodedata.normalize("NFC", name)).strip("_")[: _LONGEST - 2] or "listener"
    return plain if plain[0].isalpha() else f"L_{plain}"


def _scenes(lines: Sequence[ScriptLine]) -> Iterator[list[ScriptLine]]:
    """The lines of each scene; lines without a scene or a character have no partners."""
    by_scene: dict[str, list[ScriptLine]] = {}
    for line in lines:
        if line.scene and line.character:
            by_scene.setdefault(line.scene, []).append(line)
    yield from by_scene.values()


def _nearest(line: ScriptLine, others: Iterator[ScriptLine]) -> str:
    return next((other.character for other in others if folded(other.character) != folded(line.character)), "")

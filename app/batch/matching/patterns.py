"""Finds recordings by a pattern of their names, such as `{character}/{id}_t{take}.wav`.

Names in braces are fields of the line, `*` matches anything but a folder. A pattern without a folder finds recordings
in any. One pass over the files indexes them, so that the cost does not grow with the number of lines.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Self

from ...errors import InputError
from ...suggestions import did_you_mean
from ..model import ScriptLine
from .recordings import RecordingFile

PLACES = ("id", "character", "scene", "row", "take")
_PART = re.compile(r"\{(\w*)\}|(\*)|([^{}*]+)|(.)", re.DOTALL)


@dataclass(frozen=True, slots=True)
class Pattern:
    """A compiled pattern; `places` are the fields in its braces that must agree with the line."""

    expression: re.Pattern[str]
    places: tuple[str, ...]
    has_folder: bool

    @classmethod
    def of(cls, text: str) -> Self:
        """Raises InputError `pattern_wrong`."""
        made, places = "", []
        for match in _PART.finditer(text):
            name, star, plain, stray = match.groups()
            if stray is not None or (name is not None and name not in PLACES):
                hint = did_you_mean(name or "", PLACES)
                told = ", ".join(f"{{{place}}}" for place in PLACES)
                message = f"pattern {text!r}: {match[0]!r} is no place; places are {told}{hint}"
                raise InputError("pattern_wrong", message, field="pattern")
            if name in places:
                made += f"(?P={name})"
            elif name is not None:
                places.append(name)
                made += rf"(?P<{name}>\d+)" if name in {"row", "take"} else f"(?P<{name}>[^/]+)"
            else:
                made += "[^/]*" if star else re.escape(plain)
        if not {"id", "row"} & set(places):
            message = f"pattern {text!r}: says nothing of the line; put {{id}} where its id stands"
            raise InputError("pattern_wrong", message, field="pattern")
        return cls(re.compile(made, re.IGNORECASE), tuple(name for name in places if name != "take"), "/" in text)

    def by_key(self, files: Iterable[RecordingFile]) -> dict[tuple[str, ...], list[tuple[RecordingFile, int | None]]]:
        """The matching files with their takes, by the values of `places`."""
        found: dict[tuple[str, ...], list[tuple[RecordingFile, int | None]]] = {}
        for file in files:
            match = self.expression.fullmatch(file.relative if self.has_folder else file.path.name)
            if match:
                take = int(match["take"]) if "take" in match.re.groupindex else None
                found.setdefault(tuple(_plain(match[name]) for name in self.places), []).append((file, take))
        return found

    def key(self, line: ScriptLine) -> tuple[str, ...]:
        """The values of `places` in a line."""
        return tuple(_plain(str(getattr(line, name))) for name in self.places)


def _plain(value: str) -> str:
    """In lower case, and numbers without leading zeros."""
    return str(int(value)) if value.isdecimal() else value.casefold()

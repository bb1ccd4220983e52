"""Finds the columns of a sheet: by their usual names (lexicon/batch/columns.yaml), or as the caller says."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from pydantic import RootModel

from ...authored_folders import lexicon_folder
from ...errors import AuthoringError, InputError, did_you_mean
from ...yaml_files import Source

FIELDS = (
    "id",
    "text",
    "character",
    "recording",
    "comment",
    "direction",
    "edits",
    "scene",
    "take",
    "start",
    "end",
    "listener",
    "agitation",
    "affect",
    "seed",
    "target",
)
"""The fields that columns can have."""

EITHER = "id or text"
"""The key of names that are the text beside another column for the id, and the id otherwise."""

_LETTERS = 26


class _UsualNames(RootModel[dict[str, list[str]]]):
    """The file of usual names."""


@dataclass(frozen=True, slots=True)
class ColumnNames:
    """The usual names of columns: the field and the rank (0 is preferred) of each folded name, and those that may be
    the id or the text."""

    fields: Mapping[str, tuple[str, int]]
    either: frozenset[str] = frozenset()

    @classmethod
    def load(cls, path: Path | None = None) -> "ColumnNames":
        """Raises AuthoringError with every field that is unknown and every name that two fields claim."""
        source = Source(path or lexicon_folder() / "batch" / "columns.yaml")
        fields: dict[str, tuple[str, int]] = {}
        mistakes = []
        for field, names in source.validated(_UsualNames).root.items():
            if field not in (*FIELDS, EITHER):
                mistakes.append(source.mistake((field,), f"no field is called {field!r}{did_you_mean(field, FIELDS)}"))
            for place, name in enumerate(names):
                if fields.setdefault(folded(name), (field, place))[0] != field:
                    owner = fields[folded(name)][0]
                    mistakes.append(source.mistake((field, place), f"{name!r} is a name of {owner!r} already"))
        if mistakes:
            raise AuthoringError(tuple(mistakes))
        either = frozenset(name for name, (field, _rank) in fields.items() if field == EITHER)
        sure = {name: found for name, found in fields.items() if name not in either}
        return cls(MappingProxyType(sure), either)

    def recognised(self, header: Sequence[str]) -> int:
        """The number of cells of a header that are known names."""
        return sum(folded(cell) in self.fields or folded(cell) in self.either for cell in header)


@dataclass(frozen=True, slots=True)
class Columns:
    """The position in a row of each field; fields without a column are absent. Spreadsheet columns have letters, keys
    of JSON do not."""

    header: tuple[str, ...]
    places: Mapping[str, int]
    has_letters: bool = True

    def name(self, field: str) -> str:
        """The column as people find it: its letter and its heading."""
        return self._told(self.places[field])

    def told(self) -> tuple[tuple[str, str], ...]:
        """The columns by field in their order, those that are not used with an empty field."""
        fields = {place: field for field, place in self.places.items()}
        headings = enumerate(self.header)
        return tuple((fields.get(place, ""), self._told(place)) for place, told in headings if told or place in fields)

    def _told(self, place: int) -> str:
        return f"{letters(place)} ({self.header[place]})" if self.has_letters else repr(self.header[place])


def find_columns(
    header: Sequence[str], names: ColumnNames, named: Mapping[str, str], *, file: str, needs_text: bool = True
) -> Columns:
    """The columns of a sheet; `named` are those that the caller named, heading by field.

    Raises InputError `columns_missing` when no column has the text, or a heading that was named is missing.
    """
    cells = tuple(cell.strip() for cell in header)
    places = {field: _place_of(field, heading, cells, file) for field, heading in named.items()}
    ranked = [
        (names.fields[folded(cell)][1], place, names.fields[folded(cell)][0])
        for place, cell in enumerate(cells)
        if folded(cell) in names.fields and place not in places.values()
    ]
    for _rank, place, field in sorted(ranked):
        places.setdefault(field, place)
    _place_either(places, [place for place, cell in enumerate(cells) if folded(cell) in names.either])
    if needs_text and "text" not in places:
        listed = ", ".join(repr(cell) for cell in cells if cell) or "nothing"
        message = f'{file}: no column has the words; its headings are {listed}; name it with --column text="HEADING"'
        raise InputError("columns_missing", message, field="script")
    return Columns(cells, MappingProxyType(places))


def _place_either(places: dict[str, int], either: Sequence[int]) -> None:
    """Columns whose names are those of ids and of words: the words where there are no others, else the id."""
    for place in either:
        if place not in places.values():
            places.setdefault("id" if "text" in places else "text", place)


def read_named(options: Sequence[str]) -> dict[str, str]:
    """The headings by field of `--column FIELD=HEADING`; raises InputError `usage`."""
    named: dict[str, str] = {}
    for option in options:
        field, separator, heading = option.partition("=")
        if not separator or field not in FIELDS:
            hint = did_you_mean(field, FIELDS)
            message = f"--column {option}: give FIELD=HEADING; fields are {', '.join(FIELDS)}{hint}"
            raise InputError("usage", message, field="column")
        named[field] = heading
    return named


def folded(name: str) -> str:
    """A heading in lower case without punctuation, for comparison; # is "no"."""
    return re.sub(r"[\s_.\-:/']+", " ", name.replace("#", " no ")).strip().casefold()


def letters(place: int) -> str:
    """A column's letters in a spreadsheet; the first, 0, is A."""
    told = ""
    place += 1
    while place:
        place, rest = divmod(place - 1, _LETTERS)
        told = chr(ord("A") + rest) + told
    return told


def _place_of(field: str, heading: str, cells: Sequence[str], file: str) -> int:
    for spelt in (str, str.casefold, folded):  # exactly as named, else in another spelling
        for place, cell in enumerate(cells):
            if spelt(cell) == spelt(heading.strip()):
                return place
    message = f"{file}: no column is headed {heading!r}{did_you_mean(heading, cells)}"
    raise InputError("columns_missing", message, field=f"column {field}")

"""A table of recordings with their agitation (`understudy agitation train LABELS.csv`), with every mistake in it.

CSV (or with semicolons or tabs) with the columns `file` (relative to the table), `speaker`, `agitation` (low, medium or
mid, high; two with a slash, "medium/high", for what lies between) and perhaps others, such as `emotion`, which are not
read.
"""

import csv
import io
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from ..errors import InputError, did_you_mean, shown
from ..model import Level

SEPARATORS = (",", ";", "\t")
"""The one that is most often in the first line: spreadsheets write semicolons where a comma is in decimals."""
COLUMNS = ("file", "speaker", "agitation")
MOST_ROWS = 20_000
MOST_TOLD = 5
NAMES: Mapping[str, Level] = {"low": Level.LOW, "mid": Level.MEDIUM, "medium": Level.MEDIUM, "high": Level.HIGH}


@dataclass(frozen=True, slots=True)
class LabelledRecording:
    """A recording, who speaks in it, and how much it belongs to each level, in the order of `Level`."""

    path: Path
    speaker: str
    memberships: tuple[float, float, float]


def read_labels(content: bytes, table: Path) -> tuple[LabelledRecording, ...]:
    """The recordings of the table of that name; raises InputError `labels_wrong` with the first mistakes, each with its
    line."""
    try:
        text = content.decode("utf-8-sig")
        separator = max(SEPARATORS, key=text.partition("\n")[0].count)
        rows = list(csv.reader(io.StringIO(text), delimiter=separator, strict=True))
    except (UnicodeDecodeError, csv.Error) as error:
        raise _wrong(f"{table}: not CSV in UTF-8 ({error}); save it as CSV in UTF-8") from None
    header = [cell.strip().lower() for cell in rows[0]] if rows else []
    if missing := [name for name in COLUMNS if name not in header]:
        message = f"{table}:1: the column {missing[0]} is missing{did_you_mean(missing[0], header)}"
        raise _wrong(f"{message}; the first line must name {', '.join(COLUMNS)}")
    if len(rows) > MOST_ROWS:
        raise _wrong(f"{table}: {len(rows)} lines; {MOST_ROWS} at most")
    places = [header.index(name) for name in COLUMNS]
    found = [
        _read(row, places, f"{table}:{line}", table.parent)
        for line, row in enumerate(rows[1:], start=2)
        if any(map(str.strip, row))
    ]
    mistakes = [each for each in found if isinstance(each, str)]
    if mistakes:
        more = f"; and {len(mistakes) - MOST_TOLD} more" if len(mistakes) > MOST_TOLD else ""
        raise _wrong("; ".join(mistakes[:MOST_TOLD]) + more)
    if not found:
        raise _wrong(f"{table}: no recordings; give a line for each below the first, which names the columns")
    return tuple(each for each in found if isinstance(each, LabelledRecording))


def _read(row: list[str], places: list[int], where: str, folder: Path) -> LabelledRecording | str:
    """The recording of a row, or what is wrong with it."""
    if len(row) <= max(places):
        return f"{where}: {len(row)} cells; there are as many as columns"
    file, speaker, told = (row[place].strip() for place in places)
    if not file or not (folder / file).is_file():
        return f"{where}: there is no file {shown(file)} beside the table"
    if not speaker:
        return f"{where}: no speaker; name who speaks, so that speakers can be left out"
    levels = list(_levels(told))
    if None in levels or len(levels) > 2:
        return f"{where}: agitation {shown(told)}; give low, medium or high, or two as medium/high"
    memberships = tuple(levels.count(level) / len(levels) for level in Level)
    return LabelledRecording(folder / file, speaker, (memberships[0], memberships[1], memberships[2]))


def _levels(text: str) -> Iterator[Level | None]:
    return (NAMES.get(part.strip().lower()) for part in text.split("/"))


def _wrong(message: str) -> InputError:
    return InputError("labels_wrong", message, field="labels")

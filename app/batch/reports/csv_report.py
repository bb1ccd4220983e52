"""Writes `report.csv`: one row a line, the most urgent to check first."""

import csv
import io
from collections.abc import Iterable, Mapping

from ..manifest.entries import Entry
from .attention import reasons

COLUMNS = (
    "row",
    "id",
    "character",
    "performer",
    "state",
    "look_at",
    "duration_s",
    "agitation",
    "functions",
    "gestures",
    "gestures_dropped",
    "unplayed",
    "emphasised_words",
    "pitch_spread_st",
    "warnings",
    "error_code",
    "error",
    "text",
    "audio",
    "outputs",
)


def to_csv(entries: Iterable[Entry]) -> bytes:
    """The report, in the order of `entries`; with a byte order mark, by which spreadsheets recognize UTF-8."""
    stream = io.StringIO()
    writer = csv.DictWriter(stream, COLUMNS, lineterminator="\r\n")
    writer.writeheader()
    writer.writerows(_row(entry) for entry in entries)
    return stream.getvalue().encode("utf-8-sig")


def _row(entry: Entry) -> Mapping[str, object]:
    measures, failure = entry.measures, entry.failure
    row: dict[str, object] = {
        "row": entry.row,
        "id": entry.id,
        "character": entry.character,
        "performer": entry.performer,
        "state": entry.state.value,
        "look_at": " ".join(reason for _weight, reason in reasons(entry)),
        "warnings": " ".join(sorted({notice.code for notice in entry.warnings})),
        "error_code": failure.code if failure else "",
        "error": failure.message if failure else "",
        "text": entry.text,
        "audio": entry.audio,
        "outputs": " ".join(file.path for file in entry.outputs),
    }
    if measures is not None:
        row |= {
            "duration_s": measures.duration_s,
            "agitation": measures.agitation,
            "functions": " ".join(f"{name}:{count}" for name, count in measures.functions.items()),
            "gestures": measures.gestures,
            "gestures_dropped": measures.gestures_dropped,
            "unplayed": measures.unplayed,
            "emphasised_words": measures.emphasised,
            "pitch_spread_st": measures.pitch_spread_st,
        }
    return {name: _harmless(value) for name, value in row.items()}


def _harmless(value: object) -> object:
    """Marks as text what a spreadsheet would take for a formula."""
    return f"'{value}" if isinstance(value, str) and value.startswith(("=", "+", "-", "@", "\t")) else value

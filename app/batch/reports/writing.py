"""Writes every report of a batch: `report.html`, `report.csv` (a row a line, the most urgent to check first), and
`index.json`, the performed lines and the paths of their files, for game engines.
"""

import csv
import io
import json
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from ..manifest.entries import ManifestEntry, State
from ..work.files import clear_unfinished, write_whole
from .attention import attention, reasons
from .html_report import Heading, Thumbnail, to_html

REPORTS = ("report.csv", "report.html", "index.json")


def in_order_of_attention(entries: Sequence[ManifestEntry]) -> list[ManifestEntry]:
    """The most urgent to check first, then in the script's order."""
    return sorted(entries, key=lambda entry: (-attention(entry), entry.place))


def write_reports(
    out: Path, heading: Heading, entries: Sequence[ManifestEntry], thumbnails: Mapping[str, Thumbnail]
) -> None:
    """Writes the reports; `thumbnails` are by the lines' ids. Raises OSError."""
    urgent = in_order_of_attention(entries)
    write_whole(out, "report.csv", to_csv(urgent))
    write_whole(out, "report.html", to_html(heading, urgent, thumbnails, out))
    write_whole(out, "index.json", to_index(heading.script, entries))
    clear_unfinished(out)


def reports_are_there(out: Path) -> bool:
    """Whether all reports exist."""
    return all((out / name).is_file() for name in REPORTS)


def remove_reports(out: Path) -> None:
    """Removes reports that are out of date; raises OSError."""
    for name in REPORTS:
        (out / name).unlink(missing_ok=True)


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


def to_csv(entries: Iterable[ManifestEntry]) -> bytes:
    """The report, in the order of `entries`; with a byte order mark, by which spreadsheets recognize UTF-8."""
    stream = io.StringIO()
    writer = csv.DictWriter(stream, COLUMNS, lineterminator="\r\n")
    writer.writeheader()
    writer.writerows(_row(entry) for entry in entries)
    return stream.getvalue().encode("utf-8-sig")


def _row(entry: ManifestEntry) -> Mapping[str, object]:
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


def to_index(script: str, entries: Iterable[ManifestEntry]) -> bytes:
    """The lines that are done, in the script's order; paths are relative to the output folder."""
    lines = [_line(entry) for entry in sorted(entries, key=lambda one: one.place) if entry.state is State.DONE]
    return json.dumps({"script": script, "lines": lines}, indent=1, ensure_ascii=False).encode() + b"\n"


def _line(entry: ManifestEntry) -> dict[str, object]:
    listeners: dict[str, dict[str, str]] = {}
    for file in entry.outputs:
        if file.listener:
            listeners.setdefault(file.listener, {})[file.form] = file.path
    return {
        "id": entry.id,
        "character": entry.character,
        "performer": entry.performer,
        "text": entry.text,
        "audio": entry.audio,
        **({} if entry.start_s is None else {"start_s": entry.start_s, "end_s": entry.end_s}),
        "duration_s": entry.measures.duration_s if entry.measures else None,
        "agitation": entry.measures.agitation if entry.measures else None,
        "files": {file.form: file.path for file in entry.outputs if not file.listener},
        **({"listeners": listeners} if listeners else {}),
    }

"""Writes every report of a batch."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from ..manifest.entries import Entry
from ..work.files import clear_unfinished, write_whole
from .attention import attention
from .csv_report import to_csv
from .html_report import to_html
from .index_json import to_index

REPORTS = ("report.csv", "report.html", "index.json")


def in_order_of_attention(entries: Sequence[Entry]) -> list[Entry]:
    """The most urgent to check first, then in the script's order."""
    return sorted(entries, key=lambda entry: (-attention(entry), entry.place))


def write_reports(out: Path, script: str, entries: Sequence[Entry], thumbnails: Mapping[str, bytes]) -> None:
    """Writes the reports; `thumbnails` are PNG by the lines' ids. Raises OSError."""
    urgent = in_order_of_attention(entries)
    write_whole(out, "report.csv", to_csv(urgent))
    write_whole(out, "report.html", to_html(script, urgent, thumbnails))
    write_whole(out, "index.json", to_index(script, entries))
    clear_unfinished(out)


def reports_are_there(out: Path) -> bool:
    """Whether all reports exist."""
    return all((out / name).is_file() for name in REPORTS)


def remove_reports(out: Path) -> None:
    """Removes reports that are out of date; raises OSError."""
    for name in REPORTS:
        (out / name).unlink(missing_ok=True)

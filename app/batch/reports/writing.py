"""Writes every report of a batch."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from ..manifest.entries import Entry
from ..work.files import clear_unfinished, write_whole
from .attention import attention
from .csv_report import to_csv
from .html_report import Heading, Thumbnail, to_html
from .index_json import to_index

REPORTS = ("report.csv", "report.html", "index.json")


def in_order_of_attention(entries: Sequence[Entry]) -> list[Entry]:
    """The most urgent to check first, then in the script's order."""
    return sorted(entries, key=lambda entry: (-attention(entry), entry.place))


def write_reports(out: Path, heading: Heading, entries: Sequence[Entry], thumbnails: Mapping[str, Thumbnail]) -> None:
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

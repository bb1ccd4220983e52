"""Writes every report of a batch."""

from collections.abc import Sequence
from pathlib import Path

from ..manifest.entries import Entry
from ..work.files import clear_unfinished, write_whole
from .attention import attention
from .csv_report import to_csv
from .index_json import to_index


def write_reports(out: Path, script: str, entries: Sequence[Entry]) -> None:
    """Writes the reports, what needs a human eye first; raises OSError."""
    urgent = sorted(entries, key=lambda entry: (-attention(entry), entry.place))
    write_whole(out, "report.csv", to_csv(urgent))
    write_whole(out, "index.json", to_index(script, entries))
    clear_unfinished(out)

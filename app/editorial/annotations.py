"""Exports events for annotation tools, Praat's TextGrid and ELAN's .eaf, and as a table (CSV), one row each; all on the
clock of the recording.

Tiers: the words, the functions, every channel of movement, and beside each its reasons (`gesture.function`,
`gesture.rule`, …). Events that overlap are split into several tiers, `face`, `face_2`. The tools have no times before
the recording, so what begins in a lead-in is cut there; in the table its times are negative. Points that a
movement does not have are empty in the table.
"""

import csv
import io
from collections.abc import Sequence
from dataclasses import fields

from ..model import SyncPoints
from ..profiles.annotation.elan import write_elan
from ..profiles.annotation.tracks import Track, TrackSpan, rows_of
from .events import TimelineEvent

POINTS = ("ready", "stroke_start", "stroke", "stroke_end", "relax")
COLUMNS = ("tier", "id", "label", "start_s", *(f"{point}_s" for point in POINTS), "end_s", "hand", "first", "last")
REASONS = ("words", "function", "rule")
assert {*POINTS, "start", "end"} == {field.name for field in fields(SyncPoints)}


def to_textgrid(tracks: Sequence[Track], duration_s: float) -> bytes:
    """The TextGrid (long format), as long as the recording or its last event."""
    from praatio.utilities import textgrid_io  # type: ignore[import-untyped]

    rows = [row for track in tracks for row in rows_of(track) if track.spans]
    end_s = max([duration_s, *(span.end_s for row in rows for span in row.spans)])
    grid = {"xmin": 0, "xmax": end_s, "tiers": [_tier(row, end_s) for row in rows]}
    return str(textgrid_io.getTextgridAsStr(grid, "long_textgrid", includeBlankSpaces=True)).encode()


def to_elan(tracks: Sequence[Track], media: str = "") -> bytes:
    """The .eaf; `media` is the recording's file."""
    return write_elan([row for track in tracks if track.spans for row in rows_of(track)], media=media)


def _tier(row: Track, end_s: float) -> dict[str, object]:
    entries = [(span.start_s, span.end_s, span.label) for span in _apart(row.spans)]
    return {"class": "IntervalTier", "name": row.name, "xmin": 0, "xmax": end_s, "entries": entries}


def _apart(spans: Sequence[TrackSpan]) -> list[TrackSpan]:
    """The spans with a duration: Praat has no intervals of length 0."""
    return [span for span in spans if span.end_s > span.start_s]


def to_event_table(events: Sequence[TimelineEvent], *, clock_starts_s: float) -> bytes:
    """The table; `clock_starts_s` is when the recording starts."""
    content = io.StringIO()
    writer = csv.writer(content, lineterminator="\n")
    writer.writerow((*COLUMNS, *REASONS))
    for event in events:
        times_s = [event.start_s, *(event.points.get(point) for point in POINTS), event.end_s]
        told = ["" if time_s is None else f"{time_s - clock_starts_s:.3f}" for time_s in times_s]
        named = (event.tier, event.id, event.label)
        writer.writerow((*named, *told, event.hand, event.first, event.last, event.text, event.function, event.rule))
    return content.getvalue().encode()

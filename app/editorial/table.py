"""Exports events as a table (CSV), one row each, in seconds of the recording.

With a lead-in, times before the recording are negative. Points that a movement does not have are empty.
"""

import csv
import io
from collections.abc import Sequence
from dataclasses import fields

from ..model import SyncPoints
from .events import TimelineEvent

POINTS = ("ready", "stroke_start", "stroke", "stroke_end", "relax")
COLUMNS = ("tier", "id", "label", "start_s", *(f"{point}_s" for point in POINTS), "end_s", "hand", "first", "last")
REASONS = ("words", "function", "rule")
assert {*POINTS, "start", "end"} == {field.name for field in fields(SyncPoints)}


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

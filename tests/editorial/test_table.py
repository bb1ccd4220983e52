"""The table of events, read by the csv module."""

import csv
import io

from tests.support.motion.editorial import LEAD_IN_S, REALIZED, SCHEDULE
from understudy.editorial.events import timeline_events
from understudy.editorial.table import to_event_table
from understudy.model import SyncPoints


def rows(realized: dict[str, SyncPoints]) -> dict[str, dict[str, str]]:
    content = to_event_table(timeline_events(SCHEDULE, realized), clock_starts_s=LEAD_IN_S).decode()
    return {row["id"]: row for row in csv.DictReader(io.StringIO(content))}


def test_a_row_has_the_points_in_the_time_of_the_recording_and_the_reasons() -> None:
    told = rows(dict(REALIZED))
    gesture = told["gesture1"]
    assert (gesture["tier"], gesture["label"], gesture["hand"]) == ("gesture", "NEGATION", "right")
    assert (gesture["start_s"], gesture["stroke_s"], gesture["end_s"]) == ("0.500", "1.000", "2.100")
    assert (gesture["words"], gesture["function"], gesture["rule"]) == ("No", "negation/plain", "show_negation")
    assert told["eyes1"]["stroke_s"] == ""
    assert told["f2"]["label"] == "emphasis/voice"


def test_what_is_before_the_recording_has_times_below_zero() -> None:
    assert rows({**REALIZED, "eyes1": SyncPoints(0.1, 0.3)})["eyes1"]["start_s"] == "-0.400"

"""Notes that no kept movement carries out are reported, one by one."""

from dataclasses import replace

from understudy.behavior.candidates.notes import unplayed_notes
from understudy.model import Behavior, Channel, Moment, SyncPoints

ASKED = Moment("note0.gesture", Channel.GESTURE, 0, 2, 1, ("present",), 1.0, note=0)
MADE = Behavior("g1", Channel.GESTURE, "OPEN_HAND", SyncPoints(0.0, 1.0), 0, 2, 5.0, moment=ASKED.id)


def test_a_note_that_is_played_is_not_told() -> None:
    assert unplayed_notes([ASKED], [MADE]) == ()


def test_a_note_whose_movement_was_dropped_is_told() -> None:
    (notice,) = unplayed_notes([ASKED], [replace(MADE, kept=False)])
    assert (notice.code, notice.message) == ("direction_unplayed", "note 0: no gesture for present fits on word 1")


def test_planned_moments_and_looks_at_the_listener_are_no_unplayed_notes() -> None:
    looked = Moment("note0.gaze", Channel.GAZE, 0, 2, 1, ("listener",), 1.0, note=0)
    assert unplayed_notes([replace(ASKED, note=None), looked], []) == ()

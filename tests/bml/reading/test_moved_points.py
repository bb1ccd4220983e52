"""Moving a point by hand moves the points that depend on it."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from tests.support.words.by_hand import FIGURE_8, spoken, utterance
from understudy.bml.reading.reader import read_bml
from understudy.bml.reading.record import read_record
from understudy.bml.reading.resolving import resolve
from understudy.bml.writing.writer import write_bml
from understudy.errors import WrongBmlError
from understudy.model import Behavior, Channel, Notice, Performance, SyncPoints
from understudy.model.formats import BmlForm, TimeForm

STROKE = SyncPoints(start=2.0, ready=2.45, stroke_start=2.5, stroke=2.8, stroke_end=3.0, relax=3.4, end=3.9)
PEAK = SyncPoints(start=2.0, ready=2.2, relax=2.6, end=2.9)
WORDS = spoken(FIGURE_8)
BEHAVIORS = (
    Behavior("gesture1", Channel.GESTURE, "POINT", STROKE, 2, 2, 5.0),
    Behavior("face1", Channel.FACE, "RAISE_BROWS", PEAK, 2, 2, 1.0, amount=0.5),
)
LINE = Performance(utterance(WORDS), (), BEHAVIORS, "default", 0)


def read(*edits: tuple[str, str], form: TimeForm = TimeForm.ABSOLUTE) -> tuple[dict[str, SyncPoints], list[Notice]]:
    """The sync points of the file after edits by regular expressions, and what was told."""
    bml = write_bml(LINE, BmlForm(timing=form)).decode()
    for old, new in edits:
        bml, count = re.subn(old, new, bml)
        assert count == 1, old
    document, notices = read_bml(bml.encode(), Path("a.bml"))
    return {each.id: each.sync for each in resolve(document, WORDS).behaviors}, list(notices)


def test_nothing_follows_where_nothing_was_moved() -> None:
    for form in TimeForm:
        found, notices = read(form=form)
        assert (found, notices) == ({"gesture1": STROKE, "face1": PEAK}, [])


@pytest.mark.parametrize(
    ("point", "at_s"), [("start", 2.0), ("ready", 2.45), ("strokeStart", 2.5), ("stroke", 2.8), ("strokeEnd", 3.0)]
)
def test_up_to_its_strokes_end_a_gesture_moves_as_a_whole(point: str, at_s: float) -> None:
    found, notices = read((f' {point}="{at_s:.3f}"(?=[^>]*strokeEnd|[^>]*relax="3.4)', f' {point}="{at_s + 0.4:.3f}"'))
    assert found["gesture1"] == STROKE.shifted(0.4)
    assert found["face1"] == PEAK
    (told,) = notices
    assert told.code == "bml_point_moved"
    assert told.message == f"gesture1: its {point} is 0.400 s later than scheduled; dependent behaviours move with it"


def test_a_later_relax_time_takes_the_end_along_and_the_end_nothing() -> None:
    found, _notices = read(('relax="3.400"', 'relax="3.700"'))
    assert (found["gesture1"].stroke, found["gesture1"].relax, found["gesture1"].end) == (2.8, 3.7, 4.2)
    found, notices = read(('end="3.900"', 'end="4.500"'))
    assert (found["gesture1"].relax, found["gesture1"].end) == (3.4, 4.5)
    assert notices == []


def test_a_face_moves_with_its_peak() -> None:
    found, _notices = read(('attackPeak="2.200"', 'attackPeak="1.900"'))
    assert found["face1"] == PEAK.shifted(-0.3)


def test_what_was_moved_stays_where_it_was_put() -> None:
    """Of two that were moved the stroke counts more."""
    found, _notices = read(('stroke="2.800"', 'stroke="3.000"'), ('relax="3.400"', 'relax="3.900"'))
    assert found["gesture1"] == SyncPoints(2.2, 4.1, 2.65, 2.7, 3.0, 3.2, 3.9)


def test_points_by_marks_follow_too() -> None:
    found, _notices = read((r'(gesture1"[^>]* stroke="speech1:w\d)\+[\d.]+"', r'\g<1>+0.100"'), form=TimeForm.SYNC)
    (moved, plain) = found["gesture1"], STROKE
    assert moved.stroke is not None
    assert moved == plain.shifted(moved.stroke - 2.8)
    assert moved != plain


def test_what_is_out_of_order_then_is_told() -> None:
    with pytest.raises(WrongBmlError, match="relax comes before strokeEnd"):
        read(('relax="3.400"', 'relax="2.900"'))


def test_points_at_the_very_start_are_not_taken_for_moved_ones() -> None:
    """Relative to marks they are written a thousandth of a second later, and come back as they were."""
    early = SyncPoints(start=0.0, ready=0.0, relax=0.4, end=0.9)
    face = Behavior("face1", Channel.FACE, "RAISE_BROWS", early, 0, 0, 1.0, amount=0.5)
    bml = write_bml(replace(LINE, behaviors=(face,)), BmlForm(timing=TimeForm.SYNC))
    document, notices = read_bml(bml, Path("a.bml"))
    record = read_record(document)
    assert record is not None
    assert notices == ()
    (found,) = resolve(document, WORDS).behaviors
    assert record.completed(found).sync == early
    moved, (notice,) = read_bml(bml.replace(b'relax="speech1:start+0.4', b'relax="speech1:start+0.6'), Path("a.bml"))
    assert "its relax is 0.200 s later" in notice.message
    assert resolve(moved, WORDS).behaviors[0].sync == SyncPoints(start=0.001, ready=0.001, relax=0.6, end=1.1)

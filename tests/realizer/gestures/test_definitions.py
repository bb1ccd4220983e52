"""Headers of gestures: what they say, what is made where they say nothing, and what cannot be."""

from pathlib import Path

import pytest

from tests.support.motion.gesture_files import gesture, mistakes_in, read_one
from understudy.model import Hand, Level
from understudy.realizer.gestures.definitions import RANGES, derived_expressivity
from understudy.realizer.gestures.gesture import Expressivity, FrameType

SMALL = Path(__file__).resolve().parents[3] / "lexicon" / "gestures" / "small.gesture"


def test_the_paper_s_gesture_small_as_printed(tmp_path: Path) -> None:
    """Gesture Engine §4.2."""
    small = read_one(tmp_path, SMALL.read_text(encoding="utf-8"))
    assert (small.gesture_class, small.name, small.duration_s) == ("adjectival", "small", 1.5)
    assert (small.categories, small.hand, small.aimed) == (("SMALL",), None, False)
    types = [FrameType.STROKE_START, FrameType.STROKE_END, FrameType.HOLD]
    assert [(frame.time, frame.type) for frame in small.frames] == list(zip([0.0, 0.4, 1.0], types, strict=True))
    assert [frame.noise for frame in small.frames] == [False, True, False]
    assert small.frames[1].leading.hand is None
    assert small.frames[0].leading.hand == small.frames[2].leading.hand


def test_the_whole_header(tmp_path: Path) -> None:
    header = "ARMS both\nCATEGORY ME WE\nAIMED\nLEVELS medium high\nEXPRESSIVITY high amplitude 1.4 power 1"
    found = read_one(tmp_path, gesture(header))
    assert (found.hand, found.categories, found.aimed) == (Hand.BOTH, ("ME", "WE"), True)
    assert found.levels == {
        Level.MEDIUM: Expressivity(repetition=0.35),
        Level.HIGH: Expressivity(amplitude=1.4, tempo=1.2, fluidity=0.35, power=1.0, repetition=0.65),
    }


def test_levels_are_made_from_medium(tmp_path: Path) -> None:
    levels = read_one(tmp_path, gesture("EXPRESSIVITY medium amplitude 0.5 tempo 2 fluidity 0.9 power 0.1")).levels
    low, medium, high = (levels[level] for level in Level)
    assert (low.amplitude, medium.amplitude, high.amplitude) == pytest.approx((0.46, 0.5, 0.6))
    assert (low.tempo, medium.tempo, high.tempo) == pytest.approx((1.94, 2.0, 2.4))
    assert (low.fluidity, medium.fluidity, high.fluidity) == pytest.approx((1.0, 0.9, 0.75))
    assert (low.power, medium.power, high.power) == pytest.approx((0.0, 0.1, 0.35))


@pytest.mark.parametrize("level", Level)
@pytest.mark.parametrize("edge", [0, 1])
def test_derived_levels_stay_in_range(level: Level, edge: int) -> None:
    made = derived_expressivity(level, Expressivity(**{name: limits[edge] for name, limits in RANGES.items()}))
    assert all(least <= getattr(made, name) <= most for name, (least, most) in RANGES.items())


@pytest.mark.parametrize(
    ("header", "line", "column", "told"),
    [
        ("ARMS none", 4, 6, "'none' is not an arm, nor both: one of left, right, both"),
        ("CATEGORY me", 4, 10, "a category is a BML lexeme in capitals: ME"),
        ("CATEGORY ME ME", 4, 13, "duplicate ME"),
        ("LEVELS hihg", 4, 8, "'hihg' is not a level of agitation; did you mean high?"),
        ("LEVELS low low", 4, 12, "duplicate low"),
        ("LEVELS lo\nEXPRESSIVITY high tempo 1", 4, 8, "'lo' is not a level of agitation"),
        ("LEVELS low\nEXPRESSIVITY high tempo 1", 5, 14, "high is not among the LEVELS of this gesture"),
        ("EXPRESSIVITY high speed 1", 4, 19, "'speed' is none of amplitude, tempo, fluidity, power, repetition"),
        ("EXPRESSIVITY high tempo 1 tempo 2", 4, 27, "duplicate tempo"),
        ("EXPRESSIVITY high tempo 3.5", 4, 25, "3.5 is outside 0.25 … 3"),
        ("EXPRESSIVITY high tempo 1\nEXPRESSIVITY high power 1", 5, 1, "duplicate EXPRESSIVITY high"),
        ("TRACK hold chest 0 5 0", 4, 7, "'hold' is not a track's form; did you mean held?"),
        ("TRACK held Chest 0 5 0", 4, 12, "'Chest' is not a joint of tracks; did you mean chest?"),
        ("TRACK held chest 0 50 0", 4, 20, "50 is outside -45 … 45°"),
        ("TRACK held chest 0 0 0", 4, 18, "this track turns nothing"),
        ("TRACK held chest 0 5 0 2", 4, 24, "a track that is held has three angles"),
        ("TRACK circling LowerArm 0 5 0", 4, 7, "a circling track gives its turns"),
        ("TRACK circling LowerArm 0 5 0 9", 4, 31, "9 is outside 0.25 … 6"),
        ("TRACK held chest 0 5", 4, 21, "the line ends too soon; TRACK is written as in: TRACK held chest 0 12 0"),
        ("TRACK held chest 0 5 0\nTRACK held chest 0 6 0", 5, 1, "duplicate TRACK held chest"),
        ("DURATION 3", 4, 1, "duplicate DURATION; the first is in line 3"),
    ],
)
def test_a_wrong_header(tmp_path: Path, header: str, line: int, column: int, told: str) -> None:
    (mistake,) = mistakes_in(tmp_path, gesture(header))
    assert (mistake.line, mistake.column) == (line, column)
    assert told in mistake.message


@pytest.mark.parametrize("line", ["GESTUREINSTANCE trial", "DURATION 2"])
def test_what_a_header_must_have(tmp_path: Path, line: str) -> None:
    (mistake,) = mistakes_in(tmp_path, gesture().replace(line, ""))
    assert f"this gesture has no {line.split(maxsplit=1)[0]}" in mistake.message


def test_a_line_that_could_not_be_read_is_not_missed(tmp_path: Path) -> None:
    """Nor is what it says of the rest: whether the gesture is one of both arms."""
    both = gesture("ARMS both", first="FRAMETYPE stroke_start\nARM XC YCC ZNear\nOTHER HAND form_fist")
    assert len(mistakes_in(tmp_path, both.replace("DURATION 2", "DURATION"))) == 1
    assert len(mistakes_in(tmp_path, gesture().replace("DURATION 2", "DURATION"))) == 1
    assert len(mistakes_in(tmp_path, gesture(last="FRAMETYPE"))) == 1


@pytest.mark.parametrize("duration", ["0", "0.05", "10.1", "-1"])
def test_durations_have_limits(tmp_path: Path, duration: str) -> None:
    (mistake,) = mistakes_in(tmp_path, gesture().replace("DURATION 2", f"DURATION {duration}"))
    assert f"{duration} is outside 0.1 … 10 s" in mistake.message

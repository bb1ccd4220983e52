"""Poses that the body cannot take are told, others not."""

from pathlib import Path

import pytest

from tests.support.motion.gesture_files import gesture, read_one
from understudy.authoring.catalogue import load_gestures
from understudy.model import Level
from understudy.realizer.arms.plausibility import doubts
from understudy.realizer.body.skeleton import Skeleton

SKELETON = Skeleton.standing()


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("ARM XC YCC ZMiddle\nWRIST FBAway PalmInwards", []),
        ("ARM XEP YUpperEP ZFar", ["the wrist stays"]),
        ("ARM XC YCC ZNear\nWRIST FBTowards PalmUp", ["the finger base stays"]),
        ("ARM XC YCC ZMiddle\nWRIST FBDefault PalmDefault", []),
        ("ARM XEP YUpperEP ZFar\nJOINT UpperArm 0 0 0", []),
        ("WRIST FBTowards PalmOutwards", []),
    ],
)
def test_what_a_pose_asks_for(tmp_path: Path, lines: str, told: list[str]) -> None:
    definition = read_one(tmp_path, gesture(last=f"FRAMETYPE stroke_end\n{lines}"))
    found = [doubt for doubt in doubts(SKELETON, definition) if doubt.time == 0.75]
    assert [doubt.message[: len(start)] for doubt, start in zip(found, told, strict=False)] == told
    assert bool(found) == bool(told)


def test_a_gesture_is_looked_at_where_it_is_largest(tmp_path: Path) -> None:
    """Stretched to twice its size, what is far out is out of reach."""
    last = "FRAMETYPE stroke_end\nARM XP YUpperP ZFar"
    small = read_one(tmp_path, gesture(last=last))
    large = read_one(tmp_path, gesture("EXPRESSIVITY low amplitude 2", last=last))
    assert list(doubts(SKELETON, small)) == []
    assert [(doubt.time, doubt.level) for doubt in doubts(SKELETON, large)] == [(0.75, Level.LOW)]


def test_the_other_arm_is_looked_at_too(tmp_path: Path) -> None:
    text = gesture("ARMS both", last="FRAMETYPE stroke_end\nARM XC YCC ZMiddle\nOTHER ARM XEP YUpperEP ZFar")
    assert [doubt.time for doubt in doubts(SKELETON, read_one(tmp_path, text))] == [0.75]


def test_the_library_s_gestures_can_be_made() -> None:
    """One hand in the library points back over the shoulder further than a wrist bends."""
    found = {doubt.definition.name for one in load_gestures().definitions for doubt in doubts(SKELETON, one)}
    assert found <= {"back_palm"}

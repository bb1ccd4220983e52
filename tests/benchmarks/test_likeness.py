"""Which gestures look alike from far away, and their picture."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.realizer.gestures.likeness import HandsPose, StrokePose, draw_silhouettes, likenesses, stroke_pose
from understudy.model import FloatArray, Hand, Level
from understudy.models import load_realizer
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.gestures.gesture import HandForm

DOWN: FloatArray = np.array([0.0, -1.0, 0.0])


@pytest.fixture(scope="module")
def skeleton() -> Skeleton:
    return Skeleton.standing()


@pytest.fixture(scope="module")
def pose(skeleton: Skeleton) -> StrokePose:
    clip = load_realizer().library.clips("STOP", Level.MEDIUM, Hand.RIGHT)[0]
    return stroke_pose(skeleton, clip)


def moved(pose: StrokePose, name: str, by_m: float = 0.0, turned_deg: float = 0.0) -> StrokePose:
    """The pose with the right hand of the stroke's end elsewhere."""
    wrists_m, palms = pose.ends.wrists_m.copy(), np.stack([DOWN, DOWN])
    wrists_m[1, 0] += by_m
    angle = np.radians(turned_deg)
    palms[1] = np.array([np.sin(angle), -np.cos(angle), 0.0])
    return replace(pose, clip=replace(pose.clip, name=name), ends=HandsPose(wrists_m, palms))


@pytest.mark.parametrize(("by_m", "turned_deg", "alike"), [(0.14, 39.0, True), (0.16, 0.0, False), (0.0, 41.0, False)])
def test_15_cm_of_a_wrist_or_40_degrees_of_a_palm_tell_gestures_apart(
    pose: StrokePose, by_m: float, turned_deg: float, alike: bool
) -> None:
    found = list(likenesses([moved(pose, "one"), moved(pose, "other", by_m, turned_deg)]))
    assert [(each.one, each.other, each.twins) for each in found] == ([("one", "other", True)] if alike else [])
    assert not alike or (found[0].apart_m, found[0].apart_deg) == pytest.approx((by_m, turned_deg))


def test_another_form_of_the_hand_tells_them_apart(pose: StrokePose) -> None:
    assert not list(likenesses([pose, replace(pose, form=HandForm.FIST)]))


def test_strokes_that_begin_elsewhere_are_no_twins(pose: StrokePose) -> None:
    elsewhere = HandsPose(pose.begins.wrists_m + 0.2, pose.begins.palms)
    (found,) = likenesses([pose, replace(pose, begins=elsewhere)])
    assert not found.twins


def test_stop_shows_the_palm_to_the_other(pose: StrokePose) -> None:
    """As all the world signs it: the raised hand before the shoulder, its palm to the front."""
    assert pose.ends.palms[1, 2] > 0.7
    assert pose.ends.wrists_m[1, 1] > 1.0


def test_they_are_drawn_black_on_a_light_ground(skeleton: Skeleton, pose: StrokePose) -> None:
    assert draw_silhouettes(skeleton, [pose]).startswith(b"\x89PNG")

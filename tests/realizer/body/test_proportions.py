"""Bodies are as tall as they say, and as wide where they say it."""

import numpy as np
import pytest

from understudy.model.figure import Physique, Sex
from understudy.realizer.body.proportions import AVERAGE, CROWN_M, Proportions
from understudy.realizer.body.skeleton import Skeleton

TRUNK_UP = ("hips", "spine", "chest", "upperChest", "neck", "head")


def skeleton(**said: float) -> Skeleton:
    return Skeleton.standing(Proportions(Physique(**said)))  # type: ignore[arg-type]


def test_the_average_body_is_that_of_the_tables() -> None:
    factors = [getattr(AVERAGE, name) for name in ("scale", "head", "shoulders", "hips")]
    factors += [of(joint) for of in (AVERAGE.width, AVERAGE.depth) for joint in Skeleton.standing().names]
    assert factors == pytest.approx([1.0] * len(factors))


@pytest.mark.parametrize("height_m", [1.45, 1.6, 1.9, 2.05])
def test_a_body_is_as_tall_as_it_says_with_a_head_that_differs_less(height_m: float) -> None:
    body = skeleton(height_m=height_m)
    head_m = body.offsets_m[body.chain(*TRUNK_UP), 1].sum()
    crown_m = CROWN_M * body.proportions.head
    assert head_m + crown_m == pytest.approx(height_m)
    assert abs(body.proportions.head - 1) < abs(body.proportions.scale - 1)
    ankle = body.chain("hips", "leftUpperLeg", "leftLowerLeg", "leftFoot", "leftToes")
    assert body.offsets_m[ankle, 1].sum() == pytest.approx(0.02 * body.proportions.scale), "toes at the sole"


def test_shoulders_and_hips_are_as_wide_as_they_say() -> None:
    average, wide = Skeleton.standing(), skeleton(shoulder_width=1.1, hip_width=1.2)
    for joints, factor in ((("leftShoulder", "leftUpperArm"), 1.1), (("leftUpperLeg",), 1.2)):
        before, after = (body.offsets_m[body.chain(*joints), 0].sum() for body in (average, wide))
        assert after == pytest.approx(factor * before)
    changed = np.nonzero((average.offsets_m != wide.offsets_m).any(axis=1))[0]
    assert {wide.names[joint] for joint in changed} == {
        f"{side}{joint}" for side in ("left", "right") for joint in ("UpperArm", "UpperLeg")
    }


def test_the_sexes_differ_as_people_do_and_age_carries_the_head_forward() -> None:
    woman, man = (Proportions(Physique(sex=sex)) for sex in (Sex.FEMALE, Sex.MALE))
    assert woman.shoulders < 1 < man.shoulders
    assert man.hips < 1 < woman.hips
    assert woman.width("leftUpperArm") < man.width("leftUpperArm")
    neck = Skeleton.standing().index["neck"]
    young, old = (skeleton(age_years=age).offsets_m[neck, 2] for age in (60, 90))
    assert young < old < young + 0.04


def test_a_broad_body_is_thicker_everywhere_most_of_all_at_the_waist() -> None:
    broad = Proportions(Physique(build=1.4))
    parts = {joint: broad.depth(joint) for joint in ("spine", "upperChest", "leftUpperLeg", "neck", "leftHand")}
    assert all(1 < factor < 1.7 for factor in parts.values())
    assert max(parts, key=lambda joint: parts[joint]) == "spine"
    assert broad.scale == 1

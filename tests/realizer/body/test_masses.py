"""Masses are checked against de Leva's whole subjects and the laws of mechanics."""

import numpy as np
import pytest

from understudy.model.figure import Physique, Sex
from understudy.realizer.body.masses import centre_of_mass_m, mass_kg, parts_of
from understudy.realizer.body.proportions import Proportions
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import IDENTITY, from_axis_angle


def body(sex: Sex, height_m: float, build: float = 1.0) -> Skeleton:
    return Skeleton.standing(Proportions(Physique(sex=sex, height_m=height_m, build=build)))


def t_pose(skeleton: Skeleton) -> np.ndarray:
    return np.tile(IDENTITY, (len(skeleton.names), 1))


@pytest.mark.parametrize(("sex", "height_m", "subjects_kg"), [(Sex.FEMALE, 1.735, 61.9), (Sex.MALE, 1.741, 73.0)])
def test_de_levas_subjects_weigh_what_they_weighed(sex: Sex, height_m: float, subjects_kg: float) -> None:
    skeleton = body(sex, height_m)
    assert mass_kg(skeleton) == pytest.approx(subjects_kg, abs=0.3)
    assert sum(part.mass_kg for part in parts_of(skeleton)) == pytest.approx(mass_kg(skeleton), rel=1e-3)


def test_girth_counts_twice() -> None:
    assert mass_kg(body(Sex.MALE, 1.8, 1.2)) == pytest.approx(1.44 * mass_kg(body(Sex.MALE, 1.8)))


def test_the_centre_of_mass_is_in_the_middle_a_little_above_half_the_height() -> None:
    """At 54 to 57 % of the height when arms hang; higher, and with arms at the height of the shoulders."""
    skeleton = Skeleton.standing()
    x, y, _z = centre_of_mass_m(skeleton, *forward(skeleton, t_pose(skeleton), skeleton.offsets_m[0]))
    assert x == pytest.approx(0, abs=1e-12)
    assert 0.54 * 1.73 < y < 0.60 * 1.73


def test_an_arm_that_is_lowered_takes_the_centre_along_by_its_share() -> None:
    skeleton, rotations = Skeleton.standing(), t_pose(Skeleton.standing())
    before = centre_of_mass_m(skeleton, *forward(skeleton, rotations, np.zeros(3)))
    rotations[skeleton.index["leftUpperArm"]] = from_axis_angle((0.0, 0.0, 1.0), np.array(-np.pi / 2))
    after = centre_of_mass_m(skeleton, *forward(skeleton, rotations, np.zeros(3)))
    reach_kg_m, from_joint_m = 0.0, 0.0
    for name in ("UpperArm", "LowerArm", "Hand"):
        part = next(each for each in parts_of(skeleton) if each.joint == "left" + name)
        from_joint_m += skeleton.offsets_m[skeleton.index[part.joint], 0] if name != "UpperArm" else 0.0
        reach_kg_m += part.mass_kg * (from_joint_m + part.centre_m[0])
    moved = reach_kg_m / sum(part.mass_kg for part in parts_of(skeleton))
    np.testing.assert_allclose(after - before, [-moved, -moved, 0], atol=1e-9)


def test_sides_mirror_each_other() -> None:
    parts = {part.joint: part for part in parts_of(Skeleton.standing())}
    for joint, part in parts.items():
        if joint.startswith("left"):
            other = parts["right" + joint.removeprefix("left")]
            assert other.centre_m == (-part.centre_m[0], *part.centre_m[1:])
            assert other.inertia_kg_m2 == part.inertia_kg_m2

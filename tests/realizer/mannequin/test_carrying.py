"""The mannequin is the body that its character has."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.model.figure import Hair, Legwear, Looks, Physique, Sex
from understudy.realizer.body.contacts import build_of
from understudy.realizer.body.proportions import Proportions
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.mannequin.carrying import on_head, t_pose_m
from understudy.realizer.mannequin.skinning import Mannequin

BROAD = Skeleton.standing(Proportions(Physique(Sex.FEMALE, 42, 1.62, 1.3, 1.05, 1.1)))
AVERAGE = Skeleton.standing()


def points(mannequin: Mannequin, *materials: str) -> FloatArray:
    return np.concatenate(
        [part.surface.positions_m for part in mannequin.parts if not materials or part.material in materials]
    )


@pytest.fixture(scope="module")
def broad() -> Mannequin:
    return Mannequin.around(BROAD, Looks(hair=Hair.BUN, legwear=Legwear.SKIRT))


def test_it_stands_on_the_ground_as_tall_as_it_says(broad: Mannequin) -> None:
    heights_m = points(broad)[:, 1]
    assert heights_m.min() == pytest.approx(0.0, abs=0.01)
    assert heights_m.max() == pytest.approx(1.62, abs=0.02)


def test_its_clothes_are_as_wide_and_deep_as_the_volume_that_hands_keep_out_of(broad: Mannequin) -> None:
    jumper, places_m = points(broad, "jumper"), t_pose_m(BROAD)
    for part in build_of(BROAD.proportions):
        if part.part in {"belly", "chest"}:
            at_m = places_m[BROAD.index[part.joint]] + part.end_m
            level = jumper[np.abs(jumper[:, 1] - at_m[1]) < 0.02]
            assert level[:, 0].max() == pytest.approx(at_m[0] + part.radius_m, abs=0.02), part.part
            assert level[:, 2].max() == pytest.approx(at_m[2] + part.radius_m, abs=0.025), part.part


def test_hands_end_where_the_fingers_do_and_all_is_symmetrical(broad: Mannequin) -> None:
    at = points(broad)
    tip_m = t_pose_m(BROAD)[BROAD.index["leftMiddleDistal"], 0]
    assert tip_m < at[:, 0].max() < tip_m + 0.04
    assert at[:, 0].max() == pytest.approx(-at[:, 0].min(), abs=0.003)
    for part in broad.parts:
        assert np.linalg.norm(part.surface.normals, axis=1) == pytest.approx(1.0)
        assert part.weights.sum(axis=1) == pytest.approx(1.0)


def test_a_womans_jaw_is_narrower_than_a_mans_and_the_crown_alike() -> None:
    jaw, crown = np.array([[0.05, -0.02, 0.05]]), np.array([[0.05, 0.15, 0.0]])
    woman, man = (Proportions(Physique(sex)) for sex in (Sex.FEMALE, Sex.MALE))
    assert on_head(jaw, woman)[0, 0] < 0.95 * on_head(jaw, man)[0, 0]
    assert on_head(crown, woman) == pytest.approx(on_head(crown, man), abs=1e-4)


def test_hair_hangs_as_far_as_its_style_and_moves_with_head_or_chest() -> None:
    lowest_m = {}
    for style in Hair:
        found = [part for part in Mannequin.around(AVERAGE, Looks(hair=style)).parts if part.material == "hair"]
        assert bool(found) is (style is not Hair.BALD)
        lowest_m[style] = min((part.surface.positions_m[:, 1].min() for part in found), default=2.0)
        for part in found:
            chest = np.where(part.joints == AVERAGE.index["upperChest"], part.weights, 0.0).sum(axis=1)
            assert bool(chest.max() > 0.99) is (style is Hair.LONG)
    assert lowest_m[Hair.LONG] < lowest_m[Hair.BOB] < lowest_m[Hair.SHORT] < lowest_m[Hair.BALD]

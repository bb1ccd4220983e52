"""Clothes have folds where they bunch; they are shallow, the same on both sides, and nowhere else."""

import numpy as np
import pytest

from understudy.model.figure import Legwear, Sex
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.mannequin.body import FOLDS, drawn_capsules, folded, garments_of
from understudy.realizer.mannequin.carrying import t_pose_m
from understudy.realizer.mannequin.surface import Surface, mesh

BODY = Skeleton.standing()
GARMENTS = {each.material: each for each in garments_of(Sex.NEUTRAL, Legwear.TROUSERS) if each.material in FOLDS}


def plain(material: str) -> Surface:
    garment = GARMENTS[material]
    return mesh(drawn_capsules(garment, BODY), blend_m=garment.blend_m, grid_m=garment.grid_m)


@pytest.mark.parametrize("material", FOLDS)
def test_folds_are_shallow_and_show_in_the_shading(material: str) -> None:
    smooth = plain(material)
    made = folded(smooth, material, BODY)
    moved_m = np.linalg.norm(made.positions_m - smooth.positions_m, axis=1)
    assert 0.0008 < moved_m.max() < 0.003
    assert np.linalg.norm(made.normals, axis=1) == pytest.approx(1)
    tilt = np.degrees(np.arccos(np.clip(np.sum(made.normals * smooth.normals, axis=1), -1, 1)))
    assert 10 < tilt.max() < 45
    assert np.array_equal(made.triangles, smooth.triangles)


def test_folds_are_near_the_joints_that_bend_and_alike_on_both_sides() -> None:
    smooth = plain("jumper")
    made = folded(smooth, "jumper", BODY)
    moved_m = np.linalg.norm(made.positions_m - smooth.positions_m, axis=1)
    elbow_m, upper_m = (t_pose_m(BODY)[BODY.index[name], 0] for name in ("leftLowerArm", "leftUpperArm"))
    across_m = np.abs(smooth.positions_m[:, 0])
    near, between = np.abs(across_m - elbow_m) < 0.03, np.abs(across_m - (elbow_m + upper_m) / 2) < 0.02
    assert moved_m[near].max() > 2 * moved_m[between].max()
    left, right = (np.sort(moved_m[sign * smooth.positions_m[:, 0] > 0.3])[-50:].mean() for sign in (1, -1))
    assert left == pytest.approx(right, rel=0.1)


def test_what_has_no_folds_is_left_as_it_is() -> None:
    smooth = plain("jumper")
    assert folded(smooth, "skin", BODY) is smooth

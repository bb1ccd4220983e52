"""Other skeletons' motion on our body."""

from pathlib import Path

import numpy as np
import pytest

from tests.motion_models.pairs import POINTS, write_bvh, write_points
from understudy.bvh import read_bvh
from understudy.errors import InputError
from understudy.model import FloatArray, Schedule
from understudy.model.formats import MotionFormat
from understudy.models import Understudy
from understudy.motion_models.bodies import BodyTrack, body_of_bvh, body_of_points
from understudy.realization import RealizedSchedule, write_motion
from understudy.realizer.body.skeleton import forward
from understudy.realizer.realizing import Realizer, realize


def positions_m(track: BodyTrack, realizer: Realizer) -> dict[str, FloatArray]:
    """Where our joints are (T, 3) when the body stands and moves so."""
    skeleton = realizer.skeleton
    rotations = np.zeros((len(track.times_s), len(skeleton.names), 4))
    rotations[..., 3] = 1
    rotations[:, skeleton.chain(*track.joints)] = track.rotations
    hips_m = np.tile(skeleton.offsets_m[0], (len(rotations), 1))
    found, _ = forward(skeleton, rotations, hips_m)
    return {name: found[:, place] for place, name in enumerate(skeleton.names)}


@pytest.mark.parametrize("names", ["{}", "mixamorig:{}"])
def test_arms_of_a_file_are_where_it_has_them(tmp_path: Path, understudy: Understudy, names: str) -> None:
    """The right arm hangs, the left one is out to the side, its forearm forwards where it is bent by a right angle."""
    write_bvh(tmp_path, "one", names=names)
    bvh = read_bvh((tmp_path / "one.bvh").read_bytes(), "one.bvh")
    at_m = positions_m(
        body_of_bvh(bvh, "one.bvh", understudy.realizer.skeleton, understudy.realizer.rigs), understudy.realizer
    )
    hanging = at_m["rightLowerArm"] - at_m["rightUpperArm"]
    assert hanging / np.linalg.norm(hanging, axis=1)[:, None] == pytest.approx(
        np.tile([0, -1, 0], (len(hanging), 1)), abs=0.01
    )
    bent = round(np.pi / 2 * 30)
    forearm = at_m["leftHand"][bent] - at_m["leftLowerArm"][bent]
    assert forearm / np.linalg.norm(forearm) == pytest.approx([0, 0, 1], abs=0.02)


def test_our_own_motion_comes_back(understudy: Understudy) -> None:
    """What we write as BVH is read with the same rotations, except hips and legs."""
    realizer, schedule = understudy.realizer, Schedule((), 2.0)
    motion = realize(realizer, schedule)
    content = write_motion(RealizedSchedule(schedule, motion), realizer, MotionFormat.BVH)
    track = body_of_bvh(read_bvh(content, "x.bvh"), "x.bvh", realizer.skeleton, realizer.rigs)
    own = motion.body.rotations[:, realizer.skeleton.chain(*track.joints)]
    assert np.abs((own * track.rotations).sum(axis=-1)).min() > 1 - 1e-6
    assert {"spine", "head", "leftHand", "rightLittleDistal"} <= set(track.joints)
    assert not {"hips", "leftUpperLeg", "leftEye"} & set(track.joints)


def test_arms_of_points_are_where_they_are_seen(tmp_path: Path, understudy: Understudy) -> None:
    """Upper arms hang; the forearms point to the sides at first, and down a quarter of a swing later."""
    write_points(tmp_path, "one", 0)
    with np.load(tmp_path / "one.npz") as file:
        track = body_of_points(file["body"], POINTS, file["body_time_s"].astype(float), 1.0, "one.npz")
    at_m = positions_m(track, understudy.realizer)
    for side, sign in (("left", 1.0), ("right", -1.0)):
        upper = at_m[f"{side}LowerArm"] - at_m[f"{side}UpperArm"]
        assert upper[:, 1] / np.linalg.norm(upper, axis=1) == pytest.approx(-1, abs=0.01)
        lower = at_m[f"{side}Hand"] - at_m[f"{side}LowerArm"]
        lower = lower / np.linalg.norm(lower, axis=1)[:, None]
        assert lower[0] == pytest.approx([sign, 0, 0], abs=0.05)
        assert lower[round(np.pi / 2 * 30)] == pytest.approx([0, -1, 0], abs=0.1)


def test_a_rig_that_is_not_known_is_told_with_its_names(tmp_path: Path, understudy: Understudy) -> None:
    write_bvh(tmp_path, "one", names="b_{}_7")
    bvh = read_bvh((tmp_path / "one.bvh").read_bytes(), "one.bvh")
    with pytest.raises(InputError, match=r"one\.bvh: no joint for hips.* it has b_Hips_7"):
        body_of_bvh(bvh, "one.bvh", understudy.realizer.skeleton, understudy.realizer.rigs)

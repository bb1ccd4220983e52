"""Every character realizes the same schedule as itself: its body, its manner, its files."""

import json
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from tests.support.motion.gltf_reading import read
from understudy.model import Behavior, Channel, Hand, Schedule, SyncPoints
from understudy.model.formats import MotionFormat
from understudy.models import load_realizer
from understudy.realization import RealizedSchedule, Realizer, realize, write_motion
from understudy.realizer.body.contacts import penetrations_m
from understudy.realizer.body.limits import violations
from understudy.realizer.body.skeleton import forward
from understudy.realizer.torso.balance import standing

NAMES = ("default", "expansive", "formal_elder", "reserved")
LEXEMES = ("ME", "SURROUND", "PALMS_TOGETHER", "HAND_ON_HEART", "MIME_BELLY", "UP")
MOST_BYTES = 3_000_000


@pytest.fixture(scope="module")
def realizer() -> Realizer:
    return load_realizer()


def schedule(character: str) -> Schedule:
    """Gestures that come near the body, the belly most of all, then clasped hands."""
    gestures = [
        Behavior(
            id=f"gesture{number}",
            kind=Channel.GESTURE,
            lexeme=lexeme,
            sync=SyncPoints(
                start=2 * number + 0.5, end=2 * number + 2.4, stroke=2 * number + 1.3, relax=2 * number + 2
            ),
            first=0,
            last=0,
            priority=1.0,
            hand=Hand.BOTH,
            amount=0.6,
        )
        for number, lexeme in enumerate(LEXEMES)
    ]
    return Schedule(tuple(gestures), duration_s=14.0, character=character)


@pytest.mark.parametrize("name", NAMES)
def test_hands_stay_outside_joints_within_limits_and_feet_on_the_floor(name: str, realizer: Realizer) -> None:
    skeleton = realizer.performer(name).skeleton
    body = realize(realizer, schedule(name), frame_rate_hz=30).body
    assert penetrations_m(skeleton, body.rotations, body.hips_m).max() < 0.005
    assert np.count_nonzero(violations(skeleton, body.rotations)) == 0
    places_m, _turned = forward(skeleton, body.rotations, body.hips_m)
    for side, foot in zip(("left", "right"), standing(skeleton), strict=True):
        assert np.allclose(places_m[:, skeleton.index[f"{side}Foot"]], foot.ankle_m, atol=1e-6)


def test_who_gestures_wide_reaches_farther_out_than_who_keeps_to_himself(realizer: Realizer) -> None:
    """In lengths of his own arm, for the same gesture at the same amount."""
    reaches = {}
    for name in NAMES:
        skeleton = realizer.performer(name).skeleton
        body = realize(realizer, schedule(name), frame_rate_hz=30).body
        places_m, _turned = forward(skeleton, body.rotations, body.hips_m)
        apart_m = np.linalg.norm(
            np.subtract(*(places_m[:, skeleton.index[f"{side}Hand"]] for side in ("left", "right"))), axis=-1
        )
        arm_m = np.linalg.norm(skeleton.offsets_m[skeleton.chain("leftLowerArm", "leftHand")], axis=1).sum()
        reaches[name] = apart_m.max() / arm_m
    assert reaches["reserved"] < reaches["default"] < reaches["expansive"]


def test_files_have_the_body_of_their_character(realizer: Realizer) -> None:
    heights_m, joints = [], []
    for name in ("formal_elder", "default", "reserved"):
        realized = RealizedSchedule(schedule(name), realize(realizer, schedule(name), frame_rate_hz=30))
        skeleton = realizer.performer(name).skeleton
        clip = json.loads(write_motion(realized, realizer, MotionFormat.JSON))
        assert clip["skeleton"]["joints"][0]["offset_m"] == pytest.approx(list(skeleton.offsets_m[0]), abs=1e-6)
        assert clip["hips_m"][0] == pytest.approx(list(realized.motion.body.hips_m[0]), abs=1e-3)
        bvh = write_motion(realized, realizer, MotionFormat.BVH).decode()
        assert f"OFFSET 0.0000 {100 * skeleton.offsets_m[skeleton.index['spine'], 1]:.4f}" in bvh
        tree = read(write_motion(realized, realizer, MotionFormat.GLB)).tree
        bounded = [each for each in tree["accessors"] if each["type"] == "VEC3" and "max" in each]
        heights_m.append(max(each["max"][1] for each in bounded))
        joints.append([node.get("translation") for node in tree["nodes"]][1])
    assert all(smaller < larger - 0.1 for smaller, larger in pairwise(heights_m))
    assert len({tuple(joint) for joint in joints}) == 3


@pytest.mark.parametrize("name", NAMES)
def test_a_line_with_its_mannequin_is_at_most_three_megabytes(name: str, realizer: Realizer) -> None:
    """Seven seconds of gestures at 60 frames a second."""
    line = replace(schedule(name), behaviors=schedule(name).behaviors[:3], duration_s=7.0)
    realized = RealizedSchedule(line, realize(realizer, line, frame_rate_hz=60))
    assert len(write_motion(realized, realizer, MotionFormat.GLB)) <= MOST_BYTES


def test_who_is_not_in_the_lexicon_has_an_average_body_and_it_is_said(realizer: Realizer) -> None:
    motion = realize(realizer, schedule("somebody"), frame_rate_hz=30)
    assert realizer.performer("somebody") is realizer.average
    assert [each.reason for each in motion.decisions if "somebody" in each.reason] == [
        "no character is called 'somebody': an average body is used"
    ]

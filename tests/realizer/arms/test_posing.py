"""Key poses: wrists where their sectors are, hands as the body sees them, joints within limits, both arms alike."""

from itertools import product

import numpy as np
import pytest

from understudy.model import FloatArray, Hand
from understudy.model.figure import GestureManner
from understudy.realizer.arms.arm_reach import ArmBones
from understudy.realizer.arms.posing import (
    WRIST_ROWS,
    arm_rotations,
    parts_of,
    pose_arm,
    pose_arms,
    wrist_of,
    wrists_of,
)
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.limits import LIMITS, MIRROR, violations
from understudy.realizer.body.skeleton import PARTS, Skeleton, arm_joints, forward
from understudy.realizer.geometry.rotations import IDENTITY, angle_between, rotate
from understudy.realizer.gestures.gesture import (
    ArmKey,
    Bend,
    Depth,
    Finger,
    HandDirection,
    HandForm,
    HandShape,
    HeightSector,
    SectorPlace,
    Sideways,
    Wrist,
)
from understudy.realizer.gestures.gesture_space import sector_m

BODY = Skeleton.standing()
EASY = rest_pose(BODY, Hand.LEFT, "open").as_partial()
SECTORS = [SectorPlace(*sector) for sector in product(Sideways, HeightSector, Depth)]
LOW = (HeightSector.LOWER_P, HeightSector.LOWER_EP)
FORWARD = SectorPlace(Sideways.C, HeightSector.UPPER_C, Depth.FAR)
POINTING = SectorPlace(Sideways.C, HeightSector.UPPER_P, Depth.FAR, (0.0, 0.0, 0.2))
STOP = Wrist(frozenset({HandDirection.UP}), frozenset({HandDirection.AWAY}))


def whole(left: FloatArray | None = None, right: FloatArray | None = None) -> FloatArray:
    """The body in its T-pose but for the arms."""
    rotations = np.tile(IDENTITY, (len(BODY.names), 1))
    for side, arm in ((Hand.LEFT, left), (Hand.RIGHT, right)):
        if arm is not None:
            rotations[BODY.chain(*arm_joints(side))] = arm
    return rotations


def complete(key: ArmKey, side: Hand = Hand.LEFT, aim_m: FloatArray | None = None) -> FloatArray:
    """The arm of a key, at rest in what it leaves open."""
    rest = rest_pose(BODY, side, "open").as_partial()
    return arm_rotations(pose_arm(BODY, side, key, aim_m=aim_m).over(rest).parts)


def placed(arm: FloatArray, side: Hand = Hand.LEFT) -> tuple[FloatArray, FloatArray]:
    """Positions from the hips and orientations of all joints, by the skeleton's own kinematics."""
    rotations = whole(arm) if side is Hand.LEFT else whole(None, arm)
    return forward(BODY, rotations, np.zeros(3))


def test_wrists_reach_nearly_every_sector_above_the_hips() -> None:
    off_m = []
    for place in SECTORS:
        arm = complete(ArmKey(place))
        at, _ = placed(arm)
        wrist_m = at[BODY.index["leftHand"]]
        assert np.allclose(wrist_m, wrist_of(BODY, Hand.LEFT, arm))
        off_m.append(float(np.linalg.norm(wrist_m - sector_m(place))))
    near = [off for off, place in zip(off_m, SECTORS, strict=True) if place.height not in LOW]
    assert np.mean(np.array(near) < 0.02) > 0.75


@pytest.mark.parametrize("place", [FORWARD, SectorPlace(Sideways.OPP_C, HeightSector.LOWER_C, Depth.MIDDLE)])
def test_the_right_arm_mirrors_the_left(place: SectorPlace) -> None:
    key = ArmKey(place, HandShape(HandForm.INDEX), wrist=STOP, shoulder=0.5)
    left, right = (placed(complete(key, side), side)[0] for side in (Hand.LEFT, Hand.RIGHT))
    for joint in arm_joints(Hand.LEFT):
        assert np.allclose(left[BODY.index[joint]] * [-1, 1, 1], right[BODY.index["right" + joint[4:]]])


def test_no_joint_passes_its_limit_in_any_sector_however_the_hand_is_held() -> None:
    directions = [frozenset({direction}) for direction in HandDirection]
    wrists = [Wrist(base, palm) for base, palm in product(directions, directions) if axis(base) != axis(palm)]
    chance = np.random.default_rng(1)
    arms = [
        complete(ArmKey(place, wrist=wrists[index]))
        for place, index in zip(SECTORS, chance.integers(len(wrists), size=len(SECTORS)), strict=True)
    ]
    passed = violations(BODY, np.stack([whole(arm) for arm in arms]))
    assert {LIMITS[limit].joints for limit in np.nonzero(passed)[1]} == set()


def axis(directions: frozenset[HandDirection]) -> int:
    return list(HandDirection).index(next(iter(directions))) // 2


@pytest.mark.parametrize(
    "place",
    [
        FORWARD,
        SectorPlace(Sideways.P, HeightSector.UPPER_P, Depth.MIDDLE),
        SectorPlace(Sideways.C, HeightSector.UPPER_P, Depth.NEAR),
    ],
)
def test_a_hand_that_stops_somebody_does_so_wherever_the_arm_is(place: SectorPlace) -> None:
    _, orientation = placed(complete(ArmKey(place, wrist=STOP)))
    hand = orientation[BODY.index["leftHand"]]
    assert np.dot(rotate(hand, np.array([1.0, 0.0, 0.0])), [0, 1, 0]) > np.cos(np.radians(25))
    assert np.dot(rotate(hand, np.array([0.0, -1.0, 0.0])), [0, 0, 1]) > np.cos(np.radians(25))


def test_a_default_wrist_is_in_line_with_the_forearm() -> None:
    pose = pose_arm(BODY, Hand.LEFT, ArmKey(FORWARD, wrist=Wrist()))
    assert np.allclose(pose.parts[WRIST_ROWS], IDENTITY)


def test_what_a_key_leaves_open_stays_open() -> None:
    assert not pose_arm(BODY, Hand.LEFT, ArmKey()).defined.any()
    assert pose_arm(BODY, Hand.LEFT, ArmKey(FORWARD)).defined.nonzero()[0].tolist() == [0, 1, 2]
    bent = pose_arm(BODY, Hand.LEFT, ArmKey(fingers=((Finger.RING, Bend.CLOSED),)))
    assert [PARTS[row] for row in bent.defined.nonzero()[0]] == ["RingProximal", "RingIntermediate", "RingDistal"]
    raised = pose_arm(BODY, Hand.LEFT, ArmKey(shoulder=1.0))
    assert raised.defined.nonzero()[0].tolist() == [0]


def test_a_raised_shoulder_leaves_the_wrist_where_it_is() -> None:
    level, raised = (pose_arm(BODY, Hand.LEFT, ArmKey(FORWARD, shoulder=shoulder)) for shoulder in (None, 1.0))
    assert angle_between(level.parts[0], raised.parts[0]) > np.radians(10)
    assert level.wrist_m is not None
    assert raised.wrist_m is not None
    assert np.allclose(level.wrist_m, raised.wrist_m, atol=0.01)


def test_fixed_joints_go_over_what_else_is_said_and_mirror() -> None:
    key = ArmKey(FORWARD, joints=(("LowerArm", (30.0, -90.0, 0.0)), ("Hand", (0.0, 0.0, 20.0))))
    left, right = (complete(key, side) for side in (Hand.LEFT, Hand.RIGHT))
    assert np.allclose(left[3], [0, 0, np.sin(np.radians(10)), np.cos(np.radians(10))])
    assert np.allclose(np.abs(np.sum(right[3] * left[3] * MIRROR)), 1.0)
    assert np.allclose(arm_rotations(parts_of(left)), left)


def test_keys_together_say_what_each_says_alone() -> None:
    up = frozenset({HandDirection.UP})
    keys = [
        ArmKey(FORWARD, wrist=STOP),
        ArmKey(hand=HandShape(HandForm.FIST)),
        ArmKey(FORWARD, wrist=Wrist(palm=up), shoulder=1.0),
        ArmKey(wrist=Wrist(finger_base=up)),
        ArmKey(SectorPlace(Sideways.OPP_C, HeightSector.CC, Depth.NEAR), joints=(("Hand", (0.0, 0.0, 5.0)),)),
    ]
    for key, together in zip(keys, pose_arms(BODY, Hand.RIGHT, keys, amplitude=1.1), strict=True):
        alone = pose_arm(BODY, Hand.RIGHT, key, amplitude=1.1)
        assert np.allclose(alone.parts, together.parts, equal_nan=True)
        assert (alone.wrist_m is None) == (together.wrist_m is None)


@pytest.mark.parametrize("aim_m", [(0.5, 0.4, 2.0), (-1.0, 0.2, 1.5), (1.5, 1.0, 0.5)])
def test_a_pointing_hand_is_on_the_line_to_its_target(aim_m: tuple[float, float, float]) -> None:
    target = np.array(aim_m)
    arm = complete(ArmKey(POINTING, HandShape(HandForm.INDEX)), aim_m=target)
    at, orientation = placed(arm)
    wrist_m = at[BODY.index["leftHand"]]
    along = rotate(orientation[BODY.index["leftHand"]], np.array([1.0, 0.0, 0.0]))
    to_target = (target - wrist_m) / np.linalg.norm(target - wrist_m)
    assert np.dot(along, to_target) > np.cos(np.radians(8))
    shoulder_m = at[BODY.index["leftUpperArm"]]
    assert np.linalg.norm(wrist_m - shoulder_m) > 0.9 * ArmBones.of(BODY).length_m


def test_a_manner_turns_elbows_out_and_bends_hands_back() -> None:
    key = ArmKey(place=SectorPlace(Sideways.C, HeightSector.CC, Depth.MIDDLE), wrist=Wrist())
    close, plain, wide = (
        placed(arm_rotations(pose_arm(BODY, Hand.LEFT, key, manner=manner).over(EASY).parts))[0]
        for manner in (GestureManner(elbow_deg=-20), GestureManner(), GestureManner(elbow_deg=30))
    )
    elbow, wrist = BODY.chain("leftLowerArm", "leftHand")
    assert close[elbow, 0] < plain[elbow, 0] - 0.02 < wide[elbow, 0] - 0.06
    assert np.allclose(close[wrist], wide[wrist], atol=0.002), "the hand is where it was"
    straight, bent = (pose_arm(BODY, Hand.LEFT, key, manner=GestureManner(wrist_deg=deg)).parts[4] for deg in (0, 15))
    assert np.degrees(angle_between(straight, bent)) == pytest.approx(15.0)
    limit = pose_arm(BODY, Hand.LEFT, ArmKey(place=key.place, wrist=STOP), manner=GestureManner(wrist_deg=20))
    assert not violations(BODY, whole(arm_rotations(limit.over(EASY).parts))).any()


def test_wrists_of_both_arms_are_those_of_each_seen_from_the_left() -> None:
    rotations = np.random.default_rng(0).normal(size=(6, 2, 19, 4))
    rotations /= np.linalg.norm(rotations, axis=-1, keepdims=True)
    wrists_m = wrists_of(BODY, rotations)
    assert np.allclose(wrists_m[0], wrist_of(BODY, Hand.LEFT, rotations[:, 0]))
    assert np.allclose(wrists_m[1] * [-1.0, 1.0, 1.0], wrist_of(BODY, Hand.RIGHT, rotations[:, 1]))

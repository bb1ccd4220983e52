"""Datagrams of the Virtual Motion Capture protocol, read back by python-osc, which knows nothing of ours."""

import numpy as np
import pytest
from pythonosc.osc_bundle import OscBundle

from understudy.live.avatars.vmc import (
    MOST_BYTES,
    VmcFace,
    VmcParts,
    VmcWriter,
    bundles,
    message,
    message_head,
    unity_name,
)
from understudy.live.body import BodyFrame
from understudy.models import Understudy
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.rotations import from_axis_angle

Y = (0.0, 1.0, 0.0)
Read = list[tuple[str, list[object]]]


def read(datagrams: list[bytes]) -> Read:
    """The messages in order: address and arguments."""
    assert all(len(each) < MOST_BYTES + 1 for each in datagrams)
    return [(each.address, list(each.params)) for datagram in datagrams for each in OscBundle(datagram)]


@pytest.fixture
def skeleton(understudy: Understudy) -> Skeleton:
    return understudy.realizer.skeleton


def frame(skeleton: Skeleton, *, turned: str = "head", by: float = 0.5) -> BodyFrame:
    rotations = np.tile([0.0, 0.0, 0.0, 1.0], (len(skeleton.names), 1))
    rotations[skeleton.names.index(turned)] = from_axis_angle(Y, np.array(by))
    shapes = np.zeros(len(SHAPES))
    shapes[SHAPES.index("jawOpen")] = 0.4
    return BodyFrame(1.25, rotations, np.array([0.1, 0.9, 0.2]), shapes)


def test_every_bone_is_sent_and_the_face_is_applied_last(skeleton: Skeleton) -> None:
    told = read(VmcWriter(skeleton).datagrams(frame(skeleton)))
    bones = {str(arguments[0]): arguments[1:] for address, arguments in told if address == "/VMC/Ext/Bone/Pos"}
    assert len(bones) == len(skeleton.names) == 54
    assert {"Hips", "LeftUpperArm", "RightLittleDistal", "LeftThumbProximal", "LeftThumbIntermediate"} <= bones.keys()
    assert ("/VMC/Ext/OK", [1]) in told
    assert ("/VMC/Ext/T", [1.25]) in told
    assert ("/VMC/Ext/Blend/Val", ["A", pytest.approx(0.4)]) in told
    assert told[-1] == ("/VMC/Ext/Blend/Apply", [])


def test_left_handed_places_and_rotations(skeleton: Skeleton) -> None:
    """A head turned to its own left, which is Unity's -X, turns about +Y by a negative angle there."""
    told = read(VmcWriter(skeleton).datagrams(frame(skeleton, by=0.5)))
    bones = {str(arguments[0]): arguments[1:] for address, arguments in told if address == "/VMC/Ext/Bone/Pos"}
    assert bones["Hips"][:3] == pytest.approx([-0.1, 0.9, 0.2])
    assert bones["Head"][3:] == pytest.approx([0, np.sin(-0.25), 0, np.cos(0.25)])
    left = skeleton.offsets_m[skeleton.names.index("leftUpperArm")]
    assert bones["LeftUpperArm"][:3] == pytest.approx([-left[0], left[1], left[2]], abs=1e-6)
    assert left[0] > 0


@pytest.mark.parametrize(("face", "count"), [(VmcFace.PRESETS, 6), (VmcFace.ARKIT, 52), (VmcFace.NONE, 0)])
def test_parts_can_be_left_out(skeleton: Skeleton, face: VmcFace, count: int) -> None:
    told = read(VmcWriter(skeleton, VmcParts(head=False, face=face)).datagrams(frame(skeleton)))
    assert sum(address == "/VMC/Ext/Blend/Val" for address, _ in told) == count
    assert not any(arguments[:1] in (["Head"], ["Neck"], ["LeftEye"]) for _, arguments in told)
    assert any(address == "/VMC/Ext/Blend/Apply" for address, _ in told) is (count > 0)


def test_thumbs_have_unitys_names() -> None:
    names = ("leftThumbMetacarpal", "rightThumbProximal", "leftThumbDistal", "leftIndexProximal")
    assert [unity_name(name) for name in names] == [
        "LeftThumbProximal",
        "RightThumbIntermediate",
        "LeftThumbDistal",
        "LeftIndexProximal",
    ]


def test_a_message_larger_than_a_bundle_goes_alone() -> None:
    large = message(message_head("/large", "f" * 400), [0.0] * 400)
    assert len(list(bundles([large, large]))) == 2
    assert read([next(iter(bundles([message(message_head("/s", "sf", "abc"), [1.5])])))]) == [("/s", ["abc", 1.5])]

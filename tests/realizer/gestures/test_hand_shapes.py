"""Hand forms: within what fingers can do, and such that fingertips meet, face or miss each other as the form says."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.realizer.body.limits import LIMITS, violations
from understudy.realizer.body.skeleton import FINGER_JOINTS, FINGERS, Skeleton, forward
from understudy.realizer.geometry.rotations import IDENTITY, angle_between, rotate
from understudy.realizer.gestures.gesture import Bend, Finger, HandForm, HandShape, Thumb
from understudy.realizer.gestures.hand_shapes import finger_rows, hand_shape

BODY = Skeleton.standing()
TIP_M = 0.022


def posed(shape: FloatArray) -> FloatArray:
    """The body in its T-pose, but for the left hand's fingers."""
    rotations = np.tile(IDENTITY, (len(BODY.names), 1))
    rotations[BODY.chain(*("left" + joint for joint in FINGER_JOINTS))] = shape
    return rotations


def tips_m(form: HandForm, thumb: Thumb = Thumb.DEFAULT) -> dict[str, FloatArray]:
    """Where the fingertips are from the wrist, by finger."""
    at, turned = forward(BODY, posed(hand_shape(HandShape(form, thumb))), np.zeros(3))
    found = {}
    for finger in FINGERS:
        joint = BODY.index[f"left{finger}Distal"]
        along = BODY.offsets_m[joint] / np.linalg.norm(BODY.offsets_m[joint])
        found[finger] = at[joint] + rotate(turned[joint], along * TIP_M) - at[BODY.index["leftHand"]]
    return found


def apart_m(form: HandForm, finger: str = "Index") -> float:
    tips = tips_m(form)
    return float(np.linalg.norm(tips["Thumb"] - tips[finger]))


@pytest.mark.parametrize("form", HandForm)
@pytest.mark.parametrize("thumb", Thumb)
def test_every_form_keeps_the_fingers_limits(form: HandForm, thumb: Thumb) -> None:
    passed = violations(BODY, posed(hand_shape(HandShape(form, thumb))))
    fingers = [column for column, limit in enumerate(LIMITS) if limit.joints[0].startswith("left")]
    assert passed[fingers].max() == 0


@pytest.mark.parametrize("form", [HandForm.PINCH, HandForm.PINCH_ALL, HandForm.PINCH_OPEN])
def test_a_pinch_brings_thumb_and_index_finger_together(form: HandForm) -> None:
    assert apart_m(form) < 0.02


@pytest.mark.parametrize("form", [HandForm.CEE, HandForm.CEE_ALL, HandForm.CEE_OPEN])
def test_a_c_leaves_a_gap_of_a_few_centimetres(form: HandForm) -> None:
    assert 0.03 < apart_m(form) < 0.08


def test_open_forms_stretch_the_fingers_that_the_closed_ones_bend() -> None:
    for closed, opened in ((HandForm.PINCH, HandForm.PINCH_OPEN), (HandForm.CEE, HandForm.CEE_OPEN)):
        assert tips_m(opened)["Middle"][0] > tips_m(closed)["Middle"][0] + 0.08
    assert tips_m(HandForm.INDEX)["Index"][0] > 0.16
    assert tips_m(HandForm.FIST)["Index"][0] < 0.10


def test_spread_fingers_are_further_apart_than_flat_ones() -> None:
    flat, spread = tips_m(HandForm.FLAT), tips_m(HandForm.SPREAD)
    assert spread["Index"][2] - spread["Little"][2] > flat["Index"][2] - flat["Little"][2] + 0.05
    two, apart = tips_m(HandForm.TWO), tips_m(HandForm.TWO_APART)
    assert apart["Index"][2] - apart["Middle"][2] > two["Index"][2] - two["Middle"][2] + 0.02


def test_a_thumb_goes_out_beside_or_across() -> None:
    thumbs = {thumb: tips_m(HandForm.FLAT, thumb)["Thumb"] for thumb in Thumb}
    assert thumbs[Thumb.OUT][2] > thumbs[Thumb.OPEN][2] + 0.03
    assert thumbs[Thumb.OPEN][2] > thumbs[Thumb.ACROSS][2] + 0.02


def test_a_single_finger_is_bent_on_top_of_the_form() -> None:
    flat = hand_shape(HandShape(HandForm.FLAT))
    for finger in Finger:
        bent = hand_shape(HandShape(HandForm.FLAT), ((finger, Bend.CLOSED),))
        changed = angle_between(flat, bent) > 0.01
        assert changed[finger_rows(finger)].any()
        changed[finger_rows(finger)] = False
        assert not changed.any()

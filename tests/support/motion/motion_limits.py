"""What must hold of every motion, whatever it was made from: shared/motion.md's limits, and no steps between frames."""

from collections.abc import Iterator

import numpy as np

from understudy.model import FloatArray
from understudy.realizer.body.limits import violations
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.head_and_gaze.gaze import EYES

HEAD_DEGREES_S = 250.0
"""In the world, in any frame."""

EYE_DEGREES_S = 850.0
"""In the head; the fastest saccades (Carpenter 1988)."""

JOINT_RAD_S = 20.0
"""Every other joint, and the change of its speed from frame to frame."""

HIPS_M_S = 0.5


def broken_limits(motion: Motion, skeleton: Skeleton) -> list[str]:
    """What the motion breaks, in words; nothing else is measured where a number is none."""
    body = motion.body
    if not all(np.isfinite(each).all() for each in (body.rotations, body.hips_m, motion.shapes)):
        return ["a number that is none"]
    return [*_not_in_range(motion), *_too_fast(motion, skeleton), *_beyond_joints(motion, skeleton)]


def head_speeds_degrees_s(motion: Motion, skeleton: Skeleton) -> FloatArray:
    """The head's speed (T - 1,) in the world."""
    _places, turned = forward(skeleton, motion.body.rotations, motion.body.hips_m)
    head = turned[:, skeleton.index["head"]]
    return np.degrees(angle_between(head[1:], head[:-1])) * motion.frame_rate_hz


def wrist_speeds_m_s(motion: Motion, skeleton: Skeleton) -> FloatArray:
    """The speeds (T - 1, 2) of the left and the right wrist in the world."""
    places_m, _turned = forward(skeleton, motion.body.rotations, motion.body.hips_m)
    wrists_m = places_m[:, skeleton.chain("leftHand", "rightHand")]
    return np.asarray(np.linalg.norm(np.diff(wrists_m, axis=0), axis=2) * motion.frame_rate_hz)


def _not_in_range(motion: Motion) -> Iterator[str]:
    if motion.shapes.min() < 0 or motion.shapes.max() > 1:
        yield f"a face weight of {motion.shapes.min():.3f} or {motion.shapes.max():.3f}"
    if not np.allclose(np.linalg.norm(motion.body.rotations, axis=-1), 1):
        yield "a rotation that is not of unit length"


def _too_fast(motion: Motion, skeleton: Skeleton) -> Iterator[str]:
    body, rate_hz, eyes = motion.body, motion.frame_rate_hz, skeleton.chain(*EYES)
    speeds = angle_between(body.rotations[1:], body.rotations[:-1]) * rate_hz
    head, hips = head_speeds_degrees_s(motion, skeleton), np.linalg.norm(np.diff(body.hips_m, axis=0), axis=1) * rate_hz
    yield from _over("the head", head, HEAD_DEGREES_S)
    yield from _over("an eye", np.degrees(speeds[:, eyes]), EYE_DEGREES_S)
    yield from _over("the hips", hips, HIPS_M_S)
    for joint, name in enumerate(skeleton.names):
        if joint not in eyes:
            yield from _over(name, speeds[:, joint], JOINT_RAD_S)
            yield from _over(f"the speed of {name}", np.abs(np.diff(speeds[:, joint])), JOINT_RAD_S)


def _over(name: str, speeds: FloatArray, limit: float) -> Iterator[str]:
    fastest = float(speeds.max(initial=0.0))
    if fastest > limit * (1 + 1e-6):
        yield f"{name}: {fastest:.4g} where {limit:g} is the most, in frame {int(np.argmax(speeds)) + 1}"


def _beyond_joints(motion: Motion, skeleton: Skeleton) -> Iterator[str]:
    frames = int(np.sum((violations(skeleton, motion.body.rotations) > 0).any(axis=1)))
    if frames:
        yield f"{frames} frames with a joint beyond its limits"

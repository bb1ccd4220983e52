"""A motion made by hand, for the tests of what is made of motions: a wave, a nod, a word spoken, a blink."""

import numpy as np

from understudy.model import FloatArray, SyncPoints
from understudy.realizer.body.motion import SHAPES, BodyMotion, Decision, Motion
from understudy.realizer.body.skeleton import HIPS_HEIGHT_M, Skeleton
from understudy.realizer.geometry.rotations import IDENTITY, from_axis_angle, multiply

BODY = Skeleton.standing()

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def still(frames: int, frame_rate_hz: int = 30) -> Motion:
    """The T-pose for so many frames."""
    body = BodyMotion(
        np.arange(frames) / frame_rate_hz,
        np.tile(IDENTITY, (frames, len(BODY.names), 1)),
        np.tile([0.0, HIPS_HEIGHT_M, 0.0], (frames, 1)),
    )
    return Motion(frame_rate_hz, body, np.zeros((frames, len(SHAPES))), {})


def turned(joint: str, rotation: FloatArray, frames: int = 3) -> Motion:
    """The T-pose but for one joint, turned by a quaternion (4,) or one a frame (T, 4)."""
    motion = still(frames)
    motion.body.rotations[:, BODY.index[joint]] = rotation
    return motion


def waving(duration_s: float = 2.0, frame_rate_hz: int = 30) -> Motion:
    """The right hand waves from the elbow while the left hangs, the head nods, the mouth opens and the eyes blink."""
    plain = still(round(duration_s * frame_rate_hz) + 1, frame_rate_hz)
    times_s, rotations = plain.body.times_s, plain.body.rotations
    rotations[:, BODY.index["leftUpperArm"]] = from_axis_angle(Z, np.array(-1.25))
    rotations[:, BODY.index["rightUpperArm"]] = multiply(
        from_axis_angle(Z, np.array(0.7)), from_axis_angle(Y, np.array(0.4))
    )
    rotations[:, BODY.index["rightLowerArm"]] = from_axis_angle(Z, -1.9 + 0.4 * np.sin(8 * times_s))
    rotations[:, BODY.index["head"]] = from_axis_angle(X, 0.2 * np.sin(4 * times_s))
    rotations[:, BODY.index["rightIndexProximal"]] = from_axis_angle(Z, 0.3 + 0.3 * np.sin(5 * times_s))
    plain.body.hips_m[:, 0] += 0.01 * np.sin(times_s)
    plain.shapes[:, SHAPES.index("jawOpen")] = 0.3 - 0.3 * np.cos(9 * times_s)
    plain.shapes[:, SHAPES.index("eyeBlinkLeft")] = np.clip(1 - np.abs(times_s - 1) / 0.15, 0, 1)
    plain.shapes[:, SHAPES.index("mouthSmileLeft")] = 0.5
    realized = {"wave1": SyncPoints(0.1, 1.9, ready=0.4, stroke_start=0.4, stroke=0.8, stroke_end=1.2, relax=1.4)}
    return Motion(
        frame_rate_hz, plain.body, plain.shapes, realized, (Decision("nod2", "dropped", "the head was taken"),)
    )

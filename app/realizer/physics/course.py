"""What the servos are asked for in every step of a simulation: the kinematic motion, and the torques that go with it.

A servo that only knew where to be would lag behind, by 7° in fast strokes. So it is also told how fast to move (its
damper works against the difference), and given the torque that holds the pose asked for against gravity. What it is not
given is the torque that accelerates the limb: that is where momentum shows. Arms, whose servos are the loosest, are
asked a little early, so that they are there in time, as in NGS §3.4; moves are not shortened as well, since our arms
overshoot and do not fall short. Conventions: MuJoCo's positions, with quaternions w x y z, and velocities, those of
balls in the space of what they turn.

The torques that hold a pose are those of a body that stands still. The floor carries the weight in two points, one
under each foot, such that their common centre is below the centre of mass: then nothing is left over that would move
the hips. What the joints bear is the weight of what is above them, less what the floor pushes.
"""

from dataclasses import dataclass
from math import isclose

import mujoco
import numpy as np

from ...model import FloatArray
from ..body.masses import centre_of_mass_m
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton, forward
from ..geometry.rotations import from_axis_angle, inverse, multiply, normalized, to_rotation_vector
from ..geometry.rotations import with_continuous_signs as continuous
from .physical_body import FEET, STEP_S, PhysicalBody, is_hinge

_TO_WXYZ, _TO_XYZW = [3, 0, 1, 2], [1, 2, 3, 0]
_ARM = ("Shoulder", "UpperArm", "LowerArm", "Hand")

_EARLY_S = 0.033
"""The lag of the wrists without it (`benchmarks.realizer.physics`)."""

HIPS_VALUES = 7
"""Of the free hips in MuJoCo's positions: where they are, and how they are turned."""

Balance = tuple[tuple[float, float], tuple[float, float]]
"""Where the centre of mass should be, and its velocity, both along x and z."""


@dataclass(frozen=True, slots=True, eq=False)
class Course:
    """Per step: the positions asked for (N, nq), the torques beside the springs' (N, nv), and where the centre of mass
    should be; and how many steps make a frame."""

    positions: FloatArray
    torques: FloatArray
    balance: list[Balance]
    steps_per_frame: int


def course_of(physical: PhysicalBody, skeleton: Skeleton, body: BodyMotion) -> Course:
    """What a motion asks of the servos; frames are spaced evenly and a whole number of steps apart."""
    factor = round(float(body.times_s[1] - body.times_s[0]) / STEP_S)
    posed = _positions(physical, body)
    positions, torques = between(posed, factor), between(standing_torques(physical, posed), factor)
    _ask_early(physical, positions, torques)
    positions = _unit(physical, positions)
    torques += physical.model.dof_damping * _velocities(physical, positions)
    places_m, turned = forward(skeleton, body.rotations, body.hips_m)
    centres_m = between(centre_of_mass_m(skeleton, places_m, turned), factor)
    balance = np.stack([centres_m, np.gradient(centres_m, STEP_S, axis=0)], axis=1)[:, :, [0, 2]]
    return Course(positions, torques, balance.tolist(), factor)


def between(values: FloatArray, factor: int) -> FloatArray:
    """A curve (T, C) with `factor` steps from each frame to the next, by a Catmull-Rom spline; (N, C)."""
    around = np.concatenate([values[:1], values, values[-1:]])
    before, start, end, after = (around[first : len(values) - 1 + first, None] for first in range(4))
    share = (np.arange(factor) / factor)[None, :, None]
    cubic = share * (3 * (start - end) + after - before)
    curve = start + share / 2 * (end - before + share * (2 * before - 5 * start + 4 * end - after + cubic))
    return np.concatenate([curve.reshape(-1, values.shape[1]), values[-1:]])


def rotations_of(physical: PhysicalBody, positions: FloatArray) -> FloatArray:
    """The local rotations (T, joints, 4) of MuJoCo's positions, x y z w."""
    found = np.empty((len(positions), len(physical.joints), 4))
    for column, (joint, first) in enumerate(zip(physical.joints, physical.positions, strict=True)):
        if is_hinge(joint):
            found[:, column] = from_axis_angle((1.0, 0.0, 0.0), positions[:, first])
        else:
            start = first + (3 if column == 0 else 0)
            found[:, column] = positions[:, start : start + 4][:, _TO_XYZW]
    return continuous(found)


def _positions(physical: PhysicalBody, body: BodyMotion) -> FloatArray:
    """A motion as MuJoCo's positions, frame by frame."""
    rotations = continuous(body.rotations[:, physical.rows])
    found = np.empty((len(rotations), physical.model.nq))
    found[:, :3] = body.hips_m
    for column, (joint, first) in enumerate(zip(physical.joints, physical.positions, strict=True)):
        turned = rotations[:, column]
        if is_hinge(joint):
            found[:, first] = 2 * np.arctan2(turned[:, 0], turned[:, 3])
        else:
            start = first + (3 if column == 0 else 0)
            found[:, start : start + 4] = turned[:, _TO_WXYZ]
    return found


def _ask_early(physical: PhysicalBody, positions: FloatArray, torques: FloatArray) -> None:
    """Bring forward what is asked of the arms; at the end they are asked to stay."""
    early = min(round(_EARLY_S / STEP_S), len(positions) - 1)
    for joint, start, speed in zip(physical.joints, physical.positions, physical.velocities, strict=True):
        if joint.endswith(_ARM):
            for curve in (positions[:, start : start + 4], torques[:, speed : speed + 3]):
                curve[:-early] = curve[early:].copy()
                curve[-early:] = curve[-1]


def _unit(physical: PhysicalBody, positions: FloatArray) -> FloatArray:
    """The positions with quaternions of unit length."""
    for start, _speed in _balls(physical):
        positions[:, start : start + 4] = normalized(positions[:, start : start + 4])
    return positions


def _velocities(physical: PhysicalBody, positions: FloatArray) -> FloatArray:
    """How fast the joints move; the hips' are left at zero, for they have no servo."""
    found = np.zeros((len(positions), physical.model.nv))
    for start, speed in list(_balls(physical))[1:]:
        turned = positions[:, start : start + 4][:, _TO_XYZW]
        way = to_rotation_vector(multiply(inverse(turned[:-2]), turned[2:]))
        found[1:-1, speed : speed + 3] = way / (2 * STEP_S)
    for joint, start, speed in zip(physical.joints, physical.positions, physical.velocities, strict=True):
        if is_hinge(joint):
            found[:, speed] = np.gradient(positions[:, start], STEP_S)
    return found


def _balls(physical: PhysicalBody) -> list[tuple[int, int]]:
    """Where quaternions begin in the positions, and their rotational velocities; the hips' first."""
    places = zip(physical.joints, physical.positions, physical.velocities, strict=True)
    balls = [(start, speed) for joint, start, speed in places if not is_hinge(joint)]
    (hips, hips_speed), *others = balls
    return [(hips + 3, hips_speed + 3), *others]


def standing_torques(physical: PhysicalBody, positions: FloatArray) -> FloatArray:
    """The torques (T, nv) that hold each pose, given as MuJoCo's positions (T, nq)."""
    model, state = physical.model, mujoco.MjData(physical.model)
    feet, pushed = [model.body(name).id for name in FEET], np.zeros((3, model.nv))
    found = np.zeros((len(positions), model.nv))
    for frame, posed in enumerate(positions):
        state.qpos[:] = posed
        mujoco.mj_kinematics(model, state)
        mujoco.mj_comPos(model, state)
        mujoco.mj_rne(model, state, 0, found[frame])
        for foot, point_m, share in _supports(state, feet):
            mujoco.mj_jac(model, state, pushed, None, point_m, foot)
            found[frame] -= share * physical.weight_n * pushed[1]
    return found


def _supports(state: mujoco.MjData, feet: list[int]) -> list[tuple[int, FloatArray, float]]:
    """The feet, the points where the floor pushes them, and their shares of the weight."""
    (left, right), centre_m = feet, state.subtree_com[0]
    left_m, right_m = state.xpos[left], state.xpos[right]
    apart_m = left_m[0] - right_m[0]
    on_left = 0.5 if isclose(apart_m, 0.0) else min(1.0, max(0.0, (centre_m[0] - right_m[0]) / apart_m))
    aside_m = centre_m - on_left * left_m - (1 - on_left) * right_m
    return [(left, left_m + aside_m, on_left), (right, right_m + aside_m, 1 - on_left)]

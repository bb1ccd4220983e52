"""The torques of a body that stands still: what every joint bears so that a pose stays as it is.

The floor carries the weight in two points, one under each foot, such that their common centre is below the centre of
mass: then nothing is left over that would move the hips. What the joints bear is the weight of what is above them, less
what the floor pushes.
"""

from math import isclose

import mujoco
import numpy as np

from ...model import FloatArray
from .physical_body import FEET, PhysicalBody


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

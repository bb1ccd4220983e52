"""The simulation itself: a body with servos that stands on its feet, step by step.

Balance is by feedback (NGS §3.4): where the centre of mass is not where the motion has it, or moves otherwise, both
ankles push it back. Before the motion begins the body stands in its first pose until it has settled.
"""

from dataclasses import dataclass

import mujoco
import numpy as np

from ...model import FloatArray
from .course import HIPS_VALUES, Balance, Course
from .physical_body import FEET, STEP_S, PhysicalBody

_SETTLING_S = 0.5
_BACK, _BACK_S = 1.0, 0.2
"""What the ankles do against the centre of mass being off, and against its moving: in body weights."""

_FALLEN_M = 0.15
"""How far from where they should be the hips of a body are that falls."""


@dataclass(frozen=True, slots=True, eq=False)
class SimulatedMotion:
    """MuJoCo's positions (F, nq) and where the feet are (F, 2, 3), in every frame until the last or until the body was
    falling."""

    positions: FloatArray
    feet_m: FloatArray
    fell: bool

    @property
    def slide_m(self) -> float:
        """How far a foot slid on the floor, at most."""
        return float(np.linalg.norm((self.feet_m - self.feet_m[0])[:, :, [0, 2]], axis=-1).max())


def simulate(physical: PhysicalBody, course: Course) -> SimulatedMotion:
    """What becomes of a body whose servos are asked for this course."""
    model, state, factor = physical.model, mujoco.MjData(physical.model), course.steps_per_frame
    mujoco.set_mju_user_warning(_told_otherwise)
    frames = (len(course.positions) - 1) // factor + 1
    positions, feet_m = np.empty((frames, model.nq)), np.empty((frames, 2, 3))
    ankles, feet = _Ankles.of(physical), [model.body(name).id for name in FEET]
    state.qpos[:] = course.positions[0]
    mujoco.mj_forward(model, state)
    for _ in range(round(_SETTLING_S / STEP_S)):
        _step(model, state, ankles, course, 0)
    for frame in range(frames):
        positions[frame], feet_m[frame] = state.qpos, state.xpos[feet]
        if not _stands(state, course.positions[frame * factor]):
            return SimulatedMotion(positions[: frame + 1], feet_m[: frame + 1], fell=True)
        for step in range(frame * factor, min((frame + 1) * factor, len(course.positions))):
            _step(model, state, ankles, course, step)
    return SimulatedMotion(positions, feet_m, fell=False)


@dataclass(frozen=True, slots=True, eq=False)
class _Ankles:
    """Where the ankles' torques begin, about x, y and z; what of the body's weight each bears; and where the centre of
    mass was in the last step, x and z, if there was one."""

    places: list[int]
    share_n: float
    last_m: list[float]

    @classmethod
    def of(cls, physical: PhysicalBody) -> "_Ankles":
        places = [physical.velocities[physical.joints.index(name)] for name in FEET]
        return cls(places, physical.weight_n / len(places), [])

    def balance(self, state: mujoco.MjData, asked: Balance) -> None:
        """Add what brings the centre of mass back to the torques of this step. In plain numbers, for speed."""
        x_m, _y_m, z_m = state.subtree_com[0].tolist()
        last_x_m, last_z_m = self.last_m or (x_m, z_m)
        self.last_m[:] = x_m, z_m
        (asked_x_m, asked_z_m), (speed_x, speed_z) = asked
        aside = _BACK * (x_m - asked_x_m) + _BACK_S * ((x_m - last_x_m) / STEP_S - speed_x)
        away = _BACK * (z_m - asked_z_m) + _BACK_S * ((z_m - last_z_m) / STEP_S - speed_z)
        for place in self.places:
            state.qfrc_applied[place] += self.share_n * away
            state.qfrc_applied[place + 2] -= self.share_n * aside


def _step(model: mujoco.MjModel, state: mujoco.MjData, ankles: _Ankles, course: Course, step: int) -> None:
    model.qpos_spring[HIPS_VALUES:] = course.positions[step, HIPS_VALUES:]
    state.qfrc_applied[6:] = course.torques[step, 6:]
    ankles.balance(state, course.balance[step])
    mujoco.mj_step(model, state)


def _told_otherwise(_message: str) -> None:
    """What MuJoCo warns of is that numbers have grown beyond bounds, and that body has fallen. Left to itself it writes
    to a file where the program was started."""


def _stands(state: mujoco.MjData, asked: FloatArray) -> bool:
    """Whether the hips are about where they should be; not so if they are nowhere."""
    return bool(np.linalg.norm(state.qpos[:3] - asked[:3]) < _FALLEN_M)

"""A motion as a body with mass would make it (NGS §3.4): arms swing, wrists overshoot, the trunk gives way; feet stay.

The simulated body stands on its feet by itself, and its soles move less than 2 mm. In the motion that comes out of it
the legs are solved again, from the simulated hips to where the feet were, so that they do not move at all. Fingers and
face are as they were; the eyes look where they looked.

The simulation itself: a body with servos that stands on its feet, step by step.

Balance is by feedback (NGS §3.4): where the centre of mass is not where the motion has it, or moves otherwise, both
ankles push it back. Before the motion begins the body stands in its first pose until it has settled.
"""

from dataclasses import dataclass, replace
from importlib.util import find_spec

import mujoco
import numpy as np

from ...errors import ServiceError
from ...model import FloatArray
from ..body.motion import BodyMotion, Decision
from ..body.skeleton import Skeleton, forward
from ..geometry.rotations import inverse, multiply
from ..torso.balance import feet_of, hips_height_m, set_legs
from .course import HIPS_VALUES, Balance, Course
from .physical_body import FEET, STEP_S, PhysicalBody

_EYES = ("leftEye", "rightEye")


def require_physics() -> None:
    """Raises ServiceError `physics_missing`."""
    if find_spec("mujoco") is None:
        message = "physics needs mujoco, which is not installed: pip install '.[physics]'"
        raise ServiceError("physics_missing", message)


def with_physics(skeleton: Skeleton, body: BodyMotion) -> tuple[BodyMotion, tuple[Decision, ...]]:
    """The motion as servos in a simulated body track it, as long as before; a body that would fall moves without
    physics, and a decision says so. The same motion gives the same motion. Raises ServiceError `physics_missing`."""
    require_physics()
    from .course import course_of, rotations_of  # these import MuJoCo, an extra that most do without
    from .physical_body import physical_body

    physical = physical_body(skeleton)
    simulated = simulate(physical, course_of(physical, skeleton, body))
    if simulated.fell:
        fell_s = body.times_s[len(simulated.positions) - 1]
        told = f"the simulated body would fall at {fell_s:.2f} s: it moves without physics"
        return body, (Decision("", "replaced", told),)
    rotations, hips_m = body.rotations.copy(), simulated.positions[:, :3].copy()
    rotations[:, physical.rows] = rotations_of(physical, simulated.positions)
    feet = feet_of(skeleton, body.rotations, body.hips_m)
    hips_m[:, 1] = np.minimum(hips_m[:, 1], hips_height_m(skeleton, hips_m, rotations[:, 0], feet))
    set_legs(skeleton, rotations, hips_m, feet)
    _keep_looking(skeleton, rotations, _heads(skeleton, body.rotations))
    return replace(body, rotations=rotations, hips_m=hips_m), ()


def _keep_looking(skeleton: Skeleton, rotations: FloatArray, heads: FloatArray) -> None:
    """Turn the eyes back by what the head is turned farther than it was, as people's do (the vestibulo-ocular
    reflex)."""
    back = multiply(inverse(_heads(skeleton, rotations)), heads)
    for eye in skeleton.chain(*_EYES):
        rotations[:, eye] = multiply(back, rotations[:, eye])


def _heads(skeleton: Skeleton, rotations: FloatArray) -> FloatArray:
    """The head's orientation (T, 4) in the world."""
    above = frozenset(skeleton.chain("spine", "chest", "upperChest", "neck", "head"))
    return forward(skeleton, rotations, np.zeros(3), above)[1][:, skeleton.index["head"]]


_SETTLING_S = 0.5

_BACK, _BACK_S = 1.0, 0.2
"""What the ankles do against the centre of mass being off, and against its moving: in body weights."""

_FALLEN_M = 0.15
"""How far from where they should be the hips of a body are that falls."""


@dataclass(frozen=True, slots=True, eq=False)
class Simulated:
    """MuJoCo's positions (F, nq) and where the feet are (F, 2, 3), in every frame until the last or until the body was
    falling."""

    positions: FloatArray
    feet_m: FloatArray
    fell: bool

    @property
    def slide_m(self) -> float:
        """How far a foot slid on the floor, at most."""
        return float(np.linalg.norm((self.feet_m - self.feet_m[0])[:, :, [0, 2]], axis=-1).max())


def simulate(physical: PhysicalBody, course: Course) -> Simulated:
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
            return Simulated(positions[: frame + 1], feet_m[: frame + 1], fell=True)
        for step in range(frame * factor, min((frame + 1) * factor, len(course.positions))):
            _step(model, state, ankles, course, step)
    return Simulated(positions, feet_m, fell=False)


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

"""A motion as a body with mass would make it (NGS §3.4): arms swing, wrists overshoot, the trunk gives way; feet stay.

The simulated body stands on its feet by itself, and its soles move less than 2 mm. In the motion that comes out of it
the legs are solved again, from the simulated hips to where the feet were, so that they do not move at all. Fingers and
face are as they were; the eyes look where they looked.
"""

from dataclasses import replace
from importlib.util import find_spec

import numpy as np

from ...errors import ServiceError
from ...model import FloatArray
from ..body.motion import BodyMotion, Decision
from ..body.skeleton import Skeleton, forward
from ..geometry.rotations import inverse, multiply
from ..torso.balance import feet_of, hips_height_m, set_legs

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
    from .simulation import simulate

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

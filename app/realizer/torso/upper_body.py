"""Adapts arms, shoulders and neck to a moving trunk.

Pointing arms stay on the line from shoulder to target for any stance or lean of the trunk. Poses are computed for an
upright body (`understudy.realizer.arms.posing`), so without this a tilted trunk would make the arm miss its target by
the same angle. The rotation of the upper arm is corrected while the hand approaches, and released with the gesture.

Hanging arms keep hanging straight down while the ribs bend to the side, and stay off the hips. Hands on the hips or in
the pockets go with the pelvis, not with the ribs.

Shrugs and the forward reach of the neck are added after trunk, arms and head are placed. Both collarbones rise with
gestures of uncertainty, and sink as they relax; the arms keep their orientation, so the hands rise with the shoulders
without turning. The neck is inclined in standing, nods with strokes, and is never quite still; the head keeps its
orientation, so gaze and head movements are unchanged.

Conventions: radians; world axes, y up, z forward.
"""

from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Hand, Schedule
from ..arms.displacements import Displacement, PosedArms
from ..arms.rest_poses import rest_pose, resting
from ..body.contacts import PosedBody
from ..body.motion import BodyMotion
from ..body.movement_style import IdleLife
from ..body.skeleton import SIDES, Skeleton
from ..dynamics.take_ends import eased_at_the_ends
from ..geometry.curves import clipped, plateau
from ..geometry.noise import perlin
from ..geometry.rotations import IDENTITY, from_axis_angle, inverse, multiply, rotate, slerp
from ..gestures.gesture_plan import ArmGesture, ArmRest, GesturePlan
from .stance import idle_activity

_TRUNK = ("hips", "spine", "chest", "upperChest")
_LEFT_S = 0.4
"""The time after the gesture's relax in which an arm that moves elsewhere releases its aim."""


def with_aimed_arms(skeleton: Skeleton, body: BodyMotion, arms: Sequence[ArmGesture]) -> BodyMotion:
    """The body, changed in place, with its pointing arms corrected to point at their targets."""
    aimed = [arm for arm in arms if arm.placed.aim_m is not None and not arm.placed.follows]
    if not aimed:
        return body
    for arm in aimed:
        share = _share(arm, body.times_s)
        frames = np.flatnonzero(share > 0)
        body.rotations[frames] = _turned(skeleton, body.rotations[frames], arm, share[frames])
    return body


def _share(arm: ArmGesture, times_s: FloatArray) -> FloatArray:
    """The weight of the correction (T,): it rises from the start of the gesture, and is 1 from the start of the
    stroke."""
    markers = arm.markers
    left_s = max(markers.end, markers.relax + _LEFT_S)
    points_s = np.maximum.accumulate([markers.start, markers.stroke_start, markers.relax, left_s])
    share = np.interp(times_s, points_s, [0.0, 1.0, 1.0, 0.0])
    return np.asarray(share * share * (3 - 2 * share))


def _turned(skeleton: Skeleton, rotations: FloatArray, arm: ArmGesture, share: FloatArray) -> FloatArray:
    """Local rotations with the upper arm turned back, by its share, against the trunk's rotation from upright."""
    chest = rotations[:, 0]
    for joint in skeleton.chain(*_TRUNK[1:]):
        chest = multiply(chest, rotations[:, joint])
    collarbone, upper = skeleton.chain(f"{arm.side.value}Shoulder", f"{arm.side.value}UpperArm")
    carrying = multiply(chest, rotations[:, collarbone])
    upright = slerp(np.broadcast_to(IDENTITY, chest.shape), inverse(chest), share)
    turned = multiply(upright, multiply(carrying, rotations[:, upper]))
    result = rotations.copy()
    result[:, upper] = multiply(inverse(carrying), turned)
    return result


_HANGS, _WHOLLY = 0.80, 0.95
"""The drop of the upper arm, as a share of its length, from which on and at which it counts as hanging."""
_STRAIGHT = 0.85
"""The share of the ribs' tilt for which a hanging arm is compensated."""
_FORWARD = (0.0, 0.0, 1.0)
_INWARDS: FloatArray = np.array([-1.0, 1.0])
"""Along x, to the left, in the left and the right arm's own space."""


def with_hanging_arms(skeleton: Skeleton, body: BodyMotion) -> BodyMotion:
    """The body, changed in place, with hanging arms that do not follow the sideways tilt of the ribs."""
    rotations = body.rotations
    chest = rotations[:, 0]
    for joint in skeleton.chain(*_TRUNK[1:]):
        chest = multiply(chest, rotations[:, joint])
    tilt = np.arctan2(*_up(chest)[:2])
    arms = skeleton.arms(rotations)
    carrying = multiply(chest[:, None], arms[:, :, 0])
    turned = multiply(carrying, arms[:, :, 1])
    straight = from_axis_angle(_FORWARD, _STRAIGHT * tilt[:, None] * _hanging(turned))
    arms[:, :, 1] = multiply(inverse(carrying), multiply(straight, turned))
    return body


def _up(q: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Where rotations (…, 4) take the y axis: x, y and z, each (…)."""
    x, y, z, w = (q[..., part] for part in range(4))
    return 2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)


def _hanging(upper_arms: FloatArray) -> FloatArray:
    """How much a left and a right arm with these orientations (T, 2, 4) hang (T, 2): 0 to 1."""
    x, y, z, w = (upper_arms[..., part] for part in range(4))
    down = _INWARDS * (2 * (x * y + w * z))
    share = clipped((down - _HANGS) / (_WHOLLY - _HANGS), 0.0, 1.0)
    return np.asarray(share * share * (3 - 2 * share))


_SETTLES_S = 0.45
"""The time before and after a rest over which a hand begins and ceases to go with the pelvis."""
_FRAMES_AT_ONCE = 2048
"""Frames displaced at a time, so that long takes need little more memory."""


def with_hands_on_pelvis(skeleton: Skeleton, body: BodyMotion, plan: GesturePlan) -> BodyMotion:
    """The body, changed in place, with the hands that rest on hips or in pockets carried by the pelvis, whatever the
    ribs do."""
    rests = [rest for rest in plan.rests if resting(rest.pose, rest.side).on_pelvis]
    if not rests:
        return body
    times_s = eased_at_the_ends(body.times_s, plan.style.ends.eased_s)
    shares = np.zeros((len(SIDES), len(times_s)))
    places_m = np.zeros((len(SIDES), len(times_s), 3))
    for rest in rests:
        begins_s, ends_s = rest.start_s - _SETTLES_S, rest.end_s + _SETTLES_S
        share = plateau(times_s, begins_s, rest.start_s, rest.end_s, ends_s)
        shares[SIDES.index(rest.side)] += share
        places_m[SIDES.index(rest.side)] += share[:, None] * _at_rest_m(skeleton, rest)
    moved, arms = np.flatnonzero(shares.any(axis=0)), skeleton.arms(body.rotations)[:, :, 1:4]
    for first in range(0, len(moved), _FRAMES_AT_ONCE):
        frames = moved[first : first + _FRAMES_AT_ONCE]
        posed = PosedBody.of(skeleton, body.rotations[frames], body.hips_m[frames])
        carried_m = _carried_m(skeleton, posed, shares[:, frames], places_m[:, frames])
        arms[frames] = PosedArms.of(skeleton, posed).displaced(Displacement.of_wrists(carried_m))
    return body


def _at_rest_m(skeleton: Skeleton, rest: ArmRest) -> FloatArray:
    """Where a wrist at rest is on the upright body (3,)."""
    return np.asarray(
        rest_pose(skeleton, rest.side, rest.pose).wrist_m * [1.0 if rest.side is Hand.LEFT else -1.0, 1.0, 1.0]
    )


def _carried_m(skeleton: Skeleton, posed: PosedBody, share: FloatArray, place_m: FloatArray) -> FloatArray:
    """How far (2, F, 3) wrists that are at rest by these shares (2, F) are from where the chest carries them, if the
    pelvis carries them; `place_m` (2, F, 3) is that share of their places."""
    hips, *spine, chest = skeleton.chain(*_TRUNK)
    upright_m = share[..., None] * np.sum(skeleton.offsets_m[[*spine, chest]], axis=0)
    by_pelvis_m = rotate(posed.orientations[:, hips], place_m)
    by_chest_m = rotate(posed.orientations[:, chest], place_m - upright_m)
    between_m = posed.positions_m[:, hips] - posed.positions_m[:, chest]
    return np.asarray(share[..., None] * between_m + by_pelvis_m - by_chest_m)


LIFTS_DEG: Mapping[str, float] = MappingProxyType(
    {"SHRUG": 14.0, "UNCERTAINTY": 12.0, "INDIFFERENCE": 11.0, "QUESTION": 5.0}
)
"""The lift of the shoulders in each gesture at its usual size; people's is 10 to 15°."""

LEAST, MOST = 0.75, 1.2
"""The factors of the lift in the smallest and the largest gestures; smaller shrugs would be invisible."""

SOONER_S = 0.06
"""The time by which the shoulders are up before the hands."""

SHORTEST_S = 0.35
"""The minimum time for which the shoulders stay up."""
DOWN_S = 0.45
_AXIS = (0.0, 0.0, 1.0)
_RISING: Mapping[Hand, float] = MappingProxyType({Hand.LEFT: 1.0, Hand.RIGHT: -1.0})

_WEAKER = 0.92
"""The shoulder of the arm that does not gesture rises less."""


def with_shrugs(skeleton: Skeleton, body: BodyMotion, plan: GesturePlan) -> BodyMotion:
    """The body, changed in place, with its shoulders lifted by the plan's shrugs."""
    shrugs = [each for each in plan.gestures if each.placed.clip.category in LIFTS_DEG]
    if not shrugs:
        return body
    rotations = body.rotations
    for side in (Hand.LEFT, Hand.RIGHT):
        raised = from_axis_angle(_AXIS, _RISING[side] * _lift(body.times_s, shrugs, side))
        collarbone, arm = skeleton.chain(f"{side.value}Shoulder", f"{side.value}UpperArm")
        before = rotations[:, collarbone].copy()
        rotations[:, collarbone] = multiply(raised, before)
        rotations[:, arm] = multiply(multiply(inverse(rotations[:, collarbone]), before), rotations[:, arm])
    return body


def _lift(times_s: FloatArray, shrugs: Iterable[ArmGesture], side: Hand) -> FloatArray:
    """How far the shoulder of this side is lifted (T,): by the strongest shrug, if there are several at once."""
    lift = np.zeros(len(times_s))
    for arm in shrugs:
        markers, placed = arm.markers, arm.placed
        up_s = max(markers.stroke_end - SOONER_S, markers.stroke_start + 0.05)
        left_s = max(markers.relax, up_s + SHORTEST_S)
        size = min(max(placed.size, LEAST), MOST) * (1.0 if arm.side is side else _WEAKER)
        course = plateau(times_s, markers.stroke_start - 0.1, up_s, left_s, left_s + DOWN_S)
        lift = np.maximum(lift, np.radians(LIFTS_DEG[placed.clip.category]) * size * course)
    return lift


_NECK_HZ = 0.4


def with_neck_reaching(
    skeleton: Skeleton, body: BodyMotion, schedule: Schedule, strokes: FloatArray, *, seed: int, life: IdleLife
) -> BodyMotion:
    """The body, changed in place, with its neck inclined, by itself and by `strokes` (T,). Deterministic for a seed."""
    noise = perlin(body.times_s, frequency_hz=_NECK_HZ, seed=seed + 4)[:, 0]
    forward = np.radians(life.neck_forward_deg + life.neck_deg * idle_activity(schedule) * noise) + strokes
    neck, head = skeleton.chain("neck", "head")
    before = body.rotations[:, neck].copy()
    body.rotations[:, neck] = multiply(from_axis_angle((1.0, 0.0, 0.0), forward), before)
    body.rotations[:, head] = multiply(inverse(body.rotations[:, neck]), multiply(before, body.rotations[:, head]))
    return body

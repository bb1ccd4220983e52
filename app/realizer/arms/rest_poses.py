"""Rest poses of the arms between gestures: at the side, clasped, folded, behind the back, in pockets, on hips, open;
and those in which hands wait for the next gesture (`Wait`), by level of agitation and by the hand that leads.

Conventions as in `posing`: positions seen from the arm's own side, metres from the hips, x outwards, y up, z away;
swivels in degrees, elbow outwards. Where one hand or arm lies on the other, the left is on top. The positions keep
forearms and hands 15 mm from the body (with the radii of `build`) and each other, to leave room for idle noise.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import product
from types import MappingProxyType

import numpy as np

from ...model import Hand, Level
from ...model.figure import Wait
from ..body.body_space import on_body_m
from ..body.contacts import Point
from ..body.limits import MIRROR
from ..body.skeleton import Skeleton
from ..gestures.gesture import Bend, Finger, HandForm, HandShape, Thumb
from ..gestures.hand_shapes import hand_shape
from .arm_reach import ArmBones
from .posing import ArmPose, arm_rotations, solve_arm

_EASY = HandShape(HandForm.DEFAULT)
BEHIND_BACK = "behind_back"
_FOUR = (Finger.INDEX, Finger.MIDDLE, Finger.RING, Finger.LITTLE)


@dataclass(frozen=True, slots=True)
class Rest:
    """An arm at rest: wrist position, directions of fingers and palm, elbow swivel in degrees, and hand shape.

    A hand that is ready before the belly rides on stressed words, higher by the level `ready_at`; one that `holds` the
    other cannot stay when that leaves; one `on_pelvis` goes where the pelvis goes.
    """

    wrist_m: Point
    finger_base: Point
    palm: Point
    swivel_deg: float = 0.0
    hand: HandShape = _EASY
    fingers: tuple[tuple[Finger, Bend], ...] = ()
    ready_at: Level | None = None
    holds: bool = False
    on_pelvis: bool = False


_CURVED = tuple((finger, Bend.CURVED) for finger in _FOUR)
HANGING = Rest((0.266, -0.094, 0.030), (-0.06, -1.0, 0.16), (-1.0, 0.05, -0.45), -18.0)
_STIFF = HandShape(HandForm.FLAT, Thumb.OUT)
_IN_POCKETS = Rest((0.232, 0.015, 0.065), (-0.10, -1.0, 0.20), (-1.0, 0.1, -0.1), 5.0, _STIFF, on_pelvis=True)
_ON_HIPS = Rest((0.225, 0.090, 0.010), (-0.35, -0.45, 0.85), (-0.7, -0.6, -0.5), 46.0, _STIFF, on_pelvis=True)
_OPEN = Rest((0.250, 0.110, 0.200), (-0.35, -0.15, 1.0), (-0.9, 0.25, -0.3))

LAPS: Mapping[Level, str] = MappingProxyType({Level.LOW: "lap_low", Level.MEDIUM: "lap", Level.HIGH: "lap_high"})
"""Both hands before the belly, ready to go on."""
LIFTED = "lifted"
"""Where the beats of hands before the belly come from."""
_LAP_HEIGHTS_M: Mapping[Level, float] = MappingProxyType({Level.LOW: 0.190, Level.MEDIUM: 0.220, Level.HIGH: 0.275})
_LIFTED_M = 0.40


def _before_the_belly(up_m: float, level: Level | None) -> tuple[Rest, Rest]:
    return (
        Rest((0.150, up_m, 0.230), (-0.62, -0.12, 0.78), (-0.55, -0.75, -0.40), 4.0, ready_at=level),
        Rest((0.162, up_m + 0.022, 0.246), (-0.50, -0.02, 0.86), (-0.70, -0.55, -0.42), 7.0, ready_at=level),
    )


def _waiting(wait: Wait, level: Level) -> tuple[Rest, Rest]:
    """The arm that leads and the other one."""
    up_m = _LAP_HEIGHTS_M[level]
    before, _right = _before_the_belly(up_m, level)
    farther = Rest((0.215, up_m + 0.075, 0.270), (-0.30, 0.20, 0.93), (-0.80, -0.45, -0.16), 10.0, ready_at=level)
    lower = Rest((0.140, up_m - 0.030, 0.205), (-0.75, -0.25, 0.60), (-0.45, -0.60, -0.75), 2.0, ready_at=level)
    higher = Rest((0.270, up_m + 0.060, 0.230), (-0.25, 0.0, 1.0), (-0.8, 0.6, -0.2), 14.0, ready_at=level)
    aside = Rest((0.270, up_m - 0.080, 0.170), (-0.30, -0.20, 0.95), (-0.9, 0.2, -0.25), 4.0, ready_at=level)
    across = Rest((-0.075, 0.170, 0.215), (-1.0, -0.05, -0.10), (0.1, -0.2, -1.0), 20.0, _EASY, _CURVED, holds=True)
    return {
        Wait.BELLY: (before, before),
        Wait.UNEVEN: (farther, lower),
        Wait.ONE: (before, HANGING),
        Wait.HIP: (farther, _ON_HIPS),
        Wait.POCKET: (before, _IN_POCKETS),
        Wait.FOREARM: (across, HANGING),
        Wait.OPEN: (higher, aside),
    }[wait]


def waiting_pose(wait: Wait, level: Level, leading: Hand) -> str:
    """The name of the rest in which hands wait so."""
    return LAPS[level] if wait is Wait.BELLY else f"{wait} {level} {leading}"


def _waits() -> Iterator[tuple[str, tuple[Rest, Rest]]]:
    for wait, level, leading in product(Wait, Level, (Hand.LEFT, Hand.RIGHT)):
        leads, other = _waiting(wait, level)
        if wait is not Wait.BELLY:
            yield waiting_pose(wait, level, leading), (leads, other) if leading is Hand.LEFT else (other, leads)


WAITS: Mapping[str, tuple[Rest, Rest]] = MappingProxyType(
    {
        **{LAPS[level]: _before_the_belly(up_m, level) for level, up_m in _LAP_HEIGHTS_M.items()},
        **dict(_waits()),
    }
)
"""The rests in which hands wait between two gestures, which no posture asks for."""

RESTS: Mapping[str, tuple[Rest, Rest]] = MappingProxyType(
    {
        "at_side": (HANGING, HANGING),
        "clasped": (
            Rest((0.124, 0.075, 0.230), (-0.90, -0.40, 0.10), (-0.1, -0.3, -1.0), 8.0, _EASY, _CURVED, holds=True),
            Rest((0.132, 0.046, 0.162), (-0.90, -0.40, 0.05), (-0.1, 0.1, -1.0), 8.0, _EASY, _CURVED, holds=True),
        ),
        "folded": (
            Rest((-0.050, 0.270, 0.240), (-1.0, -0.05, -0.30), (0.3, -0.4, -1.0), 22.0),
            Rest((0.045, 0.153, 0.170), (-1.0, -0.10, 0.05), (0.0, -0.3, -1.0), 30.0),
        ),
        BEHIND_BACK: (
            Rest((0.159, 0.040, -0.175), (-1.0, -0.35, -0.1), (-0.1, 0.0, -1.0), 0.0, _EASY, _CURVED),
            Rest((0.080, -0.010, -0.215), (-1.0, -0.30, -0.1), (-0.1, 0.0, -1.0), 0.0, _EASY, _CURVED),
        ),
        LIFTED: _before_the_belly(_LIFTED_M, None),
        **WAITS,
        "in_pockets": (_IN_POCKETS, _IN_POCKETS),
        "on_hips": (_ON_HIPS, _ON_HIPS),
        "open": (_OPEN, _OPEN),
    }
)
"""By name, the rest of the left and of the right arm."""


@lru_cache(maxsize=128)
def rest_pose(skeleton: Skeleton, side: Hand, name: str) -> ArmPose:
    """The pose of the arm `side` at rest; `name` is one of `RESTS`. Cached per skeleton."""
    rest = resting(name, side)
    wrist_m, finger_base, palm = np.array([rest.wrist_m, rest.finger_base, rest.palm])
    wrist_m = on_body_m(skeleton, wrist_m)
    arm = solve_arm(ArmBones.of(skeleton), wrist_m, finger_base, palm, rest.swivel_deg)
    rotations = arm_rotations(np.concatenate([arm, hand_shape(rest.hand, rest.fingers)]))
    rotations = rotations if side is Hand.LEFT else rotations * MIRROR
    rotations.setflags(write=False)
    return ArmPose(rotations, wrist_m)


def resting(pose: str, side: Hand) -> Rest:
    """An arm of the rest of this name."""
    return RESTS[pose][0 if side is Hand.LEFT else 1]

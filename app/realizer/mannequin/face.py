"""The mannequin's face rig: a displacement field for each of ARKit's 52 blendshapes, and visemes as mixtures of them.

Conventions: metres in the space of the head joint, x to the character's left; pulls are in millimetres. A pull
displaces the tissue around its centre, falling off as a Gaussian of width `reach`. Shapes of the left side are given,
those of the right are mirror images. For lids and eyeballs see `understudy.realizer.mannequin.eyes`: eyeballs rotate
with the eye joints only, so `eyeLook` shapes just move the lids.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum, auto
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ..body.motion import SHAPES
from ..face.face_tables import VISEMES
from ..geometry.rotations import from_axis_angle, rotate

MOUTH_Y_M = 0.017
"""The height of the line between the closed lips."""

MOUTH_HALF_M = 0.0295
JAW_HINGE_M = np.array([0.0, 0.035, 0.005])
JAW_OPEN_DEGREES = 15.0
JAW_MOVES_MM: Mapping[str, tuple[float, float, float]] = MappingProxyType(
    {"jawForward": (0, 0, 9), "jawLeft": (9, 0, 0), "jawRight": (-9, 0, 0)}
)
_MM = 1e-3


class Lip(Enum):
    """Which side of the mouth's line a pull affects."""

    BOTH = auto()
    UPPER = auto()
    LOWER = auto()


@dataclass(frozen=True, slots=True)
class Pull:
    """Displaces the face around `centre_mm` (x, y) by `move_mm`, with Gaussian widths `reach_mm` (x, y)."""

    centre_mm: tuple[float, float]
    reach_mm: tuple[float, float]
    move_mm: tuple[float, float, float]
    lip: Lip = Lip.BOTH


@dataclass(frozen=True, slots=True, eq=False)
class Tissue:
    """What the shapes deform: points (V, 3), how far each follows the jaw (V,), how far it is below the line of the
    lips (V,), how much it belongs to the lips (V,), all in [0, 1]. Points inside the mouth are not affected by pulls.
    """

    points_m: FloatArray
    jaw: FloatArray
    below: FloatArray
    lip: FloatArray
    inside: bool = False
    own: Mapping[str, FloatArray] = field(default_factory=dict)


_LEFT_PULLS: Mapping[str, tuple[Pull, ...]] = MappingProxyType(
    {
        "mouthSmileLeft": (
            Pull((32, 17), (16, 14), (9, 10, -6)),
            Pull((44, 43), (17, 16), (2, 5, 4)),
        ),
        "mouthFrownLeft": (Pull((31, 15), (14, 13), (1, -10, -2)),),
        "mouthDimpleLeft": (Pull((33, 17), (12, 12), (5, 1, -6)),),
        "mouthStretchLeft": (Pull((33, 14), (17, 16), (10, -4, -5)),),
        "mouthPressLeft": (
            Pull((12, 22), (16, 8), (1, -2.5, -2), Lip.UPPER),
            Pull((12, 11), (16, 8), (1, 2.5, -2), Lip.LOWER),
        ),
        "mouthUpperUpLeft": (Pull((15, 23), (14, 11), (0, 8, 1), Lip.UPPER),),
        "mouthLowerDownLeft": (Pull((15, 10), (14, 11), (0, -8, 1), Lip.LOWER),),
        "cheekSquintLeft": (Pull((38, 50), (16, 13), (0, 6.5, 5)),),
        "noseSneerLeft": (
            Pull((12, 48), (9, 11), (1.5, 6, 1)),
            Pull((14, 26), (9, 9), (0, 3, 0), Lip.UPPER),
        ),
        "browDownLeft": (
            Pull((16, 97), (10, 12), (-3, -8, 2)),
            Pull((36, 100), (15, 12), (-2, -6, 1.5)),
        ),
        "browOuterUpLeft": (Pull((44, 101), (15, 17), (0, 9, -2.5)),),
        "mouthLeft": (Pull((0, 17), (26, 17), (11, 0, -2)),),
    }
)
_MIDDLE_PULLS: Mapping[str, tuple[Pull, ...]] = MappingProxyType(
    {
        "browInnerUp": (
            Pull((14, 99), (11, 16), (1, 10, -2)),
            Pull((-14, 99), (11, 16), (-1, 10, -2)),
        ),
        "cheekPuff": (
            Pull((42, 20), (17, 17), (9, 0, 6)),
            Pull((-42, 20), (17, 17), (-9, 0, 6)),
        ),
        "mouthPucker": (
            Pull((29, 17), (17, 14), (-15, 0, 6)),
            Pull((-29, 17), (17, 14), (15, 0, 6)),
            Pull((0, 17), (13, 13), (0, 0, 8)),
        ),
        "mouthFunnel": (
            Pull((29, 17), (16, 14), (-10.5, 0, 5)),
            Pull((-29, 17), (16, 14), (10.5, 0, 5)),
            Pull((0, 22), (15, 10), (0, 5, 7), Lip.UPPER),
            Pull((0, 11), (15, 10), (0, -7, 7), Lip.LOWER),
        ),
        "mouthRollLower": (Pull((0, 11), (22, 8), (0, 4, -6), Lip.LOWER),),
        "mouthRollUpper": (Pull((0, 22), (22, 8), (0, -4, -6), Lip.UPPER),),
        "mouthShrugLower": (
            Pull((0, 9), (20, 11), (0, 6, 3), Lip.LOWER),
            Pull((0, 21), (20, 8), (0, 4, 2), Lip.UPPER),
            Pull((0, -8), (18, 12), (0, 4, 2)),
        ),
        "mouthShrugUpper": (Pull((0, 23), (20, 10), (0, 5, 3), Lip.UPPER),),
    }
)

VISEME_MIXTURES: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "sil": {},
        "PP": {"mouthPress": 0.7, "mouthRollLower": 0.4, "mouthRollUpper": 0.4},
        "FF": {"jawOpen": 0.08, "mouthRollLower": 0.8, "mouthUpperUp": 0.4},
        "TH": {"jawOpen": 0.22, "tongueOut": 0.4, "mouthLowerDown": 0.2, "mouthUpperUp": 0.1},
        "DD": {"jawOpen": 0.18, "mouthLowerDown": 0.3, "mouthStretch": 0.1},
        "kk": {"jawOpen": 0.24, "mouthStretch": 0.2, "mouthUpperUp": 0.15},
        "CH": {"jawOpen": 0.14, "mouthFunnel": 0.7, "mouthPucker": 0.2},
        "SS": {"jawOpen": 0.06, "mouthStretch": 0.4, "mouthLowerDown": 0.35, "mouthUpperUp": 0.25},
        "nn": {"jawOpen": 0.14, "mouthLowerDown": 0.15, "mouthStretch": 0.15},
        "RR": {"jawOpen": 0.14, "mouthFunnel": 0.35, "mouthPucker": 0.35},
        "aa": {"jawOpen": 0.75, "mouthLowerDown": 0.2, "mouthUpperUp": 0.15},
        "E": {"jawOpen": 0.42, "mouthStretch": 0.35, "mouthSmile": 0.25},
        "I": {"jawOpen": 0.22, "mouthSmile": 0.45, "mouthStretch": 0.35},
        "O": {"jawOpen": 0.5, "mouthFunnel": 0.55, "mouthPucker": 0.2},
        "U": {"jawOpen": 0.16, "mouthPucker": 0.85, "mouthFunnel": 0.2},
    }
)
"""The fifteen visemes of docs/references.md as mixtures of shapes; a name without a side stands for both."""

FACE_SHAPES: tuple[str, ...] = (*SHAPES, *(f"viseme_{name}" for name in VISEMES))


def displacements_m(tissue: Tissue) -> dict[str, FloatArray]:
    """The displacement (V, 3) by each shape of `FACE_SHAPES` that affects the tissue."""
    found = {**_jaw_displacements(tissue), **tissue.own}
    if not tissue.inside:
        found["mouthClose"] = -tissue.lip[:, None] * found["jawOpen"]
        for name, pulls in (*_LEFT_PULLS.items(), *_MIDDLE_PULLS.items()):
            found[name] = _pulled(tissue, pulls) + found.get(name, 0.0)
        for name, pulls in _LEFT_PULLS.items():
            right = name.removesuffix("Left") + "Right"
            found[right] = _pulled(tissue, tuple(_mirrored(pull) for pull in pulls)) + tissue.own.get(right, 0.0)
    for name, mixture in VISEME_MIXTURES.items():
        found[f"viseme_{name}"] = _mixed(tissue, found, mixture)
    return {name: moved for name, moved in found.items() if np.abs(moved).max(initial=0) > 1e-5}


def _jaw_displacements(tissue: Tissue) -> dict[str, FloatArray]:
    """The jaw rotates about its hinge, and slides."""
    from_hinge = tissue.points_m - JAW_HINGE_M
    turn = from_axis_angle((1.0, 0.0, 0.0), np.radians(JAW_OPEN_DEGREES) * tissue.jaw)
    moves = {name: tissue.jaw[:, None] * np.array(move) * _MM for name, move in JAW_MOVES_MM.items()}
    return {"jawOpen": rotate(turn, from_hinge) - from_hinge, **moves}


def _pulled(tissue: Tissue, pulls: tuple[Pull, ...]) -> FloatArray:
    in_front = np.clip((tissue.points_m[:, 2] - 0.02) / 0.03, 0.0, 1.0)
    shares = {Lip.BOTH: np.ones_like(in_front), Lip.UPPER: 1 - tissue.below, Lip.LOWER: tissue.below}
    moved = np.zeros_like(tissue.points_m)
    for pull in pulls:
        away = (tissue.points_m[:, :2] - np.array(pull.centre_mm) * _MM) / (np.array(pull.reach_mm) * _MM)
        share = np.exp(-0.5 * np.sum(away**2, axis=1)) * in_front * shares[pull.lip]
        moved += np.where(share > 0.01, share, 0.0)[:, None] * np.array(pull.move_mm) * _MM
    return moved


def _mirrored(pull: Pull) -> Pull:
    (x, y), (across, up, forward) = pull.centre_mm, pull.move_mm
    return Pull((-x, y), pull.reach_mm, (-across, up, forward), pull.lip)


def _mixed(tissue: Tissue, moves: Mapping[str, FloatArray], mixture: Mapping[str, float]) -> FloatArray:
    total = np.zeros_like(tissue.points_m)
    for name, weight in mixture.items():
        for shape in (name, f"{name}Left", f"{name}Right"):
            total += weight * moves.get(shape, 0.0)
    return total

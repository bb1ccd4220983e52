"""The mannequin's eyes: eyeballs with iris and pupil, closing lids, lashes, brows.

Conventions: metres in the space of the head joint. A lid is a shell around the eyeball, parameterized by elevation
(from its edge to under the skin) and azimuth (from right to left). Angles are degrees, for the left eye.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from .face import Tissue
from .head import skin_from_front_m
from .surface import IntArray, SkinnedCapsule, Surface, mesh

BALL_M = 0.0178
LID_M = 0.0194
LASH_M = 0.0197
EDGE_THICKNESS_M = 0.0005

PUPIL_DEGREES, IRIS_DEGREES, BALL_DEGREES = 11.0, 27.0, 105.0
AZIMUTHS = np.linspace(-96, 96, 25)
ROWS = 6


@dataclass(frozen=True, slots=True)
class Corner:
    """Where the lids meet, as seen from the eyeball's centre."""

    azimuth: float
    elevation: float


INNER, OUTER = Corner(-66.0, -7.0), Corner(54.0, 1.0)
"""The outer corner is the higher one, or the eyes look sad."""

SUNK_DEGREES = 80.0
"""The elevation at which a lid is under the skin."""


@dataclass(frozen=True, slots=True)
class LidOpening:
    """The elevations of the upper and lower lid's edges at the centre of the eye."""

    upper: float
    lower: float


OPEN = LidOpening(18.5, -21.0)
"""The upper lid lies over the iris by a ninth of its height, as in people at ease; white above it is alarm."""
CLOSED_AT = -9.0
OPENINGS: Mapping[str, LidOpening] = MappingProxyType(
    {
        "eyeBlink": LidOpening(CLOSED_AT, CLOSED_AT),
        "eyeSquint": LidOpening(9.5, -11.0),
        "eyeWide": LidOpening(34.0, -26.0),
        "eyeLookDown": LidOpening(4.0, -25.0),
        "eyeLookUp": LidOpening(30.0, -17.0),
        "cheekSquint": LidOpening(OPEN.upper, -13.0),
    }
)
"""The lid openings of the blendshapes that move them."""

SIDEWAYS_DEGREES: Mapping[str, float] = MappingProxyType({"eyeLookIn": -5.0, "eyeLookOut": 5.0})

BROW: tuple[tuple[float, float, float], ...] = (
    (0.0140, 0.1005, 0.0023),
    (0.0240, 0.1022, 0.0028),
    (0.0360, 0.1040, 0.0026),
    (0.0460, 0.1030, 0.0021),
    (0.0550, 0.0997, 0.0013),
)
"""Positions (x, y) from the front and radii along the left brow: level, as nobody's who worries."""


def ball(eye_m: FloatArray) -> tuple[tuple[str, Surface], ...]:
    """An eyeball looking ahead: pupil, iris and white."""
    return (
        ("pupil", _zone(eye_m, 0.0, PUPIL_DEGREES, 2)),
        ("iris", _zone(eye_m, PUPIL_DEGREES, IRIS_DEGREES, 2)),
        ("eye_white", _zone(eye_m, IRIS_DEGREES, BALL_DEGREES, 8)),
    )


def lids(eye_m: FloatArray, side: str) -> tuple[tuple[str, Surface, Tissue], ...]:
    """Both lids of an eye and the upper lashes."""
    return (
        ("skin", *_shell(eye_m, side, upper=True)),
        ("skin", *_shell(eye_m, side, upper=False)),
        ("lashes", *_lashes(eye_m, side)),
    )


def brow(side: str) -> tuple[Surface, Tissue]:
    """A brow, which moves with the skin under it."""
    sign = 1.0 if side == "left" else -1.0
    places = skin_from_front_m(np.array([(sign * x, y) for x, y, _radius in BROW]))
    ends = [(float(x), float(y), float(z)) for x, y, z in places]
    rods = tuple(
        SkinnedCapsule("head", first, second, BROW[number][2], BROW[number + 1][2])
        for number, (first, second) in enumerate(pairwise(ends))
    )
    surface = mesh(rods, blend_m=0.0008, grid_m=0.0021)
    nothing = np.zeros(len(surface.positions_m))
    return surface, Tissue(surface.positions_m, nothing, nothing, nothing)


def _zone(eye_m: FloatArray, start: float, end: float, rows: int) -> Surface:
    """The eyeball between two angles from its front pole."""
    around = np.arange(24) * 2 * np.pi / 24
    rings = [
        np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.full(24, np.cos(polar))], axis=1)
        for polar in np.radians(np.linspace(max(start, 0.01), end, rows + 1))
    ]
    normals = np.concatenate(rings)
    column = np.arange(24)
    following = (column + 1) % 24
    triangles = []
    for row in range(rows):
        inner, outer = 24 * row, 24 * (row + 1)
        triangles += [
            np.stack([inner + column, outer + column, outer + following], axis=1),
            np.stack([inner + column, outer + following, inner + following], axis=1),
        ]
    return Surface(eye_m + BALL_M * normals, normals, np.concatenate(triangles))


def _shell(eye_m: FloatArray, side: str, *, upper: bool) -> tuple[Surface, Tissue]:
    """A lid: its edge's thickness, then rows from the edge to under the skin."""
    points = _lid_m(eye_m, side, OPEN, upper=upper)
    own = {
        f"{name}{side.capitalize()}": _lid_m(eye_m, side, opening, upper=upper) - points
        for name, opening in OPENINGS.items()
    }
    for name, degrees in SIDEWAYS_DEGREES.items():
        own[f"{name}{side.capitalize()}"] = _lid_m(eye_m, side, OPEN, upper=upper, sideways=degrees) - points
    normals = (points - eye_m) / np.linalg.norm(points - eye_m, axis=1, keepdims=True)
    surface = Surface(points, normals, _grid(ROWS + 2, len(AZIMUTHS), flipped=not upper))
    return surface, _held(points, own)


def _lashes(eye_m: FloatArray, side: str) -> tuple[Surface, Tissue]:
    """A dark line along the edge of the upper lid."""
    points = _lash_m(eye_m, side, OPEN)
    own = {
        f"{name}{side.capitalize()}": _lash_m(eye_m, side, opening) - points
        for name, opening in OPENINGS.items()
        if opening.upper != OPEN.upper
    }
    normals = (points - eye_m) / np.linalg.norm(points - eye_m, axis=1, keepdims=True)
    return Surface(points, normals, _grid(2, len(AZIMUTHS), flipped=False)), _held(points, own)


def _held(points: FloatArray, own: Mapping[str, FloatArray]) -> Tissue:
    """Lids stay on the eyeball: only their own shapes move them."""
    nothing = np.zeros(len(points))
    return Tissue(points, nothing, nothing, nothing, inside=True, own=own)


def _lid_m(eye_m: FloatArray, side: str, opening: LidOpening, *, upper: bool, sideways: float = 0.0) -> FloatArray:
    """The lid's points, starting at the edge: ((ROWS + 2) × azimuths, 3)."""
    edge = _edge(opening.upper if upper else opening.lower, side)
    sunk = SUNK_DEGREES if upper else -SUNK_DEGREES
    rows = [edge + share * (sunk - edge) for share in np.linspace(0, 1, ROWS + 1) ** 1.3]
    shift = sideways if side == "left" else -sideways
    azimuths = [AZIMUTHS + shift * (1 - share) for share in np.linspace(0, 1, ROWS + 1)]
    shells = [_sphere(eye_m, LID_M - EDGE_THICKNESS_M, rows[0], azimuths[0])]
    shells += [_sphere(eye_m, LID_M, row, azimuth) for row, azimuth in zip(rows, azimuths, strict=True)]
    return np.concatenate(shells)


def _lash_m(eye_m: FloatArray, side: str, opening: LidOpening) -> FloatArray:
    edge = _edge(opening.upper, side)
    sign = 1.0 if side == "left" else -1.0
    lowest, highest = sorted((sign * INNER.azimuth, sign * OUTER.azimuth))
    inside = np.clip(AZIMUTHS, lowest, highest)
    return np.concatenate([_sphere(eye_m, LASH_M, edge + width, inside) for width in (-1.0, 4.0)])


def _edge(middle: float, side: str) -> FloatArray:
    """An edge's elevations: those of the corners and beyond, and `middle` between them."""
    outwards = AZIMUTHS if side == "left" else -AZIMUTHS
    share = np.clip((outwards - INNER.azimuth) / (OUTER.azimuth - INNER.azimuth), 0, 1)
    between = INNER.elevation + share * (OUTER.elevation - INNER.elevation)
    return np.asarray(between + (middle - between) * np.sin(share * np.pi) ** 0.75)


def _sphere(eye_m: FloatArray, radius_m: float, elevations: FloatArray, azimuths: FloatArray) -> FloatArray:
    up, round_ = np.radians(elevations), np.radians(azimuths)
    way = np.stack([np.cos(up) * np.sin(round_), np.sin(up), np.cos(up) * np.cos(round_)], axis=1)
    return np.asarray(eye_m + radius_m * way)


def _grid(rows: int, columns: int, *, flipped: bool) -> IntArray:
    """Triangles between rows of points; each row is above the previous one, or below if `flipped`."""
    row, column = (each.reshape(-1) for each in np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij"))
    here = row * columns + column
    above = here + columns
    quads = np.concatenate([np.stack([here, here + 1, above + 1], 1), np.stack([here, above + 1, above], 1)])
    return quads[:, ::-1] if flipped else quads

"""The mannequin's head: a skull of capsules, skin in rings around the mouth, ears, teeth and tongue.

Conventions: metres in the space of the head joint. The skin's mesh is polar: rings around the mouth, from the back of
the mouth through the closed lips over the face to the back of the head; columns count counter-clockwise from the left
corner of the mouth. So the lips can part, and the mesh is finest where the face moves most. The upper teeth are fixed
to the skull.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ...model import FloatArray
from .face import MOUTH_HALF_M, MOUTH_Y_M, Tissue
from .surface import IntArray, SkinnedCapsule, Surface, blended_field, mesh

COLUMNS = 64
CENTRE_M = np.array([0.0, 0.06, 0.0])
"""The origin of rays to the skin."""

BLEND_M = 0.009
MOUTH_M = np.array([0.0, MOUTH_Y_M, 0.106])


def _rod(
    start: tuple[float, float, float], end: tuple[float, float, float], first: float, last: float
) -> SkinnedCapsule:
    return SkinnedCapsule("head", start, end, first, last)


def _pair(capsule: SkinnedCapsule) -> tuple[SkinnedCapsule, SkinnedCapsule]:
    (x, y, z), (u, v, w) = capsule.start_m, capsule.end_m
    radii = (capsule.start_radius_m, capsule.end_radius_m)
    return capsule, SkinnedCapsule("head", (-x, y, z), (-u, v, w), *radii, capsule.stretch)


SKULL: tuple[SkinnedCapsule, ...] = (
    _rod((0, 0.112, -0.014), (0, 0.112, 0.010), 0.076, 0.078),
    _rod((0, 0.052, 0.035), (0, 0.010, 0.050), 0.055, 0.038),
    _rod((0, -0.004, 0.064), (0, -0.004, 0.066), 0.022, 0.022),
    *_pair(_rod((0.044, 0.036, 0.010), (0.016, -0.006, 0.060), 0.019, 0.019)),
    *_pair(_rod((0.029, 0.047, 0.064), (0.034, 0.045, 0.058), 0.024, 0.024)),
    *_pair(_rod((0.026, 0.056, 0.0800), (0.046, 0.060, 0.072), 0.011, 0.011)),
    *_pair(_rod((0.008, 0.103, 0.080), (0.044, 0.101, 0.072), 0.015, 0.013)),
    *_pair(_rod((0.052, 0.070, 0.066), (0.051, 0.090, 0.068), 0.010, 0.010)),
    _rod((0, 0.090, 0.092), (0, 0.053, 0.112), 0.0042, 0.0072),
    *_pair(_rod((0.007, 0.047, 0.103), (0.008, 0.046, 0.098), 0.0058, 0.0058)),
    _rod((-0.014, 0.018, 0.076), (0.014, 0.018, 0.076), 0.021, 0.021),
)

EARS: tuple[SkinnedCapsule, ...] = _pair(
    SkinnedCapsule("head", (0.079, 0.080, -0.010), (0.077, 0.058, -0.004), 0.016, 0.010, (0.40, 1.0, 1.0))
)


@dataclass(frozen=True, slots=True)
class Ring:
    """A closed curve around the mouth: half its width and height, its distance outwards (from the skin, or from the
    mouth if inside) and its material."""

    half_m: tuple[float, float]
    out_m: float
    material: str


_INSIDE = (
    Ring((0.004, 0.004), -0.050, "mouth"),
    Ring((0.020, 0.015), -0.036, "mouth"),
    Ring((0.0248, 0.015), -0.016, "mouth"),
    Ring((0.0260, 0.0038), -0.0065, "mouth"),
)
_LIPS = (
    Ring((MOUTH_HALF_M, 0.0), -0.0012, "lips"),
    Ring((0.0297, 0.0025), 0.0027, "lips"),
    Ring((0.0302, 0.0060), 0.0036, "lips"),
    Ring((0.0311, 0.0096), 0.0008, "skin"),
)
_HEIGHTS_M = (
    *(0.0125, 0.0155, 0.0185, 0.022, 0.0255, 0.029, 0.0325, 0.036, 0.040, 0.044, 0.0485, 0.054, 0.060, 0.067, 0.075),
    *(0.084, 0.094, 0.106, 0.120, 0.136, 0.155, 0.178, 0.204, 0.234, 0.266, 0.300),
)
RINGS: tuple[Ring, ...] = (
    *_INSIDE,
    *_LIPS,
    *(Ring((max(height, 0.0311 + 0.62 * (height - 0.0096)), height), 0.0, "skin") for height in _HEIGHTS_M),
)
FIRST_OUTSIDE = len(_INSIDE)


def skin() -> tuple[tuple[str, Surface, Tissue], ...]:
    """Skin, lips and the inside of the mouth: material, surface, and tissue of each."""
    angles = np.arange(COLUMNS) * 2 * np.pi / COLUMNS
    middle = _on_skin(np.zeros((1, 2)))[0]
    inside = np.stack([_inside_m(ring, angles, middle) for ring in RINGS[:FIRST_OUTSIDE]])
    back = _on_skin(np.array([[0.0, np.pi * _mouth_distance_m() - 1e-6]]))
    points = np.concatenate([inside.reshape(-1, 3), _outside_m(angles).reshape(-1, 3), back])
    triangles: dict[str, list[IntArray]] = {ring.material: [] for ring in RINGS}
    for number, ring in enumerate(RINGS[:-1]):
        triangles[ring.material].append(_band(number))
    triangles["skin"].append(_cap(len(RINGS) - 1, len(points) - 1))
    triangles["mouth"].append(_bottom())
    normals = _normals(points, np.concatenate([each for bands in triangles.values() for each in bands]))
    tissue = _tissue(points)
    return tuple(
        _only(material, np.concatenate(bands), points, normals, tissue) for material, bands in triangles.items()
    )


def ears() -> Surface:
    """Both ears."""
    return mesh(EARS, blend_m=0.004, grid_m=0.008)


def skin_from_front_m(places: FloatArray) -> FloatArray:
    """The points (N, 3) of the face that are seen from the front at `places` (N, 2), x and y."""
    points = np.column_stack([places, np.full(len(places), 0.17)])
    for _ in range(24):
        points[:, 2] -= 0.9 * blended_field(SKULL, points, BLEND_M)
    return points


def _mouth_distance_m() -> float:
    return float(np.linalg.norm(MOUTH_M - CENTRE_M))


def _inside_m(ring: Ring, angles: FloatArray, middle: FloatArray) -> FloatArray:
    """The points (COLUMNS, 3) of a ring inside the mouth, behind the lips' `middle`."""
    across, up = ring.half_m[0] * np.cos(angles), ring.half_m[1] * np.sin(angles)
    outwards, upwards = _axes()
    depth = ring.out_m - 0.35 * np.abs(across)
    return np.asarray(middle + np.outer(across, [1, 0, 0]) + np.outer(up, upwards) + np.outer(depth, outwards))


def _outside_m(angles: FloatArray) -> FloatArray:
    """The points (R, COLUMNS, 3) of all rings on the face; lips are full in the middle and thin at the corners."""
    rings = RINGS[FIRST_OUTSIDE:]
    halves = np.array([ring.half_m for ring in rings])
    places = halves[:, None, :] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    skin_m = _on_skin(places.reshape(-1, 2)).reshape(len(rings), COLUMNS, 3)
    fullness = np.where(halves[:, 1:] > 0, np.abs(np.sin(angles)) ** 0.7, 1.0)
    out_m = np.array([ring.out_m for ring in rings])[:, None] * fullness
    return np.asarray(skin_m + out_m[..., None] * _axes()[0])


def _axes() -> tuple[FloatArray, FloatArray]:
    """The directions out of the mouth and up along the face."""
    outwards = (MOUTH_M - CENTRE_M) / _mouth_distance_m()
    return outwards, np.array([0.0, outwards[2], -outwards[1]])


def _on_skin(places: FloatArray) -> FloatArray:
    """Points on the skin (N, 3) at positions (N, 2) relative to the mouth: approximate distances along the skin, across
    and up."""
    outwards, upwards = _axes()
    distance = np.linalg.norm(places, axis=1, keepdims=True)
    angle = distance / _mouth_distance_m()
    ways = places / np.maximum(distance, 1e-12)
    sideways = ways[:, :1] * np.array([1.0, 0.0, 0.0]) + ways[:, 1:] * upwards
    return _cast(np.cos(angle) * outwards + np.sin(angle) * sideways)


def _cast(rays: FloatArray) -> FloatArray:
    """Where rays (N, 3) from the centre leave the skull, searched from outside."""
    distance = np.full(len(rays), 0.17)
    for _ in range(24):
        distance -= 0.9 * blended_field(SKULL, CENTRE_M + distance[:, None] * rays, BLEND_M)
    return np.asarray(CENTRE_M + distance[:, None] * rays)


def _band(ring: int) -> IntArray:
    """The triangles between a ring and the next."""
    column = np.arange(COLUMNS)
    following = (column + 1) % COLUMNS
    inner, outer = ring * COLUMNS, (ring + 1) * COLUMNS
    first = np.stack([inner + column, outer + column, outer + following], axis=1)
    second = np.stack([inner + column, outer + following, inner + following], axis=1)
    return np.concatenate([first, second])


def _cap(ring: int, pole: int) -> IntArray:
    column = np.arange(COLUMNS)
    return np.stack([ring * COLUMNS + column, np.full(COLUMNS, pole), ring * COLUMNS + (column + 1) % COLUMNS], axis=1)


def _bottom() -> IntArray:
    """The back of the mouth, a fan over the innermost ring."""
    return np.array([[0, first, second] for first, second in pairwise(range(1, COLUMNS))])


def _normals(points: FloatArray, triangles: IntArray) -> FloatArray:
    corners = points[triangles]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.zeros_like(points)
    for k in range(3):
        np.add.at(normals, triangles[:, k], faces)
    return np.asarray(normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12))


def _tissue(points: FloatArray) -> Tissue:
    """Tissue properties: by ring near the mouth, by position elsewhere."""
    angles = np.tile(np.arange(COLUMNS) * 2 * np.pi / COLUMNS, len(RINGS))
    heights = np.repeat([ring.half_m[1] for ring in RINGS], COLUMNS)
    heights, angles = np.append(heights, 0.3), np.append(angles, np.pi / 2)
    by_angle = 0.5 - 0.5 * np.tanh(np.sin(angles) / 0.32)
    y, z = points[:, 1], points[:, 2]
    by_place = _smooth(0.030, 0.004, y) * _smooth(-0.005, 0.050, z) * _smooth(-0.065, -0.035, y)
    far = _smooth(0.014, 0.034, heights)
    below = (1 - far) * by_angle + far * _smooth(MOUTH_Y_M + 0.006, MOUTH_Y_M - 0.006, y)
    inner = np.arange(len(points)) < FIRST_OUTSIDE * COLUMNS
    return Tissue(
        points, (1 - far) * by_angle + far * by_place, below, np.where(inner, 0.6, _smooth(0.024, 0.010, heights))
    )


def _smooth(start: float, end: float, values: FloatArray) -> FloatArray:
    """From 0 at `start` to 1 at `end`, smoothly."""
    share = np.clip((values - start) / (end - start), 0.0, 1.0)
    return np.asarray(share * share * (3 - 2 * share))


def _only(
    material: str, triangles: IntArray, points: FloatArray, normals: FloatArray, tissue: Tissue
) -> tuple[str, Surface, Tissue]:
    """A part with only the vertices that it uses."""
    used, numbered = np.unique(triangles, return_inverse=True)
    surface = Surface(points[used], normals[used], numbered.reshape(triangles.shape))
    return material, surface, Tissue(points[used], tissue.jaw[used], tissue.below[used], tissue.lip[used])


TEETH_HALF_M = 0.0215
TEETH_FRONT_Z_M = 0.0940
TEETH_DEPTH_M = 0.020
UPPER_TEETH_Y_M = (MOUTH_Y_M + 0.0095, MOUTH_Y_M + 0.0005)
LOWER_TEETH_Y_M = (MOUTH_Y_M - 0.0010, MOUTH_Y_M - 0.0090)
THICKNESS_M = 0.004
TONGUE = (
    SkinnedCapsule("head", (0.0, 0.007, 0.058), (0.0, 0.0095, 0.080), 0.0085, 0.0065, (1.45, 0.75, 1.0)),
    SkinnedCapsule("head", (0.0, 0.0095, 0.080), (0.0, 0.0085, 0.086), 0.0065, 0.0050, (1.4, 0.7, 1.0)),
)
TONGUE_OUT_M = np.array([0.0, 0.004, 0.032])


def teeth(*, upper: bool) -> tuple[Surface, Tissue]:
    """A row of teeth: an arch with a front, a biting edge and a back."""
    top, bottom = UPPER_TEETH_Y_M if upper else LOWER_TEETH_Y_M
    along = np.linspace(-1, 1, 15)
    arch = np.stack(
        [TEETH_HALF_M * along, np.zeros(15), TEETH_FRONT_Z_M - TEETH_DEPTH_M * np.abs(along) ** 2.2], axis=1
    )
    behind = arch - [0.0, 0.0, THICKNESS_M]
    lines = [
        line + np.array([0, height, 0])
        for line, height in ((arch, top), (arch, bottom), (behind, bottom), (behind, top))
    ]
    surface = _ribbon(np.stack(lines))
    ones = np.ones(len(surface.positions_m))
    return surface, Tissue(surface.positions_m, (0.0 if upper else 1.0) * ones, 0 * ones, 0 * ones, inside=True)


def tongue() -> tuple[Surface, Tissue]:
    """The tongue, attached to the jaw; its tip moves farthest out."""
    surface = mesh(TONGUE, blend_m=0.002, grid_m=0.005)
    points = surface.positions_m
    ones = np.ones(len(points))
    forward = np.clip((points[:, 2] - 0.055) / 0.030, 0.0, 1.0)
    out = {"tongueOut": (forward**1.5)[:, None] * TONGUE_OUT_M}
    return surface, Tissue(points, 0.92 * ones, 0 * ones, 0 * ones, inside=True, own=out)


def _ribbon(lines: FloatArray) -> Surface:
    """Quads between lines (L, N, 3) of points from right to left; each strip has normals of its own."""
    positions, normals, triangles = [], [], []
    count = lines.shape[1]
    column = np.arange(count - 1)
    for strip, (first, second) in enumerate(pairwise(lines)):
        start = strip * 2 * count
        along = np.gradient(first, axis=0)
        normal = np.cross(along, first - second)
        positions.append(np.concatenate([first, second]))
        normals.append(np.tile(normal / np.linalg.norm(normal, axis=1, keepdims=True), (2, 1)))
        upper, lower = start + column, start + count + column
        triangles += [np.stack([lower, lower + 1, upper + 1], axis=1), np.stack([lower, upper + 1, upper], axis=1)]
    found: IntArray = np.concatenate(triangles)
    return Surface(np.concatenate(positions), np.concatenate(normals), found)

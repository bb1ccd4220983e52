"""Smooth closed surfaces around bones: tapered capsules, smoothly blended and meshed by naive surface nets.

Conventions: metres, in the T-pose of the skeleton. A field is negative inside. Each capsule runs from one point to
another with a radius at each end; `stretch` makes its cross-section an ellipse (2 along x is twice as wide).
"""

from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray

IntArray = NDArray[np.int64]

PROJECTIONS = 2
"""Newton steps that project the vertices from the grid's estimate onto the surface."""

REACH = 6.0
"""Capsules do not blend with others that are farther away than this many times the blending width."""

_GRADIENT_STEP_M = 1e-4


@dataclass(frozen=True, slots=True)
class SkinnedCapsule:
    """A part of the body, skinned to `joint`."""

    joint: str
    start_m: tuple[float, float, float]
    end_m: tuple[float, float, float]
    start_radius_m: float
    end_radius_m: float
    stretch: tuple[float, float, float] = (1.0, 1.0, 1.0)


@dataclass(frozen=True, slots=True, eq=False)
class Surface:
    """Vertices (V, 3), their outward normals (V, 3), and triangles (F, 3), counter-clockwise from outside."""

    positions_m: FloatArray
    normals: FloatArray
    triangles: IntArray


def distances_m(capsules: tuple[SkinnedCapsule, ...], points_m: FloatArray) -> FloatArray:
    """Approximate distances (C, …) of the points (…, 3) from each capsule's surface."""
    return np.stack([_distance_m(capsule, points_m) for capsule in capsules])


def mesh(capsules: tuple[SkinnedCapsule, ...], *, blend_m: float, grid_m: float) -> Surface:
    """The surface of the capsules, blended over about `blend_m`, with vertices about `grid_m` apart."""
    boxes = [_box_m(capsule, margin_m=2 * grid_m + REACH * blend_m) for capsule in capsules]
    low = np.min([lowest for lowest, _highest in boxes], axis=0)
    axes = [np.arange(low[k], max(highest[k] for _lowest, highest in boxes) + grid_m, grid_m) for k in range(3)]
    near = np.zeros([len(axis) for axis in axes])
    for capsule, (lowest, highest) in zip(capsules, boxes, strict=True):
        within = tuple(slice(*np.searchsorted(axes[k], (lowest[k], highest[k]))) for k in range(3))
        points = np.stack(np.meshgrid(*(axes[k][within[k]] for k in range(3)), indexing="ij"), axis=-1)
        near[within] += np.exp(-_distance_m(capsule, points) / blend_m)
    cells, triangles = _surface_net(_field_m(near, blend_m))
    positions = low + grid_m * cells
    for _ in range(PROJECTIONS):
        positions = _projected(capsules, positions, blend_m)
    gradient = _gradient(capsules, positions, blend_m)[1]
    return Surface(positions, gradient / np.linalg.norm(gradient, axis=-1, keepdims=True), triangles)


def blended_field(capsules: tuple[SkinnedCapsule, ...], points_m: FloatArray, blend_m: float) -> FloatArray:
    """The combined field of all capsules at the points (N, 3): a smooth minimum of their distances."""
    near = np.zeros(len(points_m))
    for capsule in capsules:
        lowest, highest = _box_m(capsule, margin_m=REACH * blend_m)
        within = np.flatnonzero(np.all((points_m > lowest) & (points_m < highest), axis=1))
        near[within] += np.exp(-_distance_m(capsule, points_m[within]) / blend_m)
    return _field_m(near, blend_m)


def _field_m(near: FloatArray, blend_m: float) -> FloatArray:
    return np.asarray(-blend_m * np.log(np.maximum(near, np.exp(-REACH))))


def _box_m(capsule: SkinnedCapsule, *, margin_m: float) -> tuple[FloatArray, FloatArray]:
    """The corners of a box that contains the capsule and a margin."""
    ends = np.array([capsule.start_m, capsule.end_m])
    reach = max(capsule.start_radius_m, capsule.end_radius_m) * np.array(capsule.stretch) + margin_m
    return ends.min(axis=0) - reach, ends.max(axis=0) + reach


def _distance_m(capsule: SkinnedCapsule, points_m: FloatArray) -> FloatArray:
    stretch = np.array(capsule.stretch)
    start, end = np.array(capsule.start_m) / stretch, np.array(capsule.end_m) / stretch
    axis, from_start = end - start, points_m / stretch - start
    along = np.clip(from_start @ axis / max(float(axis @ axis), 1e-12), 0.0, 1.0)
    smooth = along * along * (3 - 2 * along)
    radius = capsule.start_radius_m + (capsule.end_radius_m - capsule.start_radius_m) * smooth
    return np.asarray(np.linalg.norm(from_start - along[..., None] * axis, axis=-1) - radius)


def _gradient(
    capsules: tuple[SkinnedCapsule, ...], points_m: FloatArray, blend_m: float
) -> tuple[FloatArray, FloatArray]:
    """The field at the points, and its gradient by finite differences."""
    steps = _GRADIENT_STEP_M * np.eye(3)
    field = blended_field(capsules, points_m, blend_m)
    ahead = [blended_field(capsules, points_m + step, blend_m) for step in steps]
    return field, (np.stack(ahead, axis=-1) - field[..., None]) / _GRADIENT_STEP_M


def _projected(capsules: tuple[SkinnedCapsule, ...], points_m: FloatArray, blend_m: float) -> FloatArray:
    field, gradient = _gradient(capsules, points_m, blend_m)
    return np.asarray(points_m - (field / np.sum(gradient**2, axis=-1))[..., None] * gradient)


def _surface_net(field: FloatArray) -> tuple[FloatArray, IntArray]:
    """A vertex in each cell that the surface crosses, in cell units, and two triangles for each edge that it cuts."""
    cells = tuple(size - 1 for size in field.shape)
    sums, counts = np.zeros((*cells, 3)), np.zeros(cells)
    crossings = [_crossings(field, axis) for axis in range(3)]
    for axis, (edges, shares) in enumerate(crossings):
        points = edges + shares[:, None] * np.eye(3)[axis]
        for around in _cells_around(edges, axis):
            np.add.at(sums, tuple(around.T), points)
            np.add.at(counts, tuple(around.T), 1.0)
    number = np.full(cells, -1)
    number[counts > 0] = np.arange(int(np.sum(counts > 0)))
    triangles = []
    for axis, (edges, _shares) in enumerate(crossings):
        corners = np.stack([number[tuple(around.T)] for around in _cells_around(edges, axis)], axis=-1)
        outwards = field[tuple(edges.T)] < 0
        corners = np.where(outwards[:, None], corners, corners[:, ::-1])
        triangles += [corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]]
    return sums[counts > 0] / counts[counts > 0][:, None], np.concatenate(triangles)


def _crossings(field: FloatArray, axis: int) -> tuple[IntArray, FloatArray]:
    """The grid edges along `axis` that the surface cuts, by their lower end (E, 3), and the crossing points along
    them."""
    lower = np.take(field, range(field.shape[axis] - 1), axis=axis)
    upper = np.take(field, range(1, field.shape[axis]), axis=axis)
    edges = np.argwhere((lower < 0) != (upper < 0))
    at = tuple(edges.T)
    return edges, lower[at] / (lower[at] - upper[at])


def _cells_around(edges: IntArray, axis: int) -> tuple[IntArray, ...]:
    """The four cells around each edge, counter-clockwise as seen against the axis."""
    second, third = np.eye(3, dtype=np.int64)[[(axis + 1) % 3, (axis + 2) % 3]]
    steps = {(a, b): edges - a * second - b * third for a, b in product((0, 1), (0, 1))}
    return steps[1, 1], steps[0, 1], steps[0, 0], steps[1, 0]

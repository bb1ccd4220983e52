"""A software rasterizer: z-buffer in numpy, Gouraud shading.

Conventions: pictures are (height, width, 3) arrays of linear light in [0, 1], the first row at the top. The camera is
orthographic: a target point, a direction, and the height of the picture in metres.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..mannequin.surface import IntArray

SAMPLES = 2
"""Supersampling: each pixel is the mean of this number squared."""

SUN, SUN_LIGHT = np.array([0.45, 0.75, 0.65]), 0.85
SKY_LIGHT, GROUND_LIGHT = np.array([0.42, 0.45, 0.50]), np.array([0.20, 0.17, 0.15])


@dataclass(frozen=True, slots=True)
class Camera:
    """Looks at `target_m` from `azimuth` radians to the character's left of its front; the picture is `span_m` high."""

    target_m: tuple[float, float, float]
    span_m: float
    azimuth: float = 0.0
    elevation: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class ColouredMesh:
    """A triangle mesh with colours: positions (V, 3), normals (V, 3), triangles (F, 3), colours (V, 3) in linear
    light."""

    positions_m: FloatArray
    normals: FloatArray
    triangles: IntArray
    colours: FloatArray


def joined(meshes: Sequence[ColouredMesh]) -> ColouredMesh:
    """All meshes as one."""
    starts = np.cumsum([0, *(len(each.positions_m) for each in meshes)])
    return ColouredMesh(
        np.concatenate([each.positions_m for each in meshes]),
        np.concatenate([each.normals for each in meshes]),
        np.concatenate([each.triangles + start for each, start in zip(meshes, starts, strict=False)]),
        np.concatenate([each.colours for each in meshes]),
    )


def draw(mesh: ColouredMesh, camera: Camera, *, height: int, width: int, ground: FloatArray) -> FloatArray:
    """The picture on a background of the colour `ground` (3,)."""
    size = height * SAMPLES, width * SAMPLES
    at, depths, towards = _projected(mesh.positions_m, camera, size)
    shown = mesh.triangles[_shown(at, mesh.triangles, size)]
    if not len(shown):
        return np.tile(ground, (height, width, 1))
    nearest = _nearest(_covered(size, at[shown]), depths[shown])
    colours = (mesh.colours * _light(mesh.normals, towards)).astype(np.float32)
    return _averaged(nearest.places, nearest.between(colours[shown]), height, width, ground)


def _averaged(places: IntArray, light: NDArray[np.float32], height: int, width: int, ground: FloatArray) -> FloatArray:
    """The picture whose samples at `places` (N,) have this `light` (N, 3); all other samples have the ground's."""
    down, across = np.divmod(places, width * SAMPLES)
    pixels = down // SAMPLES * width + across // SAMPLES
    bare = SAMPLES**2 - np.bincount(pixels, minlength=height * width)
    channels = [np.bincount(pixels, light[:, k], height * width) + bare * ground[k] for k in range(3)]
    return np.stack(channels, axis=-1).reshape(height, width, 3) / SAMPLES**2


def _projected(
    positions_m: FloatArray, camera: Camera, size: tuple[int, int]
) -> tuple[FloatArray, NDArray[np.float32], FloatArray]:
    """Where the vertices are in the picture (V, 2), in samples, how near (V,), and the direction to the camera."""
    rows, columns = size
    right, up, towards = _axes(camera)
    scale = rows / camera.span_m
    seen = (positions_m - np.array(camera.target_m)) @ np.stack([scale * right, -scale * up, towards], axis=-1)
    return seen[:, :2] + np.array([columns / 2, rows / 2]), seen[:, 2].astype(np.float32), towards


def _axes(camera: Camera) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The picture's right and up, and the direction to the camera, in the world."""
    flat, lifted = np.cos(camera.elevation), np.sin(camera.elevation)
    towards = np.array([np.sin(camera.azimuth) * flat, lifted, np.cos(camera.azimuth) * flat])
    right = np.array([np.cos(camera.azimuth), 0.0, -np.sin(camera.azimuth)])
    return right, np.cross(towards, right), towards


def _light(normals: FloatArray, towards: FloatArray) -> FloatArray:
    """The illumination: sun, sky above, ground below, and a little from the camera."""
    sun = SUN_LIGHT * np.clip(normals @ (SUN / np.linalg.norm(SUN)), 0, None)
    skywards = 0.5 + 0.5 * normals[:, 1:2]
    ambient = GROUND_LIGHT + skywards * (SKY_LIGHT - GROUND_LIGHT)
    return np.asarray(sun[:, None] + ambient + 0.18 * np.clip(normals @ towards, 0, None)[:, None])


def _shown(at: FloatArray, triangles: IntArray, size: tuple[int, int]) -> NDArray[np.bool_]:
    """Which triangles (F,) face the camera and touch the picture, of corners `at` (V, 2) in samples."""
    rows, columns = size
    (x0, x1, x2), (y0, y1, y2) = (np.ascontiguousarray(at[:, k])[triangles.T] for k in range(2))
    faces = (x1 - x0) * (y2 - y0) - (y1 - y0) * (x2 - x0) < -1e-9
    across = (np.maximum(np.maximum(x0, x1), x2) > 0) & (np.minimum(np.minimum(x0, x1), x2) < columns)
    down = (np.maximum(np.maximum(y0, y1), y2) > 0) & (np.minimum(np.minimum(y0, y1), y2) < rows)
    return np.asarray(faces & across & down)


@dataclass(frozen=True, slots=True, eq=False)
class _Samples:
    """Samples of the picture that triangles cover, (N,) each: their place in it, the triangle's number, and the
    barycentric coordinates of its second and third corner there. Triangles may share a place."""

    places: IntArray
    owners: IntArray
    second: NDArray[np.float32]
    third: NDArray[np.float32]

    def between(self, corners: NDArray[np.float32]) -> NDArray[np.float32]:
        """What the triangles' corners (F, 3, …) have, interpolated (N, …)."""
        values: NDArray[np.float32] = corners[self.owners, 0]
        shape = (-1,) + (1,) * (values.ndim - 1)
        for share, corner in ((self.second, 1), (self.third, 2)):
            values += share.reshape(shape) * (corners[:, corner] - corners[:, 0])[self.owners]
        return values

    def only(self, which: IntArray) -> "_Samples":
        return _Samples(self.places[which], self.owners[which], self.second[which], self.third[which])


def _nearest(covered: _Samples, depths: NDArray[np.float32]) -> _Samples:
    """At each place the sample of the nearest triangle; `depths` (F, 3) are those of the triangles' corners."""
    order = np.argsort(_layer(covered.between(depths)), kind="stable")
    on_top = np.full(covered.places.max(initial=0) + 1, -1, dtype=np.int64)
    on_top[covered.places[order]] = order
    return covered.only(on_top[on_top >= 0])


def _layer(depths: NDArray[np.float32]) -> NDArray[np.uint16]:
    """Depths in 65,536 steps, thinner than a tenth of a millimetre for a body: so few are sorted in linear time."""
    if not len(depths):
        return depths.astype(np.uint16)
    nearest, farthest = depths.max(), depths.min()
    return np.asarray((depths - farthest) * (65535 / max(nearest - farthest, 1e-9)), dtype=np.uint16)


def _covered(size: tuple[int, int], corners: FloatArray) -> _Samples:
    """The samples inside triangles with corners (F, 3, 2) in samples, in batches of triangles of similar size."""
    low, high = (best(best(corners[:, 0], corners[:, 1]), corners[:, 2]) for best in (np.minimum, np.maximum))
    first = np.floor(low).astype(np.int64)
    extent = (np.ceil(high) - first).max(axis=1)
    steps = 2 ** np.ceil(np.log2(np.maximum(extent, 1))).astype(np.int64)
    batches = [np.flatnonzero(steps == step) for step in np.unique(steps)]
    found = [_inside(size, corners[batch], first[batch], int(steps[batch[0]])) for batch in batches]
    places, second, third = (
        np.concatenate([getattr(each, name) for each in found]) for name in ("places", "second", "third")
    )
    owners = np.concatenate([batch[each.owners] for batch, each in zip(batches, found, strict=True)])
    return _Samples(places, owners, second, third)


def _inside(size: tuple[int, int], corners: FloatArray, first: IntArray, step: int) -> _Samples:
    """The samples inside triangles of at most `step` samples' size, whose squares begin at `first` (F, 2)."""
    rows, columns = size
    places = (corners - (first + 0.5)[:, None]).astype(np.float32)
    down, across = np.divmod(np.arange(step * step), step)
    samples = np.stack([across, down, np.ones_like(down)]).astype(np.float32)
    second, third = (plane @ samples for plane in _planes(places))
    inner = np.flatnonzero((second >= 0) & (third >= 0) & (second + third <= 1))
    owner, sample = np.divmod(inner, step * step)
    x, y = first[owner, 0] + across[sample], first[owner, 1] + down[sample]
    inside = (x >= 0) & (x < columns) & (y >= 0) & (y < rows)
    inner, owner = inner[inside], owner[inside]
    return _Samples(y[inside] * columns + x[inside], owner, second.ravel()[inner], third.ravel()[inner])


def _planes(corners: NDArray[np.float32]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """The barycentric coordinates of the second and third corner as linear functions of position: factors (F, 3) of x,
    y and 1."""
    start, first, second = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    found = []
    for x, y in ((second[:, 1], -second[:, 0]), (-first[:, 1], first[:, 0])):
        found.append(np.stack([x, y, -(x * start[:, 0] + y * start[:, 1])], axis=1) / area[:, None])
    return found[0], found[1]

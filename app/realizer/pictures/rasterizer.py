"""A software rasterizer: z-buffer in numpy, Gouraud shading.

Conventions: pictures are (height, width, 3) arrays of linear light in [0, 1], the first row at the top. The camera is
orthographic: a target point, a direction, and the height of the picture in metres.
"""

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


def draw(
    paints: tuple[ColouredMesh, ...], camera: Camera, *, height: int, width: int, ground: FloatArray
) -> FloatArray:
    """The picture on a background of the colour `ground` (3,)."""
    rows, columns = height * SAMPLES, width * SAMPLES
    right, up, towards = _axes(camera)
    scale = rows / camera.span_m
    corners, depths, colours = [], [], []
    for paint in paints:
        seen = paint.positions_m - np.array(camera.target_m)
        at = np.stack([columns / 2 + scale * (seen @ right), rows / 2 - scale * (seen @ up)], axis=-1)
        corners.append(at[paint.triangles])
        depths.append((seen @ towards)[paint.triangles])
        colours.append((paint.colours * _light(paint.normals, towards))[paint.triangles])
    picture = np.broadcast_to(ground, (rows * columns, 3)).copy()
    _fill(picture, (rows, columns), np.concatenate(corners), np.concatenate(depths), np.concatenate(colours))
    samples = picture.reshape(rows, columns, 3)
    corners_of_pixels = [samples[i::SAMPLES, j::SAMPLES] for i in range(SAMPLES) for j in range(SAMPLES)]
    return np.asarray(sum(corners_of_pixels, np.zeros((height, width, 3))) / SAMPLES**2)


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


def _fill(
    picture: FloatArray, size: tuple[int, int], corners: FloatArray, depths: FloatArray, colours: FloatArray
) -> None:
    """Fill triangles with corners (F, 3, 2) in samples, nearest on top, in batches of similar size."""
    edges = corners[:, 1:] - corners[:, :1]
    area = edges[:, 0, 0] * edges[:, 1, 1] - edges[:, 0, 1] * edges[:, 1, 0]
    low, high = (best(best(corners[:, 0], corners[:, 1]), corners[:, 2]) for best in (np.minimum, np.maximum))
    rows, columns = size
    in_height = (high[:, 1] > 0) & (low[:, 1] < rows)
    seen = np.flatnonzero((area < -1e-9) & in_height & (high[:, 0] > 0) & (low[:, 0] < columns))
    if not len(seen):
        return
    corners, depths, colours, low, high = (each[seen] for each in (corners, depths, colours, low, high))
    first = np.floor(low).astype(np.int64)
    extent = np.ceil(high) - first
    steps = 2 ** np.ceil(np.log2(np.maximum(np.maximum(extent[:, 0], extent[:, 1]), 1))).astype(np.int64)
    found = []
    for step in np.unique(steps):
        like = np.flatnonzero(steps == step)
        pixel, shares, owner = _covered(size, corners[like], first[like], int(step))
        found.append((pixel, shares, like[owner]))
    pixels, shares, owners = (np.concatenate(each) for each in zip(*found, strict=True))
    order = np.argsort(_layer(np.einsum("nk,nk->n", shares, depths[owners])), kind="stable")
    on_top = np.full(len(picture), -1)
    on_top[pixels[order]] = order
    seen = np.flatnonzero(on_top >= 0)
    top = on_top[seen]
    picture[seen] = np.einsum("nk,nkc->nc", shares[top], colours[owners[top]])


def _layer(depths: FloatArray) -> NDArray[np.uint16]:
    """Depths in 65,536 steps, thinner than a tenth of a millimetre for a body: so few are sorted in linear time."""
    nearest, farthest = depths.max(), depths.min()
    return np.asarray((depths - farthest) * (65535 / max(nearest - farthest, 1e-9)), dtype=np.uint16)


def _covered(
    size: tuple[int, int], corners: FloatArray, first: IntArray, step: int
) -> tuple[IntArray, FloatArray, IntArray]:
    """The samples inside triangles of at most `step` samples' size: their index in the picture, the barycentric
    coordinates, and the triangle's index."""
    rows, columns = size
    places = (corners - (first + 0.5)[:, None]).astype(np.float32)
    down, across = np.divmod(np.arange(step * step), step)
    samples = np.stack([across, down, np.ones_like(down)]).astype(np.float32)
    second, third = (plane @ samples for plane in _planes(places))
    owner, sample = np.nonzero((second >= 0) & (third >= 0) & (second + third <= 1))
    x, y = first[owner, 0] + across[sample], first[owner, 1] + down[sample]
    inside = (x >= 0) & (x < columns) & (y >= 0) & (y < rows)
    owner, sample = owner[inside], sample[inside]
    shares = np.stack([second[owner, sample], third[owner, sample]], axis=-1).astype(np.float64)
    return (
        y[inside] * columns + x[inside],
        np.concatenate([1 - shares.sum(axis=-1, keepdims=True), shares], axis=-1),
        owner,
    )


def _planes(corners: NDArray[np.float32]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """The barycentric coordinates of the second and third corner as linear functions of position: factors (F, 3) of x,
    y and 1."""
    start, first, second = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    found = []
    for x, y in ((second[:, 1], -second[:, 0]), (-first[:, 1], first[:, 0])):
        found.append(np.stack([x, y, -(x * start[:, 0] + y * start[:, 1])], axis=1) / area[:, None])
    return found[0], found[1]

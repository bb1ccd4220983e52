"""Teeth and tongue, in metres in the space of the head joint. The upper teeth are fixed to the skull."""

from itertools import pairwise

import numpy as np

from ...model import FloatArray
from .face import MOUTH_Y_M, Tissue
from .surface import IntArray, SkinnedCapsule, Surface, mesh

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

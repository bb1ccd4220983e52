"""Capsules become closed surfaces that lie where the capsules' skin is."""

from collections import Counter

import numpy as np
import pytest

from understudy.realizer.mannequin.surface import SkinnedCapsule, mesh

BALL = SkinnedCapsule("hips", (0.1, 0.2, 0.3), (0.1, 0.2, 0.3), 0.05, 0.05)
ROD = SkinnedCapsule("hips", (0.0, 0.0, 0.0), (0.3, 0.0, 0.0), 0.04, 0.03)


def test_a_ball_is_round_and_its_normals_point_out() -> None:
    surface = mesh((BALL,), blend_m=0.005, grid_m=0.02)
    spokes = surface.positions_m - np.array(BALL.start_m)
    assert np.linalg.norm(spokes, axis=1) == pytest.approx(0.05, abs=1e-5)
    assert np.sum(spokes * surface.normals, axis=1) == pytest.approx(0.05, abs=1e-4)


@pytest.mark.parametrize("capsules", [(BALL,), (ROD,), (ROD, BALL)])
def test_surfaces_are_closed_and_their_triangles_face_outwards(capsules: tuple[SkinnedCapsule, ...]) -> None:
    surface = mesh(capsules, blend_m=0.005, grid_m=0.015)
    directed = Counter(
        (int(triangle[k]), int(triangle[(k + 1) % 3])) for triangle in surface.triangles for k in range(3)
    )
    assert all(count == 1 and directed[end, start] == 1 for (start, end), count in directed.items())
    corners = surface.positions_m[surface.triangles]
    volume_m3 = np.sum(np.linalg.det(corners)) / 6
    assert volume_m3 > 0


def test_neighbours_melt_into_one_surface_wider_than_either() -> None:
    beside = (ROD, SkinnedCapsule("hips", (0.3, 0.0, 0.0), (0.3, 0.3, 0.0), 0.03, 0.03))
    surface = mesh(beside, blend_m=0.01, grid_m=0.015)
    inner_corner = np.linalg.norm(surface.positions_m - [0.27, 0.03, 0.0], axis=1).min()
    assert inner_corner > 0.003

"""Triangles land where the camera says, and the nearer hides the farther."""

import numpy as np

from understudy.realizer.pictures.rasterizer import Camera, ColouredMesh, draw, joined

BLACK = np.zeros(3)
RED, GREEN = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
AHEAD = Camera((0.0, 0.0, 0.0), span_m=2.0)


def square(centre: tuple[float, float, float], half_m: float, colour: np.ndarray) -> ColouredMesh:
    """A square that faces +Z."""
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * half_m + np.array(centre)
    return ColouredMesh(
        corners, np.tile([0.0, 0.0, 1.0], (4, 1)), np.array([[0, 1, 2], [0, 2, 3]]), np.tile(colour, (4, 1))
    )


def test_a_square_covers_its_part_of_the_picture() -> None:
    picture = draw(square((0.5, 0.5, 0.0), 0.5, RED), AHEAD, height=40, width=40, ground=BLACK)
    covered = picture[..., 0] > 0
    assert covered[:20, 20:].all()
    assert covered.sum() == 400


def test_the_nearer_square_hides_the_farther_whatever_their_order() -> None:
    near, far = square((0.0, 0.0, 0.5), 0.4, RED), square((0.0, 0.0, -0.5), 0.8, GREEN)
    for paints in ((near, far), (far, near)):
        picture = draw(joined(paints), AHEAD, height=40, width=40, ground=BLACK)
        assert picture[20, 20, 0] > 0
        assert picture[20, 20, 1] == 0
        assert picture[20, 6, 1] > 0


def test_what_faces_away_or_lies_outside_is_not_drawn() -> None:
    behind = Camera((0.0, 0.0, 0.0), span_m=2.0, azimuth=np.pi)
    assert not draw(square((0, 0, 0), 0.5, RED), behind, height=20, width=20, ground=BLACK).any()
    assert not draw(square((9, 0, 0), 0.5, RED), AHEAD, height=20, width=20, ground=BLACK).any()


def test_a_square_to_the_characters_left_is_on_the_right_of_its_front() -> None:
    picture = draw(square((0.6, 0, 0), 0.2, RED), AHEAD, height=20, width=20, ground=BLACK)
    assert picture[10, 16, 0] > 0
    assert not picture[:, :10].any()

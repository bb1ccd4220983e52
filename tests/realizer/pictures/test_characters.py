"""A picture of characters: one column each, as PNG."""

import io

import pytest

from understudy.model.figure import Looks, Physique
from understudy.realizer.body.proportions import Proportions
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.pictures.characters import draw_characters
from understudy.realizer.pictures.contact_sheet import BACKGROUND, BODY_HEIGHT, CELL_WIDTH


def test_the_taller_stands_higher_in_the_picture() -> None:
    image = pytest.importorskip("matplotlib.image", reason="pictures need matplotlib")
    bodies = {
        name: (Skeleton.standing(Proportions(Physique(height_m=height_m))), Looks())
        for name, height_m in (("small", 1.5), ("tall", 1.9))
    }
    picture = image.imread(io.BytesIO(draw_characters(bodies)))[..., :3]
    assert picture.shape[1] == 2 * CELL_WIDTH
    ground = BACKGROUND ** (1 / 2.2)
    tops = []
    for column in range(2):
        front = picture[:BODY_HEIGHT, column * CELL_WIDTH : (column + 1) * CELL_WIDTH]
        drawn = (abs(front - ground) > 0.1).any(axis=2).any(axis=1)
        tops.append(int(drawn.argmax()))
    per_m = BODY_HEIGHT / 2.12
    assert tops[0] - tops[1] == pytest.approx(0.4 * per_m, abs=3)

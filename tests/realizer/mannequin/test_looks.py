"""Colours are those of the looks, in linear light."""

import pytest

from understudy.model.figure import Looks
from understudy.realizer.mannequin.looks import MATERIALS, colours_of


def test_srgb_becomes_linear_light() -> None:
    """The mid grey of sRGB, 188 of 255, is half the light (IEC 61966-2-1)."""
    colours = colours_of(Looks(top_colour="#bcbcbc", shoe_colour="#000000", hair_colour="#ffffff"))
    assert colours["jumper"] == pytest.approx((0.5, 0.5, 0.5), abs=0.005)
    assert colours["shoes"] == (0.0, 0.0, 0.0)
    assert colours["hair"] == (1.0, 1.0, 1.0)
    assert tuple(colours) == MATERIALS


def test_lips_are_redder_than_the_skin_whatever_it_is() -> None:
    for skin in ("#f0d5c0", "#4a3020"):
        colours = colours_of(Looks(skin_colour=skin))
        red, green, blue = (lip / own for lip, own in zip(colours["lips"], colours["skin"], strict=True))
        assert green < blue < red < 1

"""Slots as text of our own namespace."""

import pytest

from understudy.bml.markup.values import read_slots, written_slots
from understudy.model import Distance, Height, Side, Size, Slots, Which

FULL = Slots(Height.CHILD, 0.95, Size.TINY, 0.0254, 4, Side.LEFT, Distance.FAR, -30.0, Which.THAT, "wall_2", "anna")


@pytest.mark.parametrize("slots", [FULL, Slots(count=1), Slots(elevation_deg=0.0)])
def test_what_is_written_is_read_again(slots: Slots) -> None:
    assert read_slots(written_slots(slots)) == slots


@pytest.mark.parametrize(
    "text", ["", "height=hill", "count=-1", "height_m=inf", "size_m=x", "colour=red", "side", "referent="]
)
def test_what_is_no_slot_is_left_out(text: str) -> None:
    assert read_slots(text) is None

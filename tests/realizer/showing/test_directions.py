"""Where things are that are pointed at: as the words say, apart from each other, and where they were."""

from dataclasses import replace
from itertools import pairwise
from math import atan2, degrees, hypot

import pytest

from understudy.model import Hand
from understudy.model.slots import Distance, Side, Slots, Which
from understudy.realizer.gestures.gesture_plan import GestureRequest
from understudy.realizer.showing.directions import APART_DEG, aims_m, points_far


def pointings(*said: Slots, category: str = "THERE", hand: Hand = Hand.RIGHT) -> list[GestureRequest]:
    return [
        GestureRequest(f"g{number}", category, 1.0 + number, 1.3 + number, 1.0, hand, slots=slots)
        for number, slots in enumerate(said)
    ]


def angles_deg(requests: list[GestureRequest]) -> list[tuple[float, float]]:
    """Azimuth to the performer's left and elevation from between the shoulders of what each points at."""
    aims = [aims_m(requests)[request.behavior] for request in requests]
    return [(degrees(atan2(x, z)), degrees(atan2(y - 1.40, hypot(x, z)))) for x, y, z in aims]


def test_a_side_is_on_that_side() -> None:
    left, right, front, behind = (Slots(side=side) for side in Side)
    found = [azimuth for azimuth, _elevation in angles_deg(pointings(left, right, front, behind))]
    assert found[0] > 30.0
    assert found[1] < -50.0
    assert abs(found[2]) < 10.0
    assert abs(found[3]) > 120.0


def test_what_is_above_is_higher_than_it_is_said_and_what_is_near_is_low() -> None:
    """A body that bows takes some of it back."""
    above, near, far = angles_deg(
        pointings(Slots(elevation_deg=30.0), Slots(distance=Distance.NEAR), Slots(distance=Distance.FAR))
    )
    assert above[1] >= 30.0
    assert near[1] < -10.0 < far[1]


@pytest.mark.parametrize("hand", [Hand.LEFT, Hand.RIGHT])
def test_things_that_nobody_places_are_apart(hand: Hand) -> None:
    named = [Slots(referent=name) for name in ("wall", "potion", "door")]
    azimuths = sorted(azimuth for azimuth, _elevation in angles_deg(pointings(*named, hand=hand)))
    assert all(after - before >= APART_DEG for before, after in pairwise(azimuths))


@pytest.mark.parametrize("category", ["POINT_LEFT", "POINT_RIGHT"])
def test_a_thing_that_nobody_places_is_apart_from_one_that_has_a_side_later(category: str) -> None:
    """ "The spears go on this wall, the shields over there", pointed at to the side of the gesture."""
    (wall,) = pointings(Slots(referent="wall", which=Which.THIS))
    (shields,) = pointings(Slots(referent="shield", distance=Distance.FAR), category=category)
    (before, _), (after, _) = angles_deg([wall, replace(shields, behavior="later")])
    assert abs(before - after) >= APART_DEG
    assert (after > 0) == (category == "POINT_LEFT")


def test_a_thing_is_where_it_was() -> None:
    first, _other, again = angles_deg(
        pointings(Slots(referent="wall", which=Which.THIS), Slots(referent="potion"), Slots(referent="wall"))
    )
    assert again[0] == pytest.approx(first[0])


@pytest.mark.parametrize("side", [Side.LEFT, Side.RIGHT])
def test_a_thing_is_where_it_was_for_the_other_hand_too(side: Side) -> None:
    (first,) = pointings(Slots(referent="wall"), hand=Hand.RIGHT)
    (again,) = pointings(Slots(referent="wall"), category=f"POINT_{side.upper()}", hand=Hand(side))
    requests = [first, replace(again, behavior="again")]
    (before, _), (after, _) = angles_deg(requests)
    assert after == pytest.approx(before)


def test_a_thing_that_the_words_put_elsewhere_is_there() -> None:
    first, again = angles_deg(pointings(Slots(referent="wall"), Slots(referent="wall", side=Side.LEFT)))
    assert first[0] < 0 < again[0]


def test_nothing_is_aimed_at_where_the_words_say_nothing_or_the_scene_knows() -> None:
    assert not aims_m(pointings(Slots(), Slots(count=3)))
    (known,) = pointings(Slots(side=Side.LEFT))
    placed = GestureRequest("g", "THERE", 1.0, 1.3, 1.0, target="door", slots=known.slots)
    assert not aims_m([placed])
    assert not aims_m(pointings(Slots(side=Side.LEFT), category="BEAT"))


def test_the_finger_shows_what_is_out_of_reach() -> None:
    assert points_far(Slots(distance=Distance.FAR))
    assert points_far(Slots(elevation_deg=30.0))
    assert not points_far(Slots(distance=Distance.NEAR))

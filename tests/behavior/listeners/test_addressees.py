"""Where listeners are, and whom the speaker addresses."""

from itertools import combinations
from math import atan2, degrees, dist

import pytest

from understudy.behavior.listeners.addressees import DISTANCE_M, ELBOW_ROOM_M, addressed, placed_listeners
from understudy.model import Behavior, Channel, SyncPoints, Target

ANNA = Target("anna", (-0.8, 1.6, 1.0))


def gaze(name: str, start_s: float, lexeme: str = "LOOK", target: str = "listener") -> Behavior:
    return Behavior(name, Channel.GAZE, lexeme, SyncPoints(start_s, start_s + 0.5), 0, 0, 0.0, target=target)


def test_one_listener_needs_no_place_unless_the_scene_gives_one() -> None:
    assert placed_listeners(["ben"], []) == ()
    assert placed_listeners(["anna"], [ANNA]) == (ANNA,)


@pytest.mark.parametrize("count", [2, 3, 5, 16])
def test_several_stand_in_an_arc_before_the_speaker_and_do_not_touch(count: int) -> None:
    placed = placed_listeners([f"l{number}" for number in range(count)], [])
    places_m = [target.position_m for target in placed]
    assert all(dist((x, z), (0, 0)) > DISTANCE_M - 0.01 and z > 0 for x, _y, z in places_m)
    assert min(dist(one, other) for one, other in combinations(places_m, 2)) > ELBOW_ROOM_M - 0.01
    angles = [degrees(atan2(x, z)) for x, _y, z in places_m]
    assert angles == sorted(angles, reverse=True), "the first on the speaker's left"
    assert sum(angles) == pytest.approx(0.0, abs=0.5)
    assert max(angles) <= 60.1


def test_who_has_a_place_keeps_it() -> None:
    placed = {target.name: target.position_m for target in placed_listeners(["ben", "anna", "cleo"], [ANNA])}
    assert placed["anna"] == ANNA.position_m
    assert placed["ben"][0] > 0 > placed["cleo"][0]


def test_looks_and_gestures_at_the_listener_go_to_whom_the_speaker_turned_to() -> None:
    you = Behavior("you", Channel.GESTURE, "YOU", SyncPoints(3.2, 3.9), 0, 0, 1.0)
    beat = Behavior("beat", Channel.GESTURE, "BEAT", SyncPoints(4.2, 4.9), 0, 0, 1.0)
    behaviors = (
        gaze("opening", 0.0, "SHIFT"),
        gaze("aside", 1.0),
        gaze("turn", 3.0, "SHIFT"),
        you,
        beat,
        gaze("door", 5.0, target="door"),
        gaze("again", 6.0, "SHIFT"),
    )
    names = ["anna", "ben"]
    targets = placed_listeners(names, [ANNA])
    found = {each.id: each.target for each in addressed(behaviors, names, targets)}
    assert found == {
        "opening": "anna",
        "aside": "anna",
        "turn": "ben",
        "you": "ben",
        "beat": None,
        "door": "door",
        "again": "anna",
    }
    assert addressed(behaviors, ["ben"], ()) == behaviors, "an only listener is just that"

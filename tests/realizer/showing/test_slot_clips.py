"""What gestures show of heights, sizes, numbers and places, measured on the body that makes them."""

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import pytest

from benchmarks.realizer.gestures.shown_amounts import swings
from understudy.model import Behavior, Channel, FloatArray, Hand, Level, Schedule, SyncPoints
from understudy.model.slots import Distance, Side, Size, Slots, Which
from understudy.model.slots import Height as Tall
from understudy.models import load_realizer
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import forward
from understudy.realizer.gestures.gesture_plan import GestureRequest
from understudy.realizer.realizing import Realizer, realize
from understudy.realizer.showing.slot_clips import category_shown

RATE_HZ = 60
SETTLED_S = 0.15
"""After the stroke's end, when a hand that comes later is there too."""


@pytest.fixture(scope="module")
def realizer() -> Realizer:
    return load_realizer()


def gesture(lexeme: str, slots: Slots | None, stroke_s: float = 1.6, hand: Hand = Hand.RIGHT) -> Behavior:
    sync = SyncPoints(stroke_s - 0.8, stroke=stroke_s, relax=stroke_s + 0.5, end=stroke_s + 1.0)
    return Behavior(f"{lexeme}{stroke_s}", Channel.GESTURE, lexeme, sync, 0, 0, 5.0, hand=hand, slots=slots)


@dataclass(frozen=True, slots=True)
class Shown:
    """A motion with its joints' positions in the world (T, J, 3)."""

    motion: Motion
    at_m: FloatArray
    index: dict[str, int]

    def at_end(self, gesture: Behavior) -> int:
        ends_s = self.motion.realized[gesture.id].stroke_end
        assert ends_s is not None
        return round((ends_s + SETTLED_S) * RATE_HZ)

    def joint_m(self, name: str, frame: int) -> FloatArray:
        return np.asarray(self.at_m[frame, self.index[name]])

    def index_finger(self, side: str, frame: int) -> FloatArray:
        way = self.joint_m(f"{side}IndexDistal", frame) - self.joint_m(f"{side}IndexProximal", frame)
        return np.asarray(way / np.linalg.norm(way))

    def crown_m(self, frame: int) -> float:
        return float(self.joint_m("head", frame)[1]) + 0.19


def shown(realizer: Realizer, *gestures: Behavior, level: Level = Level.MEDIUM) -> Shown:
    motion = realize(realizer, Schedule(gestures, 6.0, agitation=level))
    skeleton = realizer.skeleton
    at_m, _turned = forward(skeleton, motion.body.rotations, motion.body.hips_m)
    return Shown(motion, at_m, dict(skeleton.index))


def actions(found: Shown, gesture: Behavior) -> list[str]:
    return [each.action for each in found.motion.decisions if each.behavior == gesture.id]


@pytest.mark.parametrize("level", list(Level))
def test_up_there_is_pointed_at_with_a_straight_finger_and_an_almost_straight_arm(
    realizer: Realizer, level: Level
) -> None:
    there = gesture("POINT_FRONT", Slots(distance=Distance.FAR, elevation_deg=30.0))
    found = shown(realizer, there, level=level)
    frame = found.at_end(there)
    assert np.degrees(np.arcsin(found.index_finger("right", frame)[1])) >= 20.0
    shoulder_m, elbow_m, wrist_m = (found.joint_m("right" + name, frame) for name in ("UpperArm", "LowerArm", "Hand"))
    upper, lower = elbow_m - shoulder_m, wrist_m - elbow_m
    cosine = upper @ lower / np.linalg.norm(upper) / np.linalg.norm(lower)
    assert np.degrees(np.arccos(cosine)) <= 40.0
    first, second = (
        found.joint_m(f"rightIndex{to}", frame) - found.joint_m(f"rightIndex{of}", frame)
        for of, to in (("Proximal", "Intermediate"), ("Intermediate", "Distal"))
    )
    assert first @ second / np.linalg.norm(first) / np.linalg.norm(second) > np.cos(np.radians(12.0))
    assert actions(found, there).count("shown") == 1


@pytest.mark.parametrize("level", list(Level))
def test_a_child_is_low_and_who_is_taller_than_the_speaker_over_his_crown(realizer: Realizer, level: Level) -> None:
    child = gesture("HOLD", Slots(height=Tall.CHILD, height_m=0.95), 1.4, Hand.BOTH)
    taller = gesture("HEIGHT_HIGH", Slots(height=Tall.OVER_HEAD, height_m=1.9), 4.2)
    found = shown(realizer, child, taller, level=level)
    assert found.joint_m("rightMiddleProximal", found.at_end(child))[1] < 1.2
    frame = found.at_end(taller)
    assert found.joint_m("rightMiddleProximal", frame)[1] > found.crown_m(frame)


def test_tiny_is_between_palms_or_two_fingers(realizer: Realizer) -> None:
    tiny = Slots(size=Size.TINY, size_m=0.02)
    both, one = gesture("NARROW", tiny, 1.4, Hand.BOTH), gesture("PINCH", tiny, 4.2)
    found = shown(realizer, both, one)
    frame = found.at_end(both)
    palms_m = found.joint_m("leftMiddleProximal", frame) - found.joint_m("rightMiddleProximal", frame)
    assert np.linalg.norm(palms_m) <= 0.10
    assert np.linalg.norm(found.joint_m("leftHand", frame) - found.joint_m("rightHand", frame)) - 0.03 <= 0.08
    frame = found.at_end(one)
    tips_m = found.joint_m("rightThumbDistal", frame) - found.joint_m("rightIndexDistal", frame)
    assert np.linalg.norm(tips_m) <= 0.05
    assert found.joint_m("rightHand", frame)[1] > 1.15


def test_what_is_big_is_that_big(realizer: Realizer) -> None:
    big = gesture("HOLD", Slots(size=Size.BIG, size_m=0.6), hand=Hand.BOTH)
    found = shown(realizer, big)
    frame = found.at_end(big)
    wrists_m = found.joint_m("leftHand", frame) - found.joint_m("rightHand", frame)
    assert np.linalg.norm(wrists_m) == pytest.approx(0.64, abs=0.06)


def test_contrasted_places_are_apart_and_a_thing_stays_in_its_place(realizer: Realizer) -> None:
    wall, potions = Slots(which=Which.THIS, referent="wall"), Slots(distance=Distance.FAR, referent="potion")
    asked = gesture("HERE", wall, 1.2), gesture("POINT_FRONT", potions, 2.9), gesture("THERE", wall, 4.6)
    found = shown(realizer, *asked)
    ways = [found.index_finger("right", found.at_end(each)) for each in asked]
    first, second, again = (np.degrees(np.arctan2(way[0], way[2])) for way in ways)
    assert abs(first - second) >= 50.0
    assert abs(first - again) <= 20.0


def test_what_is_far_is_pointed_at_though_its_lexeme_is_of_the_middle(realizer: Realizer) -> None:
    """ "The spears go on this wall, the shields over there." """
    wall, shields = Slots(which=Which.THIS, referent="wall"), Slots(distance=Distance.FAR, referent="shield")
    asked = gesture("HERE", wall, 1.2), gesture("CENTER", shields, 2.9, Hand.BOTH)
    found = shown(realizer, *asked)
    ways = [found.index_finger("right", found.at_end(each)) for each in asked]
    first, second = (np.degrees(np.arctan2(way[0], way[2])) for way in ways)
    assert abs(first - second) >= 50.0


def test_that_one_is_where_it_was_though_its_second_lexeme_is_of_the_middle(realizer: Realizer) -> None:
    """ "That door is locked. Nobody has ever opened that door." """
    door = Slots(which=Which.THAT, referent="door")
    asked = gesture("POINT_FRONT", door, 1.2), gesture("CENTER", door, 4.0, Hand.BOTH)
    found = shown(realizer, *asked)
    ways = [found.index_finger("right", found.at_end(each)) for each in asked]
    first, second = (np.degrees(np.arctan2(way[0], way[2])) for way in ways)
    assert abs(first - second) <= 20.0


@pytest.mark.parametrize("leading", [Hand.LEFT, Hand.RIGHT])
def test_what_takes_one_hand_is_shown_by_the_leading_one(leading: Hand) -> None:
    there, child = Slots(distance=Distance.FAR, referent="shield"), Slots(height=Tall.CHILD, height_m=0.95)
    for lexeme, slots in (("CENTER", there), ("HOLD", child), ("COUNT", Slots(count=2))):
        request = GestureRequest("g1", lexeme, 1.0, 1.3, 1.0, Hand.BOTH, slots=slots)
        assert category_shown(request, leading)[1] is leading


@pytest.mark.parametrize("hand", [Hand.LEFT, Hand.RIGHT])
def test_what_is_put_on_either_side_is_apart(realizer: Realizer, hand: Hand) -> None:
    left = gesture("PLACE_LEFT", Slots(side=Side.LEFT), 1.4, hand)
    right = gesture("PLACE_RIGHT", Slots(side=Side.RIGHT), 3.4, hand)
    found = shown(realizer, left, right)
    azimuths = []
    for each in (left, right):
        x, _y, z = found.joint_m(f"{hand}Hand", found.at_end(each)) - found.joint_m("hips", found.at_end(each))
        azimuths.append(np.degrees(np.arctan2(x, z)))
    assert azimuths[0] - azimuths[1] >= 50.0


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 8])
def test_numbers_are_shown_on_fingers_that_stand_apart(realizer: Realizer, count: int) -> None:
    number = gesture("COUNT", Slots(count=count), hand=Hand.BOTH if count > 5 else Hand.RIGHT)
    found = shown(realizer, number)
    frame = found.at_end(number)
    sides = ("right", "left") if count > 5 else ("right",)
    stretched = [_stretched_fingers(found, side, frame) for side in sides]
    assert sum(map(len, stretched)) == count - (count >= 5)
    for side, fingers in zip(sides, stretched, strict=True):
        for one, other in pairwise(fingers):
            ways = [_finger(found, side, name, frame) for name in (one, other)]
            assert np.degrees(np.arccos(np.clip(ways[0] @ ways[1], -1.0, 1.0))) >= 10.0


def _finger(found: Shown, side: str, name: str, frame: int) -> FloatArray:
    way = found.joint_m(f"{side}{name}Distal", frame) - found.joint_m(f"{side}{name}Proximal", frame)
    return np.asarray(way / np.linalg.norm(way))


def _stretched_fingers(found: Shown, side: str, frame: int) -> list[str]:
    """Those of the four fingers whose last joint is far from the wrist."""
    wrist_m = found.joint_m(f"{side}Hand", frame)
    names = ("Index", "Middle", "Ring", "Little")
    away_m = {name: np.linalg.norm(found.joint_m(f"{side}{name}Distal", frame) - wrist_m) for name in names}
    return [name for name in names if away_m[name] > 0.115]


@pytest.mark.parametrize("level", list(Level))
@pytest.mark.parametrize("lexeme", ["GREETING", "FAREWELL"])
@pytest.mark.parametrize("stroke_s", [0.45, 1.8])
def test_a_raised_hand_waves(realizer: Realizer, lexeme: str, stroke_s: float, level: Level) -> None:
    """At least two reversals of 10 cm of the fingertips in each of its forms, on the first word too."""
    sync = SyncPoints(0.1, stroke_start=stroke_s - 0.2, stroke=stroke_s, stroke_end=stroke_s + 0.1, end=stroke_s + 0.6)
    for wave in (replace(gesture(lexeme, None, stroke_s), sync=sync), gesture(lexeme, None, stroke_s)):
        for seed in range(3):
            motion = realize(realizer, Schedule((wave,), 5.0, agitation=level), seed=seed)
            at_m, _turned = forward(realizer.skeleton, motion.body.rotations, motion.body.hips_m)
            made = motion.realized[wave.id]
            assert made.stroke_start is not None
            assert made.relax is not None
            rows = slice(round(made.stroke_start * RATE_HZ), round((made.relax + 0.1) * RATE_HZ))
            aside_m = at_m[rows, realizer.skeleton.index["rightMiddleDistal"], 0]
            assert swings(aside_m, 0.10) >= 3


@pytest.mark.parametrize("level", list(Level))
def test_who_is_taller_is_over_the_crown_soon_after_another_gesture_too(realizer: Realizer, level: Level) -> None:
    """Where the whole stroke would begin before the hand is there, a shorter one comes in time."""
    there = gesture("POINT_FRONT", None, 0.8)
    sync = SyncPoints(1.4, stroke=1.75, relax=2.1, end=2.6)
    taller = replace(gesture("HEIGHT_HIGH", Slots(height=Tall.OVER_HEAD, height_m=1.9), 1.75), sync=sync)
    found = shown(realizer, replace(there, sync=replace(there.sync, relax=1.0)), taller, level=level)
    frame = found.at_end(taller)
    assert found.joint_m("rightMiddleProximal", frame)[1] > found.crown_m(frame)


def test_without_slots_nothing_is_shown(realizer: Realizer) -> None:
    plain = gesture("POINT_FRONT", None)
    assert "shown" not in actions(shown(realizer, plain), plain)
    empty = replace(plain, slots=Slots())
    assert "shown" not in actions(shown(realizer, empty), empty)

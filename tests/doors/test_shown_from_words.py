"""What a sentence alone says of places, heights and sizes is what the body shows, from words to joints."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import pytest

import understudy as package
from understudy.model import Behavior, Channel, FloatArray
from understudy.model.slots import Slots
from understudy.models import Understudy
from understudy.realizer.body.skeleton import Skeleton, forward

CROWN_M = 1.73
SETTLED_S = 0.15
"""After the stroke's end, when a hand that comes later is there too."""


@dataclass(frozen=True, slots=True)
class Shown:
    """The joints of the body (J, 3) as the stroke of a gesture with slots has ended."""

    slots: Slots
    at_m: FloatArray

    def joint_m(self, name: str) -> FloatArray:
        return np.asarray(self.at_m[Skeleton.standing().index[name]])

    def azimuth_deg(self) -> float:
        """Where the right arm goes, to the character's left."""
        way = self.joint_m("rightHand") - self.joint_m("rightUpperArm")
        return float(np.degrees(np.arctan2(way[0], way[2])))

    def elevation_deg(self) -> float:
        """Where the right index finger points."""
        way = self.joint_m("rightIndexDistal") - self.joint_m("rightIndexProximal")
        return float(np.degrees(np.arcsin(way[1] / np.linalg.norm(way))))

    def apart_m(self) -> float:
        return float(np.linalg.norm(self.joint_m("rightHand") - self.joint_m("leftHand")))


@pytest.fixture
def shown(understudy: Understudy) -> Callable[[str], list[Shown]]:
    """The gestures of a sentence whose words say what they show."""

    def of(text: str) -> list[Shown]:
        performance = package.say(understudy, text)
        motion = package.realize(understudy, performance).motion
        at_m, _turned = forward(Skeleton.standing(), motion.body.rotations, motion.body.hips_m)

        def frame(gesture: Behavior) -> int:
            ends_s = motion.realized[gesture.id].stroke_end
            assert ends_s is not None
            return int(np.argmin(np.abs(motion.body.times_s - ends_s - SETTLED_S)))

        gestures = [each for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE]
        return [Shown(each.slots, at_m[frame(each)]) for each in gestures if each.slots is not None]

    return of


def test_way_up_there_is_pointed_at_upwards(shown: Callable[[str], list[Shown]]) -> None:
    found = shown("They live way up there on the ridge.")
    assert max(each.elevation_deg() for each in found if each.slots.elevation_deg) >= 20


def test_a_child_is_low_and_who_is_taller_is_above_the_own_crown(shown: Callable[[str], list[Shown]]) -> None:
    child = [each for each in shown("He was only this tall when he was a little boy.") if each.slots.height_m]
    taller = [each for each in shown("My son is taller than I am.") if each.slots.height_m]
    assert child[-1].joint_m("rightHand")[1] < 1.2
    assert taller[-1].joint_m("rightHand")[1] > CROWN_M


@pytest.mark.parametrize(
    "text",
    [
        "Hang the swords on this wall, and put the potions over there.",
        "On the one hand it is cheap, on the other hand it is slow.",
    ],
)
def test_contrasted_places_are_at_least_50_degrees_apart(shown: Callable[[str], list[Shown]], text: str) -> None:
    azimuths = [each.azimuth_deg() for each in shown(text)]
    assert max(abs(one - other) for one, other in combinations(azimuths, 2)) >= 50


def test_this_big_is_between_the_hands_though_the_words_say_a_height_too(shown: Callable[[str], list[Shown]]) -> None:
    (found,) = [each for each in shown("I caught a fish, it was this big!") if each.slots.size_m]
    assert found.apart_m() == pytest.approx(found.slots.size_m, abs=0.12)

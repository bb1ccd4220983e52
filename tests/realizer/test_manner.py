"""The voice's manner in the strokes: a bigger one goes farther, a quicker one is faster, whatever the gesture."""

from dataclasses import replace

import numpy as np
import pytest

from understudy.model import Behavior, Channel, FloatArray, Hand, Level, Manner, Schedule, SyncPoints
from understudy.model.slots import Distance, Side, Size, Slots
from understudy.models import load_realizer
from understudy.realizer.body.skeleton import forward
from understudy.realizer.realizing import Realizer, realize

RATE_HZ = 60
SMALL, BIG = Manner(amplitude=0.6), Manner(amplitude=1.5)
SLOW, QUICK = Manner(speed=0.8, tension=0.8), Manner(speed=1.25, tension=1.2)
FREE = ("OPEN_HAND", "OFFER", "NEGATION", "YOU", "ME", "POINT_FRONT", "BEAT", "QUESTION", "GIVE", "THANKS")
PLACED = (
    ("POINT_FRONT", Hand.RIGHT, Slots(distance=Distance.FAR)),
    ("PLACE_RIGHT", Hand.RIGHT, Slots(side=Side.RIGHT)),
    ("HEIGHT_LOW", Hand.RIGHT, Slots(height_m=0.95)),
)


@pytest.fixture(scope="module")
def realizer() -> Realizer:
    return load_realizer()


def stroke(realizer: Realizer, gesture: Behavior, seed: int = 0) -> tuple[float, float, FloatArray]:
    """The path of the right wrist in a stroke, m, its peak speed, m/s, and where it ends, m, all from the hips."""
    schedule = Schedule((gesture,), 4.0, agitation=Level.MEDIUM)
    motion = realize(realizer, schedule, seed=seed)
    skeleton, sync = realizer.skeleton, motion.realized[gesture.id]
    assert sync.stroke_start is not None
    assert sync.stroke_end is not None
    at_m, _turned = forward(skeleton, motion.body.rotations, motion.body.hips_m)
    way_m = at_m[:, skeleton.index["rightHand"]] - motion.body.hips_m
    first, last = round(sync.stroke_start * RATE_HZ), round(sync.stroke_end * RATE_HZ)
    steps_m = np.linalg.norm(np.diff(way_m[first : last + 1], axis=0), axis=1)
    return float(steps_m.sum()), float(steps_m.max()) * RATE_HZ, way_m[last]


def gesture(lexeme: str, hand: Hand = Hand.RIGHT, slots: Slots | None = None) -> Behavior:
    sync = SyncPoints(0.9, stroke=1.8, relax=2.4, end=3.0)
    return Behavior("g1", Channel.GESTURE, lexeme, sync, 0, 0, 5.0, hand=hand, slots=slots)


@pytest.mark.parametrize("lexeme", FREE)
def test_a_bigger_voice_goes_farther_and_a_quicker_one_is_faster(realizer: Realizer, lexeme: str) -> None:
    def made(manner: Manner) -> tuple[float, float]:
        found = [stroke(realizer, replace(gesture(lexeme), manner=manner), seed)[:2] for seed in range(2)]
        path_m, peak_m_s = np.mean(found, axis=0)
        return float(path_m), float(peak_m_s)

    assert made(BIG)[0] > 1.4 * made(SMALL)[0]
    assert made(BIG)[1] > 1.2 * made(SMALL)[1]
    assert made(QUICK)[1] > 1.15 * made(SLOW)[1]


@pytest.mark.parametrize(("lexeme", "hand", "slots"), PLACED, ids=[each[0] for each in PLACED])
def test_what_words_place_is_there_in_any_voice_but_the_hand_comes_from_farther_in_a_bigger_one(
    realizer: Realizer, lexeme: str, hand: Hand, slots: Slots
) -> None:
    placed = gesture(lexeme, hand, slots)
    small, big = (stroke(realizer, replace(placed, manner=manner)) for manner in (SMALL, BIG))
    assert big[0] > 1.4 * small[0]
    assert np.linalg.norm(big[2] - small[2]) < 0.06


def test_palms_that_show_something_tiny_are_not_opened_wide_by_a_big_voice(realizer: Realizer) -> None:
    tiny = gesture("NARROW", Hand.BOTH, Slots(size=Size.TINY, size_m=0.02))
    usual, big = (stroke(realizer, replace(tiny, manner=manner)) for manner in (Manner(), Manner(amplitude=1.6)))
    assert big[0] < 1.35 * usual[0]


@pytest.mark.parametrize("lexeme", ["ME", "HAND_ON_HEART", "THINK", "MIME_HUSH", "MIME_DRINK"])
def test_a_hand_at_the_own_body_is_there_in_any_voice_and_comes_from_farther_in_a_bigger_one(
    realizer: Realizer, lexeme: str
) -> None:
    least, most = Manner(amplitude=0.35), Manner(amplitude=2.0)
    small, usual, big = (
        stroke(realizer, replace(gesture(lexeme), manner=manner)) for manner in (least, Manner(), most)
    )
    assert np.linalg.norm(small[2] - usual[2]) < 0.04
    assert np.linalg.norm(big[2] - usual[2]) < 0.04
    assert big[0] > 1.2 * small[0]

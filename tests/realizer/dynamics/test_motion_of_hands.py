"""What arms and hands do on the whole body in a line: ends at rest, hands that stay up and drag, fingers that live."""

import numpy as np
import pytest

from understudy.model import Behavior, Channel, FloatArray, Hand, Interval, Level, Schedule, SyncPoints
from understudy.models import load_realizer
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.realizing import Realizer, realize

RATE_HZ = 60
FASTEST_M_S = 3.0


@pytest.fixture(scope="module")
def realizer() -> Realizer:
    return load_realizer()


def gesture(lexeme: str, stroke_s: float, hand: Hand = Hand.RIGHT) -> Behavior:
    sync = SyncPoints(max(0.0, stroke_s - 0.7), stroke=stroke_s, relax=stroke_s + 0.3, end=stroke_s + 0.8)
    return Behavior(f"{lexeme}{stroke_s}", Channel.GESTURE, lexeme, sync, 0, 0, 5.0, hand=hand)


LINE = (
    gesture("QUESTION", 0.2),
    gesture("OPEN_HAND", 1.6, Hand.BOTH),
    gesture("NEGATION", 4.6),
    gesture("INSIST", 5.7),
)


def performed(realizer: Realizer, level: Level = Level.MEDIUM, seed: int = 0) -> tuple[Motion, FloatArray]:
    """The motion of a line that ends while its last hand is up, and the places of both wrists (T, 2, 3)."""
    schedule = Schedule(
        LINE, 6.0, phrases=(Interval(0.1, 3.0), Interval(3.2, 5.9)), emphases_s=(0.2, 1.6, 3.0, 5.7), agitation=level
    )
    motion = realize(realizer, schedule, seed=seed)
    at_m, _turned = forward(realizer.skeleton, motion.body.rotations, motion.body.hips_m)
    return motion, at_m[:, realizer.skeleton.chain("leftHand", "rightHand")]


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("level", list(Level))
def test_no_take_begins_or_ends_in_mid_move_and_no_wrist_is_too_fast(
    realizer: Realizer, level: Level, seed: int
) -> None:
    _motion, wrists_m = performed(realizer, level, seed)
    speeds = np.linalg.norm(np.diff(wrists_m, axis=0), axis=-1) * RATE_HZ
    assert speeds[[0, -1]].max() < 0.15
    assert speeds.max() < FASTEST_M_S


def test_strokes_snap_and_ways_to_rest_are_slow(realizer: Realizer) -> None:
    motion, wrists_m = performed(realizer)
    fast = np.linalg.norm(np.diff(wrists_m, axis=0), axis=-1).max(axis=1) * RATE_HZ
    strokes, drops = [], []
    for each in LINE:
        sync = motion.realized[each.id]
        assert sync.stroke_start is not None
        assert sync.stroke_end is not None
        assert sync.relax is not None
        strokes.append(fast[round(sync.stroke_start * RATE_HZ) : round(sync.stroke_end * RATE_HZ) + 1].max())
        if sync.end - sync.relax > 0.1 and sync.end < 5.9:
            drops.append(fast[round(sync.relax * RATE_HZ) : round(sync.end * RATE_HZ) + 1].max())
    assert np.median(strokes) > 0.75
    assert np.median(strokes) >= 0.75 * np.median(drops)


def test_a_hand_stays_before_the_belly_between_two_ideas(realizer: Realizer) -> None:
    """In a gap of two seconds; one that hangs is at .84 m, as the other one may."""
    _motion, wrists_m = performed(realizer)
    between = wrists_m[round(2.9 * RATE_HZ) : round(3.4 * RATE_HZ)]
    assert between[:, :, 1].max(axis=1).min() > 1.0


def test_fingers_are_never_still_and_do_not_move_as_one(realizer: Realizer) -> None:
    motion, _wrists_m = performed(realizer)
    skeleton = realizer.skeleton
    for side in ("left", "right"):
        joints = [skeleton.index[f"{side}{name}Intermediate"] for name in ("Index", "Middle", "Ring", "Little")]
        turned = motion.body.rotations[:, joints]
        speeds_deg_s = np.degrees(angle_between(turned[1:], turned[:-1])) * RATE_HZ
        assert np.mean(speeds_deg_s.mean(axis=1) < 5.0) < 0.6
        assert np.corrcoef(speeds_deg_s.T)[0, 3] < 0.95

"""The voicing decision on hand-made measures."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.acoustic.pitch.periodicity import Levels
from understudy.acoustic.pitch.voicing import SRH_ALONE, WEIGHED, Voicing, measures, voiced_frames
from understudy.model import FloatArray

CLEAR = (0.25, 0.95, 0.0, 20.0)
HUM = (0.12, 0.9, -25.0, 0.0)
HISS = (0.02, 0.2, -12.0, 8.0)


def measured(*frames: tuple[float, float, float, float]) -> FloatArray:
    srh, periodicity, below_loud_db, above_quiet_db = np.array(frames).T
    return measures(srh, periodicity, Levels(below_loud_db, above_quiet_db))


@pytest.mark.parametrize(("frame", "weighed", "alone"), [(CLEAR, True, True), (HUM, False, True), (HISS, False, False)])
def test_a_hum_between_words_is_no_voice(frame: tuple[float, float, float, float], weighed: bool, alone: bool) -> None:
    assert voiced_frames(measured(*[frame] * 5), WEIGHED).tolist() == [weighed] * 5
    assert voiced_frames(measured(*[frame] * 5), SRH_ALONE).tolist() == [alone] * 5


def test_one_frame_in_doubt_does_not_break_the_voice() -> None:
    doubt = Voicing(1.0, 0.0, 0.0, 0.0, threshold=0.07, change_cost=0.01)
    frames = measured(*[CLEAR] * 4, (0.06, 0, 0, 0), *[CLEAR] * 4)
    assert voiced_frames(frames, doubt).all()
    assert not voiced_frames(frames, SRH_ALONE)[4]


def test_a_single_frame_is_judged() -> None:
    assert voiced_frames(measured(CLEAR), WEIGHED).tolist() == [True]


@given(frames=st.integers(1, 8), seed=st.integers(0, 10_000), cost=st.sampled_from([0.0, 0.3, 1.0, 3.0]))
def test_no_other_decisions_are_worth_more(frames: int, seed: int, cost: float) -> None:
    measured = np.random.default_rng(seed).normal(size=(frames, 4))
    voicing = Voicing(1.0, 0.5, 0.0, 0.0, threshold=0.1, change_cost=cost)
    excess = measured @ voicing.weights - voicing.threshold

    def worth(voiced: tuple[bool, ...]) -> float:
        return float(np.sum(excess[np.array(voiced)]) - cost * np.sum(np.diff(voiced)))

    best = max(worth(voiced) for voiced in product((False, True), repeat=frames))
    assert worth(tuple(voiced_frames(measured, voicing).tolist())) == pytest.approx(best)

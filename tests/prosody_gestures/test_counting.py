"""Learning by counting."""

import numpy as np
import pytest

from tests.prosody_gestures.models import drawn_model
from understudy.prosody_gestures.counting import PLAIN, CountSmoothing, count, count_labels
from understudy.prosody_gestures.semi_markov import Segment, SemiMarkovModel, segments_of

PATHS = [
    [Segment(0, 0, 2), Segment(1, 2, 3), Segment(0, 5, 2)],
    [Segment(0, 0, 4), Segment(0, 4, 2)],
    [Segment(1, 0, 9)],
]


def test_shares_are_what_was_counted() -> None:
    """Two of three paths begin in 0, whatever follows (eq. 11); 9 frames count as the longest, 5."""
    counted = count(PATHS, 2, 5, PLAIN)
    assert np.exp(counted.log_initial) == pytest.approx([2 / 3, 1 / 3])
    assert np.exp(counted.log_transition) == pytest.approx(np.array([[1 / 2, 1 / 2], [1, 0]]))
    assert np.exp(counted.log_duration) == pytest.approx(np.array([[0, 3 / 4, 0, 1 / 4, 0], [0, 0, 1 / 2, 0, 1 / 2]]))


def test_smoothing_forbids_nothing_and_keeps_the_order() -> None:
    counted = count(PATHS, 2, 5, CountSmoothing())
    assert np.isfinite(counted.log_duration).all()
    assert np.exp(counted.log_duration).sum(axis=1) == pytest.approx([1, 1])
    assert counted.log_duration[0].argmax() == 1
    assert counted.log_transition[1, 0] > counted.log_transition[1, 1]


def test_labels_are_counted_in_their_states() -> None:
    emissions = count_labels([(PATHS[0], np.array([2, 2, 0, 0, 1, 2, 1]))], 2, 3, added=0.0)
    assert np.exp(emissions.log_probability) == pytest.approx(np.array([[0, 1 / 4, 3 / 4], [2 / 3, 1 / 3, 0]]))


def test_a_model_is_learnt_back_from_its_own_paths() -> None:
    model = drawn_model(4, states=3, longest=6)
    paths = [_path(model, np.random.default_rng(seed)) for seed in range(300)]
    counted = count(paths, 3, 6, CountSmoothing(spread=0.0))
    assert np.exp(counted.log_transition) == pytest.approx(np.exp(model.log_transition), abs=0.05)
    assert np.exp(counted.log_duration) == pytest.approx(np.exp(model.log_duration), abs=0.05)


def test_one_frame_is_a_path() -> None:
    assert count([segments_of([1])], 2, 3, PLAIN).log_initial[1] == 0.0


def _path(model: SemiMarkovModel, generator: np.random.Generator) -> list[Segment]:
    path, chances, start = list[Segment](), model.log_initial, 0
    for _ in range(20):
        state = int(generator.choice(3, p=np.exp(chances)))
        frames = 1 + int(generator.choice(6, p=np.exp(model.log_duration[state])))
        path.append(Segment(state, start, frames))
        start, chances = start + frames, model.log_transition[state]
    return path

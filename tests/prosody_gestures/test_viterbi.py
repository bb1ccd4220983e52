"""The full decode: the best of all paths, tried one by one; hmmlearn's where durations are geometric."""

from collections.abc import Iterator
from itertools import pairwise, product

import numpy as np
import pytest
from hmmlearn.hmm import CategoricalHMM

from tests.prosody_gestures.models import (
    LABELS,
    drawn_likelihoods,
    drawn_model,
    log_shares,
    three_frames_at_least,
)
from understudy.errors import InputError
from understudy.model import FloatArray
from understudy.prosody_gestures.semi_markov import (
    DiscreteEmissions,
    Segment,
    SemiMarkovModel,
    segments_of,
    states_by_frame,
)
from understudy.prosody_gestures.trellis import Search
from understudy.prosody_gestures.viterbi import decode


def durations(frames: int, allowed: set[int]) -> Iterator[tuple[int, ...]]:
    """All ways to divide frames into durations that are allowed."""
    if frames == 0:
        yield ()
    for first in allowed:
        if first <= frames:
            for rest in durations(frames - first, allowed):
                yield first, *rest


def score(model: SemiMarkovModel, likelihoods: FloatArray, path: tuple[Segment, ...]) -> float:
    """The logarithm of the chance of a path and of what it emits, by definition."""
    total = model.log_initial[path[0].state]
    total += sum(model.log_transition[one.state, other.state] for one, other in pairwise(path))
    total += sum(model.log_duration[segment.state, segment.frames - 1] for segment in path)
    return float(total + sum(likelihoods[segment.start : segment.end, segment.state].sum() for segment in path))


def every_path(model: SemiMarkovModel, frames: int, step: int) -> Iterator[tuple[Segment, ...]]:
    for lasted in durations(frames, set(range(1, model.longest_frames + 1, step))):
        starts = np.cumsum((0, *lasted)).tolist()
        for states in product(range(len(model.states)), repeat=len(lasted)):
            yield tuple(map(Segment, states, starts, lasted))


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("step", [1, 2])
def test_no_path_is_better(seed: int, step: int) -> None:
    model = drawn_model(seed, states=3, longest=4)
    likelihoods = drawn_likelihoods(model, seed, frames=7)
    best = max(score(model, likelihoods, path) for path in every_path(model, 7, step))
    found = decode(model, likelihoods, Search(step))
    assert score(model, likelihoods, found) == pytest.approx(best, abs=1e-9)
    assert {segment.frames % step for segment in found} <= {1 % step}


@pytest.mark.parametrize("seed", range(6))
def test_geometric_durations_are_a_markov_model(seed: int) -> None:
    """With the same chance to stay in every state, a segment's end weighs the same wherever the recording ends."""
    generator, states, frames, stay = np.random.default_rng(seed), 4, 60, 0.8
    leave = np.exp(log_shares(generator, states, states)) * (1 - np.eye(states))
    leave /= leave.sum(axis=1, keepdims=True)
    initial, emitted = np.exp(log_shares(generator, states)), np.exp(log_shares(generator, states, LABELS))
    with np.errstate(divide="ignore"):
        transitions = np.log(leave)
    geometric = np.log((1 - stay) * stay ** np.arange(frames))
    model = SemiMarkovModel(
        tuple("abcd"),
        np.log(initial),
        transitions,
        np.tile(geometric, (states, 1)),
        DiscreteEmissions(np.log(emitted)),
    )
    oracle = CategoricalHMM(n_components=states, n_features=LABELS)
    oracle.startprob_, oracle.emissionprob_ = initial, emitted
    oracle.transmat_ = stay * np.eye(states) + (1 - stay) * leave
    labels = generator.integers(0, LABELS, frames)
    expected = oracle.decode(labels[:, None])[1]
    found = decode(model, model.emissions.log_likelihoods(labels))
    assert states_by_frame(found).tolist() == expected.tolist()


def test_the_best_states_narrow_the_search() -> None:
    """All of them are the full decode; fewer never find a better path, and here find a worse one."""
    model = drawn_model(3, states=8, longest=6)
    likelihoods = drawn_likelihoods(model, 3, frames=80)
    full = score(model, likelihoods, decode(model, likelihoods))
    found = [score(model, likelihoods, decode(model, likelihoods, Search(best=best))) for best in (1, 2, 4, 8)]
    assert found[-1] == pytest.approx(full)
    assert max(found) <= full + 1e-9
    assert found[0] < full - 1e-6


def test_nothing_heard_is_no_path() -> None:
    assert decode(drawn_model(0, states=2, longest=3), np.empty((0, 2))) == ()


def test_what_no_path_fits_is_refused() -> None:
    model = three_frames_at_least()
    with pytest.raises(InputError, match="no path"):
        decode(model, drawn_likelihoods(model, 0, frames=2))


def test_runs_are_segments() -> None:
    segments = [Segment(1, 0, 2), Segment(0, 2, 1), Segment(2, 3, 3)]
    assert segments_of([1, 1, 0, 2, 2, 2]) == segments
    assert states_by_frame(segments).tolist() == [1, 1, 0, 2, 2, 2]
    assert segments_of([]) == []

"""Learning, keeping and decoding a model of gestures from the voice; the one that ships."""

from collections.abc import Iterator
from itertools import pairwise, product
from pathlib import Path

import numpy as np
import pytest
from hmmlearn.hmm import CategoricalHMM
from sklearn.discriminant_analysis import LinearDiscriminantAnalysis

from tests.prosody_gestures.models import LABELS, drawn_likelihoods, drawn_model, log_shares, three_frames_at_least
from tests.prosody_gestures.test_prosody import spoken
from training.prosody_gestures.parts import fit_discriminants, learn_part
from understudy.errors import InputError, ServiceError
from understudy.files import resource_folder
from understudy.model import FloatArray
from understudy.prosody_gestures.prosody import features, in_context, raw_frames
from understudy.prosody_gestures.semi_markov import (
    DiscreteEmissions,
    Segment,
    SemiMarkovModel,
    segments_of,
    similarity,
    states_by_frame,
)
from understudy.prosody_gestures.trellis import Search
from understudy.prosody_gestures.voice_model import VoiceModel, decode

SHIPPED = resource_folder("models") / "prosody_gestures" / "voice.npz"


def lesson(seed: int) -> tuple[FloatArray, list[Segment], FloatArray, FloatArray]:
    """A voice whose second state is half a second after each time that it is loud and high, and the path beside it."""
    generator = np.random.default_rng(seed)
    energy_db, f0_hz = spoken(12.0, seed)
    moved = np.zeros(len(f0_hz), dtype=bool)
    for start in np.cumsum(generator.integers(150, 250, 5)):
        energy_db[start : start + 50] += 12
        f0_hz[start : start + 50] *= 1.5
        moved[start : start + 50] = True
    rows = in_context(features(raw_frames(energy_db, f0_hz)))
    states = moved[np.minimum((np.arange(len(rows)) * 2.5).astype(int), len(moved) - 1)]
    return rows, segments_of(states.astype(np.intp)), energy_db, f0_hz


def test_what_was_learnt_is_found_in_a_new_voice() -> None:
    part = learn_part("hands", ("rest", "stroke"), [lesson(seed)[:2] for seed in range(4)])
    _, path, energy_db, f0_hz = lesson(9)
    found = VoiceModel((part,)).decode(energy_db, f0_hz)["hands"]
    assert similarity(states_by_frame(found), states_by_frame(path)) > 0.95


def test_it_is_kept_whole(tmp_path: Path) -> None:
    model = VoiceModel((learn_part("head", ("still", "nod"), [lesson(0)[:2]]),))
    model.save(tmp_path / "voice.npz")
    read = VoiceModel.load(tmp_path / "voice.npz")
    _, _, energy_db, f0_hz = lesson(1)
    assert read.parts[0].model.states == ("still", "nod")
    assert read.decode(energy_db, f0_hz) == model.decode(energy_db, f0_hz)
    assert [path.name for path in tmp_path.iterdir()] == ["voice.npz"]


@pytest.mark.parametrize("content", [b"", b"nothing of the kind", SHIPPED.read_bytes()[:900]])
def test_a_broken_file_is_named(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "voice.npz").write_bytes(content)
    with pytest.raises(ServiceError, match="not a model of gestures"):
        VoiceModel.load(tmp_path / "voice.npz")


def test_the_shipped_model_gestures_to_a_voice() -> None:
    """Hands, head and brows; the hands come to rest, and a stroke comes after a preparation or a hold."""
    model = VoiceModel.load(SHIPPED)
    assert [part.part for part in model.parts] == ["hands", "head", "brows"]
    assert all(np.exp(part.model.log_duration).sum(axis=1) == pytest.approx(1, abs=1e-4) for part in model.parts)
    hands = model.parts[0].model
    entered = np.exp(hands.log_transition[:, hands.states.index("stroke")])
    assert entered.argmax() == hands.states.index("preparation")


def test_directions_are_scikit_learns() -> None:
    """Up to sign, with next to no ridge beside the spread of the data."""
    generator = np.random.default_rng(0)
    states = generator.integers(0, 3, 600)
    rows = generator.normal(size=(600, 5)) @ generator.normal(size=(5, 5))
    rows[:, :2] += np.array([[0, 0], [3, 1], [0, 4]])[states]
    ours = fit_discriminants(rows, states).project(rows)
    oracle = LinearDiscriminantAnalysis(solver="eigen").fit(rows, states).transform(rows)
    alike = [abs(np.corrcoef(ours[:, place], oracle[:, place])[0, 1]) for place in range(2)]
    assert alike == pytest.approx([1, 1], abs=1e-3)


def test_one_state_has_a_direction_too() -> None:
    assert fit_discriminants(
        np.random.default_rng(0).normal(size=(9, 4)), np.zeros(9, dtype=np.intp)
    ).weights.shape == (4, 1)


def test_a_constant_feature_does_no_harm() -> None:
    rows = np.random.default_rng(0).normal(size=(60, 3))
    rows[:, 1] = 7.0
    assert np.isfinite(fit_discriminants(rows, np.repeat([0, 1], 30)).project(rows)).all()


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

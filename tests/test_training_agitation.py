"""The training half of the agitation model: fuzzy weights, balance, and agreement with the run-time half."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.acoustic.speaker import SpeakerReference, TypicalSpeaker
from app.model import Level
from training.agitation.corpus import Samples, read_recordings
from training.agitation.fuzzy_svm import (
    balanced_weights,
    fit_fuzzy,
    joint_logistic,
    relative_features,
    speaker_folds,
    to_machine,
    train,
)

SHARED_SPEECH = Path(__file__).resolve().parents[2] / "shared" / "data" / "speech"

CLOUDS = {"clouds": 1.0}


def clouds(count: int = 120, seed: int = 0) -> Samples:
    """Three overlapping clouds along the diagonal, one a level, spoken by eight speakers."""
    random = np.random.default_rng(seed)
    levels = np.arange(count) % 3
    return Samples(
        features=random.normal(0, 1, (count, 12)) + (levels[:, np.newaxis] - 1) * 1.0,
        memberships=np.eye(3)[levels],
        levels=levels,
        corpora=np.full(count, "clouds"),
        speakers=np.array([f"clouds/{number % 8}" for number in range(count)]),
    )


def test_run_time_decision_values_equal_scikit_learns() -> None:
    samples = clouds()
    weights = balanced_weights(samples, CLOUDS)
    svm = fit_fuzzy(samples.features, weights[:, 0], weights[:, 1] + weights[:, 2], 0.02)
    machine = to_machine(svm, 1.0, 0.0)
    unseen = np.random.default_rng(1).normal(0, 2, (50, 12))
    ours = [machine.decision_value(point, 0.02) for point in unseen]
    assert ours == pytest.approx(svm.decision_function(unseen), abs=1e-9)


def test_the_trained_model_tells_unseen_clouds_apart() -> None:
    model, unseen = train(clouds(), "paper", CLOUDS), clouds(seed=1)
    levels = [list(Level).index(model.judge(point).level) for point in unseen.features]
    assert np.mean(np.array(levels) == unseen.levels) > 0.9


def judged_medium(memberships: tuple[float, float, float]) -> float:
    """How medium a place far from the clouds is judged, when trained with samples there of these memberships."""
    samples, place = clouds(), np.array([-6.0, 6.0] * 6)
    there = Samples(
        np.random.default_rng(2).normal(0, 1, (40, 12)) + place,
        np.tile(memberships, (40, 1)),
        np.full(40, -1),
        samples.corpora[:40],
        samples.speakers[:40],
    )
    fields = ("features", "memberships", "levels", "corpora", "speakers")
    both = Samples(*(np.concatenate([getattr(samples, name), getattr(there, name)]) for name in fields))
    return train(both, "paper", CLOUDS).judge(place).medium


def test_known_speakers_are_told_apart_where_unknown_ones_are_not() -> None:
    """Speakers whose voices differ far more than their levels do."""
    samples, unseen = (with_speakers(clouds(480, seed), seed) for seed in (0, 1))
    model = train(samples, "paper", CLOUDS)
    right = {True: 0, False: 0}
    for row, level in enumerate(unseen.levels):
        others = (unseen.speakers == unseen.speakers[row]) & (np.arange(480) != row)
        reference = SpeakerReference.of("paper", unseen.features[others])
        for known in right:
            agitation = model.judge(unseen.features[row], reference if known else None)
            right[known] += list(Level).index(agitation.level) == level
    assert right[True] > 0.85 * 480 > 0.75 * 480 > right[False]


def with_speakers(samples: Samples, seed: int) -> Samples:
    random = np.random.default_rng(seed + 10)
    shifts = {speaker: random.normal(0, 1) * 3 for speaker in np.unique(samples.speakers)}
    shift = np.array([shifts[speaker] for speaker in samples.speakers])
    return replace(samples, features=samples.features + shift[:, np.newaxis])


def test_unknown_features_teach_as_average_ones() -> None:
    samples = clouds()
    features = samples.features.copy()
    features[5, 3] = np.nan
    model = train(replace(samples, features=features), "paper", CLOUDS)
    assert model.typical.mean[3] == pytest.approx(np.delete(samples.features[:, 3], 5).mean())


def test_a_recording_is_no_part_of_its_own_reference() -> None:
    samples = clouds(24)
    typical = TypicalSpeaker(np.zeros(12), np.ones(12))
    before = relative_features(samples, typical, "paper")[0]
    features = samples.features.copy()
    features[0] += 1.0
    moved = relative_features(replace(samples, features=features), typical, "paper")[0]
    deviation = np.sqrt((2 * samples.features[[8, 16]].var(axis=0) + 8) / 10)
    assert moved - before == pytest.approx(1 / deviation)


def test_the_joint_logistic_recovers_what_drew_the_levels() -> None:
    random = np.random.default_rng(0)
    values = random.normal(0, 1, (20_000, 3))
    slopes, offsets = np.array([1.0, 2.0, 3.0]), np.array([0.5, 0.0, -0.5])
    shares = np.exp(values * slopes + offsets)
    drawn = (shares / shares.sum(axis=1, keepdims=True)).cumsum(axis=1) > random.uniform(size=(20_000, 1))
    found = joint_logistic(values, np.eye(3)[drawn.argmax(axis=1)])
    assert found[0] == pytest.approx(slopes, abs=0.15)
    assert found[1] - found[1].mean() == pytest.approx(offsets, abs=0.1)


def test_samples_of_two_levels_are_judged_between_them() -> None:
    low, between, medium = (judged_medium(given) for given in ((1, 0, 0), (0.5, 0.5, 0), (0, 1, 0)))
    assert low + 0.2 < between < medium - 0.1


def test_levels_weigh_the_same_and_corpora_as_told() -> None:
    samples = clouds(90)
    lopsided = Samples(
        samples.features,
        np.eye(3)[[0] * 50 + [1] * 5 + [2] * 5 + [0] * 5 + [1] * 10 + [2] * 15],
        samples.levels,
        np.array(["one"] * 60 + ["two"] * 30),
        samples.speakers,
    )
    weights = balanced_weights(lopsided, {"one": 1.0, "two": 4.0})
    assert weights[:60].sum(axis=0) == pytest.approx([10, 10, 10])
    assert weights[60:].sum(axis=0) == pytest.approx([20, 20, 20])


def test_no_speaker_is_in_two_folds() -> None:
    speakers = clouds().speakers
    folds = list(speaker_folds(speakers, 3))
    assert np.sum(folds, axis=0).tolist() == [1] * len(speakers)
    assert all(set(speakers[fold]).isdisjoint(speakers[~fold]) for fold in folds)


@pytest.mark.skipif(not SHARED_SPEECH.is_dir(), reason="needs ../shared")
def test_labels_are_read_as_memberships() -> None:
    recordings = read_recordings(SHARED_SPEECH, ("ravdess",))
    assert all(sum(recording.memberships) == 1 for recording in recordings)
    assert {recording.level for recording in recordings} == {*Level, None}
    for recording in recordings:
        if recording.level is not None:
            assert recording.memberships[list(Level).index(recording.level)] == 1

"""The training half of the agitation model: fuzzy weights, balance, and agreement with the run-time half."""

from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest
from sklearn.svm import SVC

from tests.support.shared_data import SHARED_SPEECH, needs
from training.agitation import choosing
from training.agitation.choosing import choose
from training.agitation.conditions import TRAINING_CONDITIONS
from training.agitation.corpus import Recording, Samples, describe, read_recordings
from training.agitation.degradations import by_telephone, in_white_noise
from training.agitation.fuzzy_svm import (
    Recipe,
    balanced_weights,
    fit_fuzzy,
    joint_logistic,
    relative_features,
    speaker_folds,
    train,
    train_svm,
)
from understudy.acoustic.agitation.classifier import squared_distances
from understudy.acoustic.agitation.utterance_features import TypicalSpeaker
from understudy.model import Audio, Level
from understudy.model.voice.signal import SpeakerReference

RECIPE = Recipe(features=12, reach=0.25, cost=1.0, corpus_shares={"clouds": 1.0})


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
        conditions=np.full(count, "clean"),
    )


def test_run_time_decision_values_equal_scikit_learns() -> None:
    samples, unseen = clouds(), np.random.default_rng(1).normal(0, 2, (50, 12))
    svm = train_svm(samples, balanced_weights(samples, RECIPE.corpus_shares), RECIPE)
    points = (samples.features - svm.mean) / svm.scale
    theirs = SVC(C=RECIPE.cost, gamma=float(RECIPE.gamma[0])).fit(points, samples.levels == 0)
    ours = [svm.decision_values(features)[0] for features in unseen]
    assert ours == pytest.approx(theirs.decision_function((unseen - svm.mean) / svm.scale), abs=5e-3)


def test_a_sample_on_both_sides_is_a_sample_twice() -> None:
    points = clouds(30).features
    kernel = np.exp(-0.02 * squared_distances(points, points))
    inside = np.tile([1.0, 0.0, 0.3], 10)
    surface = fit_fuzzy(kernel, inside, 1 - inside, 2.0)
    sides, rows = np.array([1.0] * 20 + [-1.0] * 20), np.concatenate([np.nonzero(inside)[0], np.nonzero(1 - inside)[0]])
    weights = np.concatenate([inside[inside > 0], (1 - inside)[inside < 1]])
    theirs = SVC(C=2.0, gamma=0.02).fit(points[rows], sides, weights)
    assert kernel @ surface.coefficients + surface.intercept == pytest.approx(
        theirs.decision_function(points), abs=5e-3
    )


def test_the_trained_model_tells_unseen_clouds_apart() -> None:
    model, unseen = train(clouds(), "paper", RECIPE), clouds(seed=1)
    levels = [list(Level).index(model.judge(point).level) for point in unseen.features]
    assert np.mean(np.array(levels) == unseen.levels) > 0.9


def joined(*parts: Samples) -> Samples:
    return Samples(*(np.concatenate([getattr(part, c.name) for part in parts]) for c in fields(Samples)))


def judged_medium(memberships: tuple[float, float, float]) -> float:
    """How medium a place far from the clouds is judged, when trained with samples there of these memberships."""
    samples, place = clouds(), np.array([-6.0, 6.0] * 6)
    there = Samples(
        np.random.default_rng(2).normal(0, 1, (40, 12)) + place,
        np.tile(memberships, (40, 1)),
        np.full(40, -1),
        samples.corpora[:40],
        samples.speakers[:40],
        samples.conditions[:40],
    )
    both = joined(samples, there)
    return train(both, "paper", RECIPE).judge(place).medium


def test_known_speakers_are_told_apart_where_unknown_ones_are_not() -> None:
    """Speakers whose voices differ far more than their levels do."""
    samples, unseen = (with_speakers(clouds(480, seed), seed) for seed in (0, 1))
    model = train(samples, "paper", RECIPE)
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
    model = train(replace(samples, features=features), "paper", RECIPE)
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
    lopsided = replace(
        samples,
        memberships=np.eye(3)[[0] * 50 + [1] * 5 + [2] * 5 + [0] * 5 + [1] * 10 + [2] * 15],
        corpora=np.array(["one"] * 60 + ["two"] * 30),
    )
    weights = balanced_weights(lopsided, {"one": 1.0, "two": 2.0})
    assert weights[:60].sum(axis=0) == pytest.approx([10, 10, 10])
    assert weights[60:].sum(axis=0) == pytest.approx([20, 20, 20])


def test_a_recording_heard_twice_counts_once() -> None:
    once = clouds(30)
    twice = joined(once, replace(once, conditions=np.full(30, "degraded")))
    alone, shared = (balanced_weights(samples, RECIPE.corpus_shares) for samples in (once, twice))
    assert shared[:30] + shared[30:] == pytest.approx(alone)


def test_a_reference_is_of_the_same_condition() -> None:
    """Degraded copies that lie elsewhere leave the clean recordings' distances as they were."""
    once = clouds(30)
    moved = replace(once, features=once.features + 7.0, conditions=np.full(30, "degraded"))
    typical = TypicalSpeaker(np.zeros(12), np.ones(12))
    alone, both = (relative_features(samples, typical, "paper") for samples in (once, joined(once, moved)))
    assert both[:30] == pytest.approx(alone)


def test_features_that_have_no_say_change_nothing() -> None:
    model = train(clouds(), "paper", replace(RECIPE, features=5))
    features = np.linspace(-1, 1, 12)
    changed = np.append(features[:5], 100 * np.ones(7))
    assert model.judge(features) == model.judge(changed)


def test_the_choice_leaves_out_features_that_mislead_about_other_speakers(monkeypatch: pytest.MonkeyPatch) -> None:
    """Half the features are each speaker's own way to each level: learnt by heart they mislead about the next."""
    monkeypatch.setattr(choosing, "FEATURES", {"paper": (12, 24)})
    monkeypatch.setattr(choosing, "CORPUS_SHARES", ({"ravdess": 1.0},))
    samples, random = clouds(240), np.random.default_rng(3)
    _, speakers = np.unique(samples.speakers, return_inverse=True)
    wide = np.hstack([samples.features, random.normal(0, 5, (8, 3, 12))[speakers, samples.levels]])
    assert choose(replace(samples, features=wide, corpora=np.full(240, "ravdess")), "paper").features == 12


@pytest.mark.parametrize("condition", TRAINING_CONDITIONS)
def test_a_recording_is_degraded_the_same_way_each_time(condition: str) -> None:
    audio = Audio(np.sin(np.arange(4000) / 7))
    once, again = (TRAINING_CONDITIONS[condition](audio, np.random.default_rng(5)).samples for _ in range(2))
    assert np.array_equal(once, again)


@pytest.mark.parametrize(("condition", "factor"), [("deeper", 0.9), ("higher", 1.12)])
def test_in_another_voice_pitch_and_tempo_move_together(condition: str, factor: float) -> None:
    tone = np.sin(2 * np.pi * 200 * np.arange(16000) / 16000)
    heard = TRAINING_CONDITIONS[condition](Audio(tone), np.random.default_rng(0)).samples
    strongest_hz = np.abs(np.fft.rfft(heard, 160_000)).argmax() / 10
    assert strongest_hz == pytest.approx(200 * factor, abs=0.2)
    assert len(heard) == pytest.approx(16000 / factor, abs=1)


def test_white_noise_is_20_db_under_the_recording() -> None:
    audio = Audio(np.sin(np.arange(16000) / 7))
    noise = in_white_noise(audio, np.random.default_rng(0)).samples - audio.samples
    assert 10 * np.log10(np.mean(audio.samples**2) / np.mean(noise**2)) == pytest.approx(20)


@pytest.mark.parametrize(("frequency_hz", "share"), [(100, 0.0), (1000, 1.0), (3400, 0.5**0.5), (6000, 0.0)])
def test_a_telephone_passes_speech_alone(frequency_hz: float, share: float) -> None:
    tone = np.sin(2 * np.pi * frequency_hz * np.arange(16000) / 16000)
    heard = by_telephone(Audio(tone), np.random.default_rng(0)).samples
    assert heard.std() / tone.std() == pytest.approx(share, abs=0.05)


def test_conditions_are_described_one_after_another() -> None:
    recordings = [
        Recording(Path("a.flac"), "one", "x", Level.HIGH, (0, 0, 1)),
        Recording(Path("b"), "one", "y", None, (0, 1, 0)),
    ]
    samples = describe(recordings, {"clean": np.array([[1.0], [2.0]]), "degraded": np.array([[3.0], [4.0]])})
    assert samples.conditions.tolist() == ["clean", "clean", "degraded", "degraded"]
    assert samples.features[:, 0].tolist() == [1, 2, 3, 4]
    assert samples.levels.tolist() == [2, -1, 2, -1]
    assert samples.speakers.tolist() == ["one/x", "one/y"] * 2


def test_no_speaker_is_in_two_folds() -> None:
    speakers = clouds().speakers
    folds = list(speaker_folds(speakers, 3))
    assert np.sum(folds, axis=0).tolist() == [1] * len(speakers)
    assert all(set(speakers[fold]).isdisjoint(speakers[~fold]) for fold in folds)


@needs(SHARED_SPEECH)
def test_labels_are_read_as_memberships() -> None:
    recordings = read_recordings(SHARED_SPEECH, ("ravdess",))
    assert all(sum(recording.memberships) == 1 for recording in recordings)
    assert {recording.level for recording in recordings} == {*Level, None}
    for recording in recordings:
        if recording.level is not None:
            assert recording.memberships[list(Level).index(recording.level)] == 1

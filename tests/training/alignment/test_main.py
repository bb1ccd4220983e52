"""What the boundary model is taught: sentences read, damage cut off, degradations as stated, moves learnt."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import soundfile

from training.alignment import __main__ as training
from training.alignment.degradations import NOISE_DB, by_telephone, equalised, in_a_room, in_noise
from training.alignment.timit import Sentence, read_beginnings, read_sentence, read_sentences
from understudy.acoustic.alignment.boundaries import CONTEXT_STEPS, BoundaryArrays, kernel, mel_levels
from understudy.model import SAMPLE_RATE_HZ, FloatArray, Interval, Phone, Word

NARROW_HZ = 4000


def _write(folder: Path, name: str, *, damaged_from_s: float | None = None) -> None:
    """Three words of a phone each, from 0.5, 1.0 and 1.5 s, in two seconds."""
    samples = 0.3 * np.sin(np.arange(2 * SAMPLE_RATE_HZ))
    if damaged_from_s is not None:
        samples[round(damaged_from_s * SAMPLE_RATE_HZ) :] = 0.99
    soundfile.write(folder / f"{name}.flac", samples, SAMPLE_RATE_HZ)
    for suffix, labels in ((".wrd", ("ma", "na", "la")), (".phn", ("m", "n", "el"))):
        rows = [f"{8000 * number} {8000 * (number + 1)} {label}" for number, label in enumerate(labels, start=1)]
        (folder / name).with_suffix(suffix).write_text("\n".join(rows))


def test_damaged_sentences_are_left_out_and_their_whole_words_kept_apart(tmp_path: Path) -> None:
    _write(tmp_path, "whole")
    for name, damaged_from_s in (("late", 1.7), ("early", 1.05)):
        _write(tmp_path, name, damaged_from_s=damaged_from_s)
    whole, count = read_sentences(tmp_path)
    assert ([each.text for each in whole], count) == (["ma na la"], 3)
    (beginning,) = read_beginnings(tmp_path)
    assert beginning.text == "ma na"
    assert beginning.words == (Interval(0.5, 1.0), Interval(1.0, 1.5))
    assert beginning.audio.duration_s == 1.5


def _word(number: int, label: str, start_s: float, end_s: float) -> Word:
    return Word(number, "word", Interval(start_s, end_s), (Phone(label, Interval(start_s, end_s)),))


def _sentence(folder: Path) -> Sentence:
    _write(folder, "whole")
    return read_sentence(folder / "whole.wrd")


def test_true_times_are_the_labellers_where_the_phones_are_the_same(tmp_path: Path) -> None:
    words = (_word(0, "M", 0.48, 1.02), _word(1, "N", 1.02, 1.40), _word(2, "L", 1.55, 1.90))
    assert list(training.true_times_s(_sentence(tmp_path), words)) == [0.5, 1.0, 1.5, 1.5, 2.0]


@pytest.mark.parametrize("degrade", [in_noise, in_a_room, by_telephone, equalised])
def test_degraded_speech_is_as_long_and_as_it_was_by_the_same_seed(
    degrade: Callable[[FloatArray, np.random.Generator], FloatArray],
) -> None:
    samples = np.random.default_rng(0).standard_normal(SAMPLE_RATE_HZ + 1)
    degraded, again = (degrade(samples, np.random.default_rng(1)) for _ in range(2))
    assert degraded.shape == samples.shape
    assert np.array_equal(degraded, again)
    assert not np.allclose(degraded, samples, atol=0.1)


def test_noise_is_as_loud_as_stated_and_a_telephone_lets_nothing_high_pass() -> None:
    samples = np.random.default_rng(0).standard_normal(SAMPLE_RATE_HZ)
    for seed in range(5):
        noise = in_noise(samples, np.random.default_rng(seed)) - samples
        assert NOISE_DB[0] <= 10 * np.log10(np.mean(noise**2) / np.mean(samples**2)) <= NOISE_DB[1]
    power = np.abs(np.fft.rfft(by_telephone(samples, np.random.default_rng(0)))) ** 2
    assert power[NARROW_HZ + 200 :].sum() < 0.001 * power.sum()


def test_moves_are_learnt_in_spite_of_outliers(monkeypatch: pytest.MonkeyPatch) -> None:
    """Silence becomes noise every 400 ms; places lie up to 20 ms around, and a tenth of the moves is wrong."""
    chance = np.random.default_rng(0)
    loud = np.arange(40 * SAMPLE_RATE_HZ) // (SAMPLE_RATE_HZ // 5) % 2
    levels = mel_levels(chance.standard_normal(len(loud)) * loud)
    onsets_s = np.arange(0.2, 39.0, 0.4)
    moves_s = chance.uniform(-0.020, 0.020, len(onsets_s))
    places = BoundaryArrays(onsets_s - moves_s, np.full((len(moves_s), 2), 0.1), np.full((len(moves_s), 2), 8, np.int8))
    taught_s = np.where(np.arange(len(moves_s)) % 10 == 0, 0.060, moves_s)
    monkeypatch.setattr(training, "SUPPORTS", 80)
    monkeypatch.setattr(training, "RIDGE", 0.1)
    model = training.train([training.Examples(levels, places, taught_s)])
    assert len(model.supports) == 80
    assert len(model.view.mean) == (2 * CONTEXT_STEPS + 1) * levels.shape[1]
    learnt_s = kernel(model.view.points(levels, places), model.supports) @ model.weights_s
    assert np.mean(np.abs(learnt_s - moves_s)) < 0.006


def test_a_model_that_was_written_is_read_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    chance = np.random.default_rng(0)
    levels = mel_levels(chance.standard_normal(SAMPLE_RATE_HZ))
    places = BoundaryArrays(np.linspace(0.1, 0.9, 30), np.full((30, 2), 0.1), np.zeros((30, 2), np.int8))
    monkeypatch.setattr(training, "SUPPORTS", 20)
    model = training.train([training.Examples(levels, places, chance.normal(0, 0.01, 30))])
    training.write(model, tmp_path / "boundaries.npz")
    read = type(model).load(tmp_path / "boundaries.npz")
    ours, theirs = (kernel(each.view.points(levels, places), each.supports) @ each.weights_s for each in (model, read))
    assert np.abs(ours - theirs).max() < 0.001

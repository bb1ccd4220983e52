"""Hearing at any rate, and where phrases begin and end."""

from itertools import pairwise

import numpy as np
import pytest
import soxr

from tests.acoustic.pitch.test_streaming import LINE
from understudy.live.ear import BEGIN_FRAMES, PAUSE_FRAMES, Ear, PhraseEdge, Phrases
from understudy.model import SAMPLE_RATE_HZ, FloatArray


def pitch(samples: FloatArray, rate_hz: int) -> FloatArray:
    ear, chunk = Ear(rate_hz), rate_hz // 25
    parts = [samples[first : first + chunk] for first in range(0, len(samples), chunk)]
    return np.concatenate([ear.contours(ear.resampled(part))[1] for part in parts])


@pytest.mark.parametrize("rate_hz", [8000, 22_050, 44_100, 48_000])
def test_any_rate_will_do(rate_hz: int) -> None:
    """Frames as many as at our own rate, but for those that the resampler keeps back, and the same voice in nearly all
    of them."""
    expected_hz = pitch(LINE, SAMPLE_RATE_HZ)
    f0_hz = pitch(soxr.resample(LINE, SAMPLE_RATE_HZ, rate_hz), rate_hz)
    count = min(len(f0_hz), len(expected_hz))
    assert abs(len(f0_hz) - len(expected_hz)) <= 5
    both = (f0_hz[:count] > 0) & (expected_hz[:count] > 0)
    assert (np.abs(f0_hz[:count][both] / expected_hz[:count][both] - 1) < 0.02).mean() > 0.95


def test_the_phrase_that_goes_on_is_known() -> None:
    ear = Ear(SAMPLE_RATE_HZ)
    _, f0_hz = ear.contours(LINE)
    edges = ear.phrases(f0_hz)
    assert edges[0].begins
    assert all(one.begins is not other.begins for one, other in pairwise(edges))
    assert ear.phrase_began_s == (edges[-1].at_s if edges[-1].begins else None)


def edges(*voiced: tuple[int, bool]) -> list[PhraseEdge]:
    """Of stretches of so many frames, voiced or not."""
    f0_hz = np.concatenate([np.full(count, 120.0 if is_voiced else 0.0) for count, is_voiced in voiced])
    phrases = Phrases()
    return [edge for f0 in f0_hz for edge in phrases.hear(np.array([f0]))]


def test_a_phrase_begins_with_its_first_voice_and_ends_with_its_last() -> None:
    assert edges((50, False), (100, True), (60, False)) == [PhraseEdge(0.5, begins=True), PhraseEdge(1.5, begins=False)]


def test_a_short_pause_parts_nothing_and_a_click_is_no_voice() -> None:
    assert len(edges((20, True), (PAUSE_FRAMES - 1, False), (20, True))) == 1
    assert not edges((40, False), (BEGIN_FRAMES - 1, True), (40, False))


def test_the_next_phrase_begins_anew() -> None:
    found = edges((20, True), (PAUSE_FRAMES, False), (20, True))
    assert [edge.begins for edge in found] == [True, False, True]

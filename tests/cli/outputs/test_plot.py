"""The picture of a hand-made analysis: not its appearance, but what it must show."""

import io
import sys
from dataclasses import fields, replace
from functools import cache

import numpy as np
import pytest
from matplotlib import image
from numpy.typing import NDArray

from tests.support.words.by_hand import spoken, utterance
from understudy.cli.outputs.plot import EMPHASIS, MEMBERSHIPS, NARROWEST_INCHES, THRESHOLD, plot, require_plot
from understudy.errors import InputError, ServiceError
from understudy.model import (
    NEUTRAL,
    Agitation,
    Analysis,
    Audio,
    Contours,
    FloatArray,
    Level,
    SignalAnalysis,
    StressThresholds,
    VoiceQuality,
)

DURATION_S = 3.0
WORDS = spoken("I never said that", start_s=0.5, stressed=[1])
SAID = replace(utterance(WORDS, Level.LOW), thresholds=StressThresholds(-5.0, 150.0))


def heard(duration_s: float = DURATION_S, f0_hz: float = 120.0) -> SignalAnalysis:
    frames = 1 + round(100 * duration_s)
    voiced = np.arange(frames) % 20 < 12
    contours = Contours(
        np.linspace(-60, 5, frames),
        np.where(voiced, f0_hz, 0.0),
        np.zeros((frames, 12)),
        np.zeros((frames, 40), np.float32),
    )
    samples: FloatArray = 0.5 * np.sin(np.arange(round(16_000 * duration_s)) / 20)
    quality = VoiceQuality(*(np.zeros(frames) for _ in fields(VoiceQuality)))
    return SignalAnalysis(Audio(samples), contours, quality, np.zeros(149), Agitation(0.2, 0.5, 0.3), NEUTRAL, ())


def pixels(picture: bytes) -> NDArray[np.float32]:
    drawn: NDArray[np.float32] = image.imread(io.BytesIO(picture))
    return drawn


def coloured(picture: bytes, name: str, opacity: float = 1.0) -> int:
    """How many pixels have a colour that is drawn over white."""
    colour = np.array([int(name[place : place + 2], 16) for place in (1, 3, 5)]) / 255
    mixed = opacity * colour + 1 - opacity
    return int((np.abs(pixels(picture)[:, :, :3] - mixed).max(axis=2) < 0.02).sum())


@cache
def drawn_s(duration_s: float) -> bytes:
    """The picture of what was said in a recording of that length."""
    return plot(Analysis(SAID, ()), heard(duration_s))


def test_emphasised_words_are_marked() -> None:
    level = replace(SAID, words=spoken("I never said that", start_s=0.5))
    assert coloured(drawn_s(DURATION_S), EMPHASIS, 0.6) > 1_000
    assert coloured(plot(Analysis(level, ()), heard()), EMPHASIS, 0.6) == 0


def test_frames_above_a_threshold_are_told_from_those_below() -> None:
    below = replace(SAID, thresholds=StressThresholds(10.0, 150.0))
    assert coloured(drawn_s(DURATION_S), THRESHOLD) > coloured(plot(Analysis(below, ()), heard()), THRESHOLD)


def test_each_membership_is_as_long_as_it_says_in_a_short_line_and_in_a_long() -> None:
    lengths = [coloured(drawn_s(seconds), MEMBERSHIPS["low"]) for seconds in (DURATION_S, 20.0)]
    assert lengths[0] == pytest.approx(lengths[1], rel=0.1)


def test_a_longer_line_is_drawn_wider_and_the_shortest_are_as_wide_as_any() -> None:
    widths = [pixels(drawn_s(duration_s)).shape[1] for duration_s in (0.2, DURATION_S, 20.0)]
    assert widths[0] == widths[1] == 100 * NARROWEST_INCHES
    assert widths[2] > 3_000


def test_the_same_analysis_gives_the_same_picture() -> None:
    assert plot(Analysis(SAID, ()), heard()) == drawn_s(DURATION_S)


@pytest.mark.parametrize("words", [(), (replace(WORDS[0], interval=None, phones=(), stressed_ratio=None), *WORDS[1:])])
def test_a_line_that_is_not_fully_timed_or_voiced_is_drawn(words: tuple[()]) -> None:
    said = replace(SAID, words=words, thresholds=StressThresholds(-5.0, None), agitation=None)
    assert pixels(plot(Analysis(said, ()), heard(f0_hz=0.0))).size


@pytest.mark.parametrize("name", ["out", "out.jpg", "out.png.txt", "-"])
def test_names_that_are_no_pngs_are_refused(name: str) -> None:
    with pytest.raises(InputError) as caught:
        require_plot(name)
    assert caught.value.code == "plot_format"


def test_without_matplotlib_it_is_told_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    require_plot("out.PNG")
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(ServiceError, match=r"pip install '\.\[plot\]'") as caught:
        require_plot("out.png")
    assert caught.value.code == "plot_unavailable"

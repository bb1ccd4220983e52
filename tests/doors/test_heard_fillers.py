"""A hesitation that the transcript omits is detected and shown, from the audio to the schedule."""

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from tests.support.shipped_rules import shipped_parser, shipped_rules
from tests.support.words.by_hand import FIGURE_8, spoken
from understudy.model import Channel, Filler, Interval, Line, Utterance
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.rules.derivation import derive_functions
from understudy.schemas.responses import PerformanceResponse

AUDIO = Path(__file__).parents[1] / "audio"
BEFORE_I_THINK_S = 1.103
"""Where flite begins the second "I" of the sentence of Figure 8 (figure8.json)."""


def _spans(*fillers: Filler) -> list[tuple[int, int]]:
    """The hesitations in Figure 8's sentence, its words .4 s each from 1 s, when these fillers are heard in it."""
    words = spoken(FIGURE_8)
    heard = replace(Utterance(words, shipped_parser().parse(words)), fillers=fillers)
    functions = derive_functions(shipped_rules(), heard)
    return [
        (each.first, each.last)
        for each in functions
        if (each.class_name, each.subtype) == ("performance", "hesitation")
    ]


@pytest.mark.parametrize(
    ("start_s", "span"),
    [(0.5, (0, 0)), (1.35, (0, 1)), (2.15, (2, 3)), (5.8, (11, 11))],
    ids=["before", "after the first", "in the middle", "at the end"],
)
def test_a_filler_is_shown_over_the_words_beside_it(start_s: float, span: tuple[int, int]) -> None:
    assert _spans(Filler("um", Interval(start_s, start_s + 0.3))) == [span]


def test_nothing_hesitates_where_no_filler_is_heard() -> None:
    assert _spans() == []


def test_an_um_in_the_audio_is_told_and_turns_the_eyes_away(understudy: Understudy) -> None:
    samples, rate_hz = soundfile.read(AUDIO / "figure8.flac")
    um, _ = soundfile.read(AUDIO / "um.flac")
    content = io.BytesIO()
    soundfile.write(content, np.insert(samples, round(BEFORE_I_THINK_S * rate_hz), um), rate_hz, format="FLAC")
    performance = perform(understudy, Line(content.getvalue(), FIGURE_8), Options())
    told = PerformanceResponse.of_performance(performance)
    assert [filler.text for filler in told.fillers] == ["um"]
    (hesitation,) = (each for each in performance.functions if each.subtype == "hesitation")
    assert (hesitation.first, hesitation.last) == (2, 3)
    assert "heard_filler(um, 3)" in [because.fact for because in hesitation.because]
    shown = {behavior.kind for behavior in performance.behaviors if behavior.function == hesitation.id}
    assert shown & {Channel.GAZE, Channel.EYES}

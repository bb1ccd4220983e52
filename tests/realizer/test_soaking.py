"""A sample of `benchmarks/realizer/soak.py`: everybody in every mood, and the line that once ended in a KeyError."""

from pathlib import Path

import pytest

from tests.support.motion.soaking import Variant, broken_by, performed, variants
from tests.support.shared_data import SHARED_LINES, needs
from understudy.model import Analysis, Level, Line
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import analyze, perform

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
RECORDING = SHARED_LINES / "austen-0920.flac"
CHARACTERS = ("default", "expansive", "formal_elder", "reserved")


@pytest.fixture(scope="module")
def analysis(understudy: Understudy) -> Analysis:
    return heard(understudy, AUDIO_FOLDER / "figure8.flac")


def heard(understudy: Understudy, audio: Path) -> Analysis:
    return analyze(understudy, Line(audio.read_bytes(), audio.with_suffix(".txt").read_text(encoding="utf-8")))


@pytest.mark.parametrize("variant", list(variants(CHARACTERS, 1)), ids=str)
def test_nothing_breaks(understudy: Understudy, analysis: Analysis, variant: Variant) -> None:
    assert broken_by(understudy, analysis, variant) == []


@pytest.mark.parametrize("character", CHARACTERS)
def test_nobody_falls(understudy: Understudy, analysis: Analysis, character: str) -> None:
    assert broken_by(understudy, analysis, Variant(character, Level.HIGH, 0), physics=True) == []


def test_a_line_heard_once_is_performed_as_if_heard_anew(understudy: Understudy, analysis: Analysis) -> None:
    line = Line((AUDIO_FOLDER / "figure8.flac").read_bytes(), (AUDIO_FOLDER / "figure8.txt").read_text())
    anew = perform(understudy, line, Options(character="reserved", agitation=Level.HIGH, seed=3))
    assert performed(understudy, analysis, Variant("reserved", Level.HIGH, 3)).behaviors == anew.behaviors


@needs(RECORDING)
def test_the_line_that_ended_in_a_key_error(understudy: Understudy) -> None:
    assert broken_by(understudy, heard(understudy, RECORDING), Variant("default", Level.HIGH, 0)) == []

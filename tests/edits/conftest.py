"""A timed line without a recording, performed once for all tests of edits."""

from dataclasses import replace

import pytest

from understudy.model import Analysis, Interval, Performance, Word
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis
from understudy.rules.stage import find_functions_in_all

TEXT = "No, I told you that I have never seen so many people, and we all know it. What do you want from me?"
WORD_S = 0.35


@pytest.fixture(scope="session")
def analysis(understudy: Understudy) -> Analysis:
    words = tuple(
        Word(number, text, Interval(round(0.4 + WORD_S * number, 3), round(0.4 + WORD_S * (number + 1), 3)))
        for number, text in enumerate(TEXT.split())
    )
    [found] = find_functions_in_all(understudy.language, [words])
    return replace(found, utterance=replace(found.utterance, duration_s=round(0.8 + WORD_S * len(words), 3)))


@pytest.fixture(scope="session")
def performance(understudy: Understudy, analysis: Analysis) -> Performance:
    """The line as it is without edits."""
    return perform_analysis(understudy, analysis, Options())

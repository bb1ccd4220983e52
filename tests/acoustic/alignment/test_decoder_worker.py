"""The decoder that is kept gives the same results as a new one, regardless of its vocabulary."""

from itertools import product
from pathlib import Path

import pytest
import soundfile

from understudy.acoustic.alignment.decoder_process import FRAMES_PER_S, pcm
from understudy.acoustic.alignment.decoder_worker import FRAMES_PER_S as WORKERS_FRAMES_PER_S
from understudy.acoustic.alignment.decoder_worker import MOST_WORDS_KNOWN, NARROW, Recognizer

AUDIO = Path(__file__).parents[2] / "audio"
PHONES = ("AA", "B", "IY", "K", "M", "S")
UM = [["AH M"]]

pytestmark = pytest.mark.filterwarnings("ignore:start_stream:DeprecationWarning")  # it is needed: see `_decode`


@pytest.fixture(scope="module")
def filler() -> bytes:
    samples, _ = soundfile.read(AUDIO / "um.flac")
    return pcm(samples)


def test_both_ends_count_the_same_frames() -> None:
    assert WORKERS_FRAMES_PER_S == FRAMES_PER_S


@pytest.mark.parametrize("count", [1000, MOST_WORDS_KNOWN + 1], ids=["many words", "too many words"])
def test_what_was_learnt_before_changes_nothing(filler: bytes, count: int) -> None:
    recognizer = Recognizer()
    before = recognizer.response_to(filler, UM, more=False)
    pronunciations = [" ".join(phones) for phones, _ in zip(product(PHONES, repeat=6), range(count), strict=False)]
    recognizer.aligned(filler, [pronunciations], NARROW)
    assert recognizer.response_to(filler, UM, more=False) == before
    assert before["words"] is not None


def test_a_word_may_be_said_in_any_of_its_ways(filler: bytes) -> None:
    words = [["B AH T", "AH M", "K IY Z"]]
    assert [each[0] for each, _ in Recognizer().aligned(filler, words, NARROW)] == ["AH_M"]


def test_what_is_made_ready_for_a_line_serves_no_other(filler: bytes) -> None:
    recognizer, answers = Recognizer(), []
    for ready in (False, True, True):
        if ready:
            recognizer.prepare()
        answers.append(recognizer.response_to(filler, UM, more=False))
    assert answers[0] == answers[1] == answers[2]

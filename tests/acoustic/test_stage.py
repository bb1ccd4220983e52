"""The recording is measured while the aligner's process times the words."""

import threading
from pathlib import Path

import psutil
import pytest

from understudy.acoustic.alignment.aligner import WINDOW_DELAY_S
from understudy.acoustic.alignment.decoder_process import FRAMES_PER_S
from understudy.acoustic.models import AcousticModels
from understudy.acoustic.stage import hear
from understudy.errors import InputError
from understudy.model import Line, Word
from understudy.models import Understudy

EXAMPLE = Path(__file__).parents[2] / "examples" / "example.flac"


def _line(text: str = "") -> Line:
    return Line(EXAMPLE.read_bytes(), text or EXAMPLE.with_suffix(".txt").read_text(encoding="utf-8"))


def _aligners() -> set[int]:
    return {
        child.pid
        for child in psutil.Process().children()
        if child.status() != psutil.STATUS_ZOMBIE and any("decoder_worker" in part for part in child.cmdline())
    }


def _threads() -> set[str]:
    return {thread.name for thread in threading.enumerate() if thread.name.startswith("align")}


def test_who_breaks_off_leaves_neither_a_thread_nor_a_working_aligner(understudy: Understudy) -> None:
    before = hear(understudy.acoustic, _line())
    idle = _aligners()

    def break_off(stage: str) -> None:
        if stage == "contours":
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        hear(understudy.acoustic, _line(), break_off)
    assert not _threads()
    assert idle - _aligners()
    assert hear(understudy.acoustic, _line()).words == before.words


def test_a_text_that_does_not_fit_costs_no_aligner(understudy: Understudy) -> None:
    hear(understudy.acoustic, _line())
    idle = _aligners()
    with pytest.raises(InputError, match="not what is said"):
        hear(understudy.acoustic, _line("Every morning the baker carries seven loaves across the frozen river. " * 3))
    assert _aligners() == idle
    assert not _threads()


def test_with_free_data_alone_times_are_the_decoders_own(understudy: Understudy) -> None:
    free = understudy.acoustic.settings.model_copy(update={"model_data": "free"})
    with AcousticModels.load(free) as models:
        assert all(map(_is_in_a_frame, hear(models, _line()).words))
    assert not all(map(_is_in_a_frame, hear(understudy.acoustic, _line()).words))


def _is_in_a_frame(word: Word) -> bool:
    """Whether the decoder may have put the beginning of a word there, which it does frame by frame."""
    assert word.interval
    frame = (word.interval.start_s - WINDOW_DELAY_S) * FRAMES_PER_S
    return abs(frame - round(frame)) < 0.1

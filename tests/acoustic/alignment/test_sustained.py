"""Sounds too long for speech are silenced, and only better alignments are kept."""

import numpy as np
import pytest

from understudy.acoustic.alignment.decoder_process import Decoded, DecodedPhone
from understudy.acoustic.alignment.decoder_signal import FRAME_SAMPLES
from understudy.acoustic.alignment.sustained import KEPT_FRAMES, LONGEST_SOUND_FRAMES, fits_better, silenced

SHORT = DecodedPhone("T", 0, 10, -100)


def _decoded(phone: DecodedPhone, *fillers: DecodedPhone) -> Decoded:
    return Decoded([[SHORT, phone]], list(fillers))


def _lasting(frames: int, per_frame: int = -10, label: str = "AH") -> DecodedPhone:
    return DecodedPhone(label, 10, frames, frames * per_frame)


def test_speech_is_left_alone() -> None:
    assert silenced(np.ones(100), _decoded(_lasting(LONGEST_SOUND_FRAMES))) is None


def test_a_sound_that_is_too_long_is_silenced_but_for_its_end() -> None:
    frames = LONGEST_SOUND_FRAMES + 1
    rest = silenced(np.ones(1000 * FRAME_SAMPLES), _decoded(_lasting(frames)))
    assert rest is not None
    (silent,) = np.nonzero(rest == 0)
    assert (silent[0], silent[-1] + 1) == (10 * FRAME_SAMPLES, (10 + frames - KEPT_FRAMES) * FRAME_SAMPLES)


@pytest.mark.parametrize(("after", "kept"), [(-20, False), (-10, False), (-5, False), (0, True)])
def test_a_vowel_that_really_is_long_stays(after: int, kept: bool) -> None:
    assert fits_better(_decoded(_lasting(20, after)), _decoded(_lasting(200, -10))) is kept


@pytest.mark.parametrize(
    "before",
    [_decoded(_lasting(20), _lasting(200, label="um")), _decoded(_lasting(200, label="HH"))],
    ids=["filler", "breath"],
)
def test_what_nobody_can_draw_out_goes_unless_the_words_fit_worse_without_it(before: Decoded) -> None:
    assert fits_better(_decoded(_lasting(20)), before)
    assert not fits_better(_decoded(_lasting(20, -30)), before)

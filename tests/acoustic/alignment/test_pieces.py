"""Long audio is cut in pauses, word times agree with those of short lines, and fillers are found between words."""

import json
from pathlib import Path

import numpy as np
import pytest
import soundfile

from understudy.acoustic.alignment.decoder_process import (
    FRAME_SAMPLES,
    FRAMES_PER_S,
    DecodedLine,
    DecodedPhone,
    DecoderProcess,
    FrameSpan,
)
from understudy.acoustic.alignment.pieces import (
    KEPT_FRAMES,
    LONGEST_SOUND_FRAMES,
    PIECE_FRAMES,
    UNSURE_FRAMES,
    Cut,
    cuts_in_pauses,
    decode_in_pieces,
    fits_better,
    silenced,
)
from understudy.model import SAMPLE_RATE_HZ, FloatArray

AUDIO = Path(__file__).resolve().parents[2] / "audio"
PAUSE = np.zeros(SAMPLE_RATE_HZ // 2)


def _figure8() -> tuple[FloatArray, list[list[str]], list[float]]:
    """A line of flite's, the phones of its words, and where they begin."""
    samples, _ = soundfile.read(AUDIO / "figure8.flac")
    words = json.loads((AUDIO / "figure8.json").read_text(encoding="utf-8"))["words"]
    return (
        samples,
        [[" ".join(phone["label"] for phone in word["phones"])] for word in words],
        [word["phones"][0]["start_s"] for word in words],
    )


def _decoded(samples: FloatArray, words: list[list[str]]) -> DecodedLine | None:
    process = DecoderProcess()
    try:
        return decode_in_pieces(process, samples, words)
    finally:
        process.close()


def _starts_s(decoded: DecodedLine) -> FloatArray:
    return np.array([word[0].first_frame for word in decoded.words]) / FRAMES_PER_S


def test_audio_of_several_pieces_has_every_word_where_it_was_spoken() -> None:
    samples, words, starts_s = _figure8()
    length_s = (len(samples) + len(PAUSE)) / SAMPLE_RATE_HZ
    times = int(60 / length_s)
    decoded = _decoded(np.tile(np.concatenate([samples, PAUSE]), times), words * times)
    assert decoded is not None
    expected_s = np.concatenate([np.array(starts_s) + length_s * number for number in range(times)])
    assert np.abs(_starts_s(decoded) - expected_s).max() < 0.080
    assert decoded.fillers == []


def test_a_minute_of_silence_before_the_line_has_no_word() -> None:
    samples, words, starts_s = _figure8()
    decoded = _decoded(np.concatenate([np.zeros(60 * SAMPLE_RATE_HZ), samples]), words)
    assert decoded is not None
    assert np.abs(_starts_s(decoded) - 60 - starts_s).max() < 0.080


def test_a_filler_is_found_where_it_was_said_and_words_keep_their_places() -> None:
    samples, words, starts_s = _figure8()
    filler, _ = soundfile.read(AUDIO / "um.flac")
    cut = round(starts_s[4] * SAMPLE_RATE_HZ)
    inserted = np.concatenate([PAUSE[:2000], filler, PAUSE[:2000]])
    decoded = _decoded(np.concatenate([samples[:cut], inserted, samples[cut:]]), words)
    assert decoded is not None
    (found,) = decoded.fillers
    assert found.label == "um"
    middle_s = (found.first_frame + found.frames / 2) / FRAMES_PER_S
    assert abs(middle_s - (cut + len(inserted) / 2) / SAMPLE_RATE_HZ) < 0.1
    expected_s = np.array(starts_s) + np.where(np.arange(len(words)) < 4, 0, len(inserted) / SAMPLE_RATE_HZ)
    assert np.abs(_starts_s(decoded) - expected_s).max() < 0.080


def test_more_words_than_can_be_said_have_no_path() -> None:
    samples, words, _ = _figure8()
    assert _decoded(samples, words * 9) is None


def _spans(*pauses_s: float) -> list[FrameSpan]:
    """Words of half a second with these pauses before them."""
    starts_s = np.cumsum(pauses_s) + 0.5 * np.arange(len(pauses_s))
    return [FrameSpan(True, round(start_s * FRAMES_PER_S), FRAMES_PER_S // 2) for start_s in starts_s]


def test_a_stretch_is_cut_in_the_last_clear_pause_before_a_piece_gets_too_long() -> None:
    spans = _spans(*[0.0, 0.0, 0.0, 0.4] * 13)
    cuts = cuts_in_pauses(spans, 30 * FRAMES_PER_S)
    assert [cut.words % 4 for cut in cuts] == [3] * len(cuts)
    lengths = np.diff([0, *(cut.frame for cut in cuts)])
    assert lengths.max() <= PIECE_FRAMES
    assert all(spans[cut.words - 1].end_frame < cut.frame < spans[cut.words].first_frame for cut in cuts[:-1])


def test_what_is_heard_last_is_left_to_the_next_stretch() -> None:
    frames = 30 * FRAMES_PER_S
    cuts = cuts_in_pauses(_spans(*[0.4] * 33), frames)
    assert cuts[-1].frame <= frames - UNSURE_FRAMES
    assert cuts[-1].words < 33


def test_without_a_clear_pause_the_longest_is_taken() -> None:
    (cut,) = cuts_in_pauses(_spans(*[0.02] * 20, 0.1, *[0.02] * 40), 30 * FRAMES_PER_S)
    assert cut.words == 20


def test_no_cut_goes_through_a_filler() -> None:
    words = _spans(*[1.5] * 14)
    fillers = [FrameSpan(False, word.first_frame - FRAMES_PER_S, FRAMES_PER_S // 2) for word in words]
    cuts = cuts_in_pauses(sorted([*words, *fillers], key=lambda span: span.first_frame), 30 * FRAMES_PER_S)
    assert len(cuts) == 3
    assert not [cut for cut in cuts for each in fillers if each.first_frame < cut.frame < each.end_frame]


def test_where_no_word_is_heard_only_the_unsure_end_is_left() -> None:
    assert cuts_in_pauses([], 30 * FRAMES_PER_S) == [Cut(0, 30 * FRAMES_PER_S - UNSURE_FRAMES)]


SHORT = DecodedPhone("T", 0, 10, -100)


def _found(phone: DecodedPhone, *fillers: DecodedPhone) -> DecodedLine:
    return DecodedLine([[SHORT, phone]], list(fillers))


def _lasting(frames: int, per_frame: int = -10, label: str = "AH") -> DecodedPhone:
    return DecodedPhone(label, 10, frames, frames * per_frame)


def test_speech_is_left_alone() -> None:
    assert silenced(np.ones(100), _found(_lasting(LONGEST_SOUND_FRAMES))) is None


def test_a_sound_that_is_too_long_is_silenced_but_for_its_end() -> None:
    frames = LONGEST_SOUND_FRAMES + 1
    rest = silenced(np.ones(1000 * FRAME_SAMPLES), _found(_lasting(frames)))
    assert rest is not None
    (silent,) = np.nonzero(rest == 0)
    assert (silent[0], silent[-1] + 1) == (10 * FRAME_SAMPLES, (10 + frames - KEPT_FRAMES) * FRAME_SAMPLES)


@pytest.mark.parametrize(("after", "kept"), [(-20, False), (-10, False), (-5, False), (0, True)])
def test_a_vowel_that_really_is_long_stays(after: int, kept: bool) -> None:
    assert fits_better(_found(_lasting(20, after)), _found(_lasting(200, -10))) is kept


@pytest.mark.parametrize(
    "before",
    [_found(_lasting(20), _lasting(200, label="um")), _found(_lasting(200, label="HH"))],
    ids=["filler", "breath"],
)
def test_what_nobody_can_draw_out_goes_unless_the_words_fit_worse_without_it(before: DecodedLine) -> None:
    assert fits_better(_found(_lasting(20)), before)
    assert not fits_better(_found(_lasting(20, -30)), before)

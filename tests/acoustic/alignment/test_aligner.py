"""Words and phones are found where flite spoke them; wrong texts are detected; crashes of the decoder are handled."""

import io
import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
import soundfile
import soxr

from understudy.acoustic.alignment.aligner import Aligner, spread
from understudy.acoustic.alignment.decoder_process import DecoderProcess, pcm
from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.errors import InputError, ServiceError
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray, Interval, Phone, Word
from understudy.text.transcript import read_transcript

ROOT = Path(__file__).resolve().parents[3]
TRUTH = ROOT / "tests" / "audio"
LINES = {"figure8": TRUTH, "numbers": TRUTH, "example": ROOT / "examples"}

MATCHING_LABELS = {"must've"}
"""flite says "must've" with the schwa it folds to AH, the dictionary with IH."""

DIES_ONCE = """
import json, os, pathlib, sys
requests, died = sys.stdin.buffer, pathlib.Path(__file__).with_suffix(".died")
requests.read(json.loads(requests.readline())["bytes"])
if not died.exists():
    died.touch()
    os.abort()
print(json.dumps({"words": None}), flush=True)
"""


@pytest.fixture(scope="module")
def aligner() -> Iterator[Aligner]:
    with Aligner(ROOT / "models", ROOT / "lexicon" / "en") as whole:
        whole.warm_up()
        yield whole


def _words(text: str) -> tuple[Word, ...]:
    return read_transcript(text, max_characters=1000)


def _line(name: str) -> tuple[Audio, tuple[Word, ...]]:
    samples, rate_hz = soundfile.read(LINES[name] / f"{name}.flac")
    assert rate_hz == SAMPLE_RATE_HZ
    return Audio(samples), _words((LINES[name] / f"{name}.txt").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", LINES)
def test_words_and_phones_lie_where_they_were_spoken(aligner: Aligner, name: str) -> None:
    audio, transcript = _line(name)
    truth = json.loads((TRUTH / f"{name}.json").read_text(encoding="utf-8"))["words"]
    words, notices = aligner.align(audio, transcript)
    assert notices == ()
    assert [(word.index, word.text) for word in words] == [(word["index"], word["text"]) for word in truth]
    errors_s = []
    for word, spoken in zip(words, truth, strict=True):
        if word.text not in MATCHING_LABELS:
            assert [phone.label for phone in word.phones] == [phone["label"] for phone in spoken["phones"]]
        errors_s += [
            abs(ours.interval.start_s - theirs["start_s"])
            for ours, theirs in zip(word.phones, spoken["phones"], strict=True)
        ]
    assert np.mean(np.array(errors_s) <= 0.020) > 0.8
    assert max(errors_s) <= 0.080


def test_phones_fill_their_words_and_words_follow_each_other(aligner: Aligner) -> None:
    audio, transcript = _line("numbers")
    words = [word for word in aligner.align(audio, transcript)[0] if word.interval is not None]
    end_s = 0.0
    for word in words:
        assert word.interval is not None
        edges_s = [time_s for phone in word.phones for time_s in (phone.interval.start_s, phone.interval.end_s)]
        assert (edges_s[0], edges_s[-1]) == (word.interval.start_s, word.interval.end_s)
        assert edges_s == sorted(edges_s)
        assert edges_s[0] >= end_s
        end_s = edges_s[-1]
    assert end_s <= audio.duration_s


def test_a_word_that_is_not_spoken_keeps_its_number_and_has_no_time(aligner: Aligner) -> None:
    audio, transcript = _line("numbers")
    dash = aligner.align(audio, transcript)[0][8]
    assert dash == Word(8, "—")


def test_the_same_line_gives_the_same_answer_whatever_came_before(aligner: Aligner) -> None:
    first = aligner.align(*_line("figure8"))
    aligner.align(*_line("example"))
    assert aligner.align(*_line("figure8")) == first


def test_times_do_not_depend_on_loudness_or_on_silence_before(aligner: Aligner) -> None:
    audio, transcript = _line("figure8")
    words = aligner.align(audio, transcript)[0]
    quiet = aligner.align(Audio(audio.samples * 0.01), transcript)[0]
    late = aligner.align(Audio(np.concatenate([np.zeros(SAMPLE_RATE_HZ), audio.samples])), transcript)[0]
    for word, softer, later in zip(words, quiet, late, strict=True):
        assert word.interval is not None
        assert softer.interval is not None
        assert later.interval is not None
        assert softer.interval.start_s == pytest.approx(word.interval.start_s, abs=0.020)
        assert later.interval.start_s - 1.0 == pytest.approx(word.interval.start_s, abs=0.020)


def test_a_guessed_pronunciation_and_an_unreadable_word_are_noticed(aligner: Aligner) -> None:
    audio, _ = _line("figure8")
    text = "I guess not, I think I must've misread all of thoze signals. Привет"
    words, notices = aligner.align(audio, _words(text))
    assert [notice.code for notice in notices] == ["pronunciation_guessed", "word_unreadable"]
    assert "thoze" in notices[0].message
    assert "12 (Привет)" in notices[1].message
    assert words[12].interval is None


def test_a_filler_that_the_text_lacks_is_heard_between_the_words(aligner: Aligner) -> None:
    audio, transcript = _line("figure8")
    filler, _ = soundfile.read(TRUTH / "um.flac")
    begin = aligner.align(audio, transcript)[0][3].interval
    assert begin is not None
    cut = round(begin.start_s * SAMPLE_RATE_HZ)
    hesitant = Audio(np.concatenate([audio.samples[:cut], filler, audio.samples[cut:]]))
    (heard,) = aligner.listen(hesitant, transcript).fillers
    assert heard.text == "um"
    assert heard.interval.start_s == pytest.approx(begin.start_s, abs=0.1)
    assert heard.interval.duration_s == pytest.approx(len(filler) / SAMPLE_RATE_HZ, abs=0.1)


def test_words_after_music_lie_where_they_were_spoken_and_the_music_is_told(aligner: Aligner) -> None:
    audio, transcript = _line("figure8")
    times_s = np.arange(2 * SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ
    music = sum(0.1 * np.sin(2 * np.pi * hertz * times_s) for hertz in (220.0, 277.2, 329.6, 440.0, 659.3))
    alignment = aligner.listen(Audio(np.concatenate([music, audio.samples])), transcript)
    for before, after in zip(aligner.align(audio, transcript)[0], alignment.words, strict=True):
        assert before.interval is not None
        assert after.interval is not None
        assert after.interval.start_s - 2.0 == pytest.approx(before.interval.start_s, abs=0.08)
    assert alignment.fillers == ()
    (notice,) = alignment.notices
    assert notice.code == "transcript_suspect"
    assert "before word 0 (I)" in notice.message


def _telephone(samples: FloatArray) -> Audio:
    content = io.BytesIO()
    soundfile.write(content, soxr.resample(samples, SAMPLE_RATE_HZ, 8_000), 8_000, "ULAW", format="WAV")
    return decode(content.getvalue(), AudioLimits())[0]


def _room(samples: FloatArray) -> Audio:
    """0.3 s to −60 dB, and noise 20 dB below the speech."""
    chance = np.random.default_rng(0)
    times_s = np.arange(round(0.3 * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ
    tail = chance.standard_normal(len(times_s)) * 10 ** (-3 * times_s / 0.3)
    echoing = samples + 0.5 * np.convolve(samples, tail / np.sqrt(np.sum(tail**2)))[: len(samples)]
    return Audio(echoing + chance.standard_normal(len(samples)) * 0.1 * np.std(samples))


def _antiphase(samples: FloatArray) -> Audio:
    content = io.BytesIO()
    soundfile.write(content, np.column_stack([samples, -samples]), SAMPLE_RATE_HZ, format="WAV")
    return decode(content.getvalue(), AudioLimits())[0]


@pytest.mark.parametrize("degraded", [_telephone, _room, _antiphase])
def test_words_of_a_poor_recording_lie_where_they_were_spoken(
    aligner: Aligner, degraded: Callable[[FloatArray], Audio]
) -> None:
    audio, transcript = _line("figure8")
    words = aligner.align(degraded(audio.samples), transcript)[0]
    for clean, poor in zip(aligner.align(audio, transcript)[0], words, strict=True):
        assert clean.interval is not None
        assert poor.interval is not None
        assert poor.interval.start_s == pytest.approx(clean.interval.start_s, abs=0.08)


def test_another_text_is_refused(aligner: Aligner) -> None:
    audio, _ = _line("figure8")
    with pytest.raises(InputError) as caught:
        aligner.align(audio, _words("Bring me two cups of green tea before the Thursday meeting, please."))
    assert caught.value.code == "transcript_mismatch"
    assert caught.value.field == "text"


def test_a_text_with_half_the_words_is_suspect(aligner: Aligner) -> None:
    audio, transcript = _line("example")
    _, notices = aligner.align(audio, transcript[:11])
    assert [notice.code for notice in notices] == ["transcript_suspect"]


def test_more_words_than_could_be_said_are_refused(aligner: Aligner) -> None:
    audio, transcript = _line("example")
    with pytest.raises(InputError) as caught:
        aligner.align(Audio(audio.samples[:SAMPLE_RATE_HZ]), transcript)
    assert caught.value.code == "transcript_mismatch"


def test_a_text_in_which_nothing_is_spoken_is_refused(aligner: Aligner) -> None:
    audio, _ = _line("figure8")
    with pytest.raises(InputError) as caught:
        aligner.align(audio, _words("— ... !"))
    assert caught.value.code == "transcript_unspoken"


@pytest.mark.parametrize(
    "samples", [np.zeros(0), np.zeros(10), np.zeros(SAMPLE_RATE_HZ), np.ones(SAMPLE_RATE_HZ)], ids=len
)
def test_audio_without_speech_is_refused_or_suspect(aligner: Aligner, samples: FloatArray) -> None:
    try:
        codes = {notice.code for notice in aligner.align(Audio(samples), _words("hello there"))[1]}
    except InputError as error:
        codes = {error.code}
    assert codes & {"transcript_mismatch", "transcript_suspect", "alignment_low_confidence"}


def test_the_decoder_gets_every_signal_equally_loud_and_always_the_same() -> None:
    samples = np.sin(np.arange(1600) / 10)
    assert pcm(samples) == pcm(samples)
    peaks = [np.abs(np.frombuffer(pcm(samples * gain), "<i2")).max() for gain in (1.0, 0.001)]
    assert peaks[0] == pytest.approx(peaks[1], abs=1)


def test_a_crash_fails_one_request_and_the_next_one_works(tmp_path: Path) -> None:
    worker = tmp_path / "worker.py"
    worker.write_text(DIES_ONCE)
    process = DecoderProcess(worker)
    try:
        with pytest.raises(ServiceError) as caught:
            process.align(b"\0" * 100_000, [["HH AH"]])
        assert caught.value.code == "aligner_crashed"
        assert process.align(b"\0" * 100_000, [["HH AH"]]) is None
    finally:
        process.close()


def test_a_worker_that_hangs_is_given_up(tmp_path: Path) -> None:
    worker = tmp_path / "worker.py"
    worker.write_text("import sys, time; sys.stdin.buffer.readline(); time.sleep(60)")
    with pytest.raises(ServiceError) as caught:
        DecoderProcess(worker, time_limit_s=0.3).align(b"", [["HH AH"]])
    assert caught.value.code == "aligner_crashed"


def test_after_close_another_worker_starts(aligner: Aligner) -> None:
    audio, transcript = _line("figure8")
    before = aligner.align(audio, transcript)
    aligner.close()
    assert aligner.align(audio, transcript) == before


def test_the_worker_ends_when_its_parent_is_killed(tmp_path: Path) -> None:
    marker, worker = tmp_path / "ended", tmp_path / "worker.py"
    worker.write_text(f"import sys; sys.stdin.buffer.read(); open({str(marker)!r}, 'w').close()")
    code = (
        "import sys; from pathlib import Path;"
        "from understudy.acoustic.alignment.decoder_process import DecoderProcess;"
        f"process = DecoderProcess(Path({str(worker)!r})); process.start(); print('started', flush=True);"
        "sys.stdin.read()"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=ROOT
    ) as parent:
        assert parent.stdout is not None
        assert parent.stdout.readline() == b"started\n"
        parent.kill()
    deadline = time.monotonic() + 60
    while not marker.exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    assert marker.exists()


NOWHERE = Interval(0.0, 0.0)


def _word(index: int, *labels: str) -> Word:
    return Word(index, "x", phones=tuple(Phone(label, NOWHERE) for label in labels))


def _audio(*loud: bool) -> Audio:
    """A second of noise for each True, of silence for each False."""
    noise = np.random.default_rng(0).uniform(-0.1, 0.1, (len(loud), SAMPLE_RATE_HZ))
    return Audio((noise * np.array(loud)[:, None]).ravel())


def test_words_get_time_by_their_phones_where_it_is_loud() -> None:
    (one, two), notices = spread(_audio(False, True, False, True), (_word(0, "W", "AH", "N"), _word(1, "T")))
    assert one.interval == Interval(1.0, 3.5)
    assert two.interval == Interval(3.5, 4.0)
    assert [phone.interval.start_s for phone in one.phones] == [1.0, 1.5, 3.0]
    assert [notice.code for notice in notices] == ["alignment_low_confidence"]
    assert "word 0 (x), 1 (x)" in notices[0].message
    assert one.spread
    assert two.spread


def test_more_than_anybody_can_say_is_refused() -> None:
    with pytest.raises(InputError) as caught:
        spread(_audio(True), (_word(0, *["AH"] * 26),))
    assert caught.value.code == "transcript_mismatch"

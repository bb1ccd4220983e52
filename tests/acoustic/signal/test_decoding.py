"""Decoding preserves the sound, and every unusable file is refused with its own reason."""

import io
import struct
import tracemalloc

import numpy as np
import pytest
import soundfile
from hypothesis import given
from hypothesis import strategies as st

from tests.support.examples import examples
from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.errors import InputError, TooLargeError, UndecodableError, UnderstudyError, UnsupportedFormatError
from understudy.model import SAMPLE_RATE_HZ, FloatArray

LIMITS = AudioLimits()


def tone(
    rate_hz: int = 16_000, duration_s: float = 1.0, frequency_hz: float = 440.0, amplitude: float = 0.3
) -> FloatArray:
    return amplitude * np.sin(2 * np.pi * frequency_hz * np.arange(round(rate_hz * duration_s)) / rate_hz)


def encoded(samples: FloatArray, rate_hz: int = 16_000, container: str = "WAV", codec: str | None = None) -> bytes:
    file = io.BytesIO()
    soundfile.write(file, samples, rate_hz, format=container, subtype=codec)
    return file.getvalue()


def codes(content: bytes) -> list[str]:
    return [notice.code for notice in decode(content, LIMITS)[1]]


def refusal(content: bytes, limits: AudioLimits = LIMITS) -> InputError:
    with pytest.raises(InputError) as caught:
        decode(content, limits)
    assert "\n" not in caught.value.message
    assert caught.value.field == "audio"
    return caught.value


def with_flac_length(content: bytes, frames: int) -> bytes:
    """The FLAC file with another number of frames in its header (the low 36 of the 64 bits at byte 18)."""
    fields = int.from_bytes(content[18:26], "big") >> 36 << 36 | frames
    return content[:18] + fields.to_bytes(8, "big") + content[26:]


@pytest.mark.parametrize(
    ("container", "codec", "tolerance"),
    [
        ("WAV", "PCM_U8", 0.01),
        ("WAV", "PCM_16", 1e-4),
        ("WAV", "PCM_24", 1e-6),
        ("WAV", "FLOAT", 1e-6),
        ("WAV", "ULAW", 0.02),
        ("WAV", "MS_ADPCM", 0.05),
        ("WAVEX", "PCM_16", 1e-4),
        ("FLAC", "PCM_16", 1e-4),
        ("FLAC", "PCM_24", 1e-6),
        ("OGG", "VORBIS", 0.05),
        ("OGG", "OPUS", 0.05),
    ],
)
def test_every_codec_gives_back_the_tone(container: str, codec: str, tolerance: float) -> None:
    audio, notices = decode(encoded(tone(duration_s=2.5), container=container, codec=codec), LIMITS)
    assert notices == ()
    steady = slice(1600, 38_000)
    np.testing.assert_allclose(audio.samples[steady], tone(duration_s=2.5)[steady], atol=tolerance)


@pytest.mark.parametrize("rate_hz", [8_000, 11_025, 22_050, 44_100, 48_000, 192_000])
def test_other_rates_keep_time_and_amplitude(rate_hz: int) -> None:
    audio, _ = decode(encoded(tone(rate_hz, 2.0), rate_hz), LIMITS)
    assert len(audio.samples) == pytest.approx(2 * SAMPLE_RATE_HZ, abs=1)
    steady = slice(800, 31_000)
    np.testing.assert_allclose(audio.samples[steady], tone(duration_s=2.0)[steady], atol=1e-3)


def test_channels_are_averaged() -> None:
    two = np.stack([tone(), tone(frequency_hz=100)], axis=1)
    audio, notices = decode(encoded(two), LIMITS)
    np.testing.assert_allclose(audio.samples, two.mean(axis=1), atol=1e-4)
    assert notices == ()


def test_one_voice_among_eight_channels_is_no_cancellation() -> None:
    eight = np.zeros((16_000, 8))
    eight[:, 3] = tone()
    audio, notices = decode(encoded(eight), LIMITS)
    np.testing.assert_allclose(audio.samples, tone() / 8, atol=1e-4)
    assert notices == ()


def test_inverted_stereo_takes_the_louder_channel() -> None:
    audio, notices = decode(encoded(np.stack([0.9 * tone(), -tone()], axis=1)), LIMITS)
    np.testing.assert_allclose(audio.samples, -tone(), atol=1e-4)
    assert [notice.code for notice in notices] == ["audio_antiphase"]
    assert "channel 2 of 2" in notices[0].message


def test_a_constant_offset_is_taken_off() -> None:
    audio, _ = decode(encoded(tone(amplitude=0.2) + 0.5, codec="FLOAT"), LIMITS)
    np.testing.assert_allclose(audio.samples, tone(amplitude=0.2), atol=1e-6)


def test_a_clipped_recording_is_remarked_on_and_a_loud_one_is_not() -> None:
    assert codes(encoded(np.clip(tone(amplitude=2.0), -1, 1))) == ["audio_clipped"]
    assert codes(encoded(tone(amplitude=0.9999))) == []


def test_a_very_quiet_recording_is_remarked_on() -> None:
    assert codes(encoded(tone(amplitude=0.009))) == ["audio_quiet"]
    assert codes(encoded(tone(amplitude=0.011))) == []


def test_floats_that_hold_integers_are_brought_to_full_scale() -> None:
    audio, notices = decode(encoded(tone(amplitude=20_000), codec="DOUBLE"), LIMITS)
    assert np.max(np.abs(audio.samples)) == pytest.approx(1.0)
    assert [notice.code for notice in notices] == ["audio_rescaled"]


def silence_with_dither() -> FloatArray:
    return np.random.default_rng(0).integers(-2, 3, 16_000) / 32_768


@pytest.mark.parametrize("samples", [np.zeros(16_000), silence_with_dither(), np.full(16_000, 0.4)])
def test_silence_is_refused(samples: FloatArray) -> None:
    assert refusal(encoded(samples)).code == "audio_silent"


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e30])
def test_a_sample_that_is_no_usable_number_is_refused_and_placed(bad: float) -> None:
    samples = tone(duration_s=3.0)
    samples[40_000] = bad
    error = refusal(encoded(samples, codec="DOUBLE"))
    assert error.code == "audio_bad_sample"
    assert "2.500 s" in error.message


@pytest.mark.parametrize(
    ("content", "kind", "code"),
    [
        (b"", InputError, "audio_empty"),
        (encoded(np.zeros(0)), InputError, "audio_empty"),
        (encoded(tone(duration_s=0.049)), InputError, "audio_too_short"),
        (b"A line of text is no audio.", UnsupportedFormatError, "audio_format_unsupported"),
        (b"ID3\x04\x00 an mp3", UnsupportedFormatError, "audio_format_unsupported"),
        (encoded(tone(), container="AIFF"), UnsupportedFormatError, "audio_format_unsupported"),
        (encoded(tone(), container="AU"), UnsupportedFormatError, "audio_format_unsupported"),
        (encoded(tone(), container="RF64"), UnsupportedFormatError, "audio_format_unsupported"),
        (encoded(tone(8000), 8000, codec="GSM610"), UnsupportedFormatError, "audio_codec_unsupported"),
        (b"fLaC" + b"x" * 1000, UndecodableError, "audio_undecodable"),
        (encoded(tone(7_999), 7_999), InputError, "audio_sample_rate"),
        (encoded(tone(192_001), 192_001), InputError, "audio_sample_rate"),
        (encoded(np.stack([tone()] * 9, axis=1)), InputError, "audio_channels"),
        (encoded(tone())[:22] + b"\0\0" + encoded(tone())[24:], InputError, "audio_channels"),
        (with_flac_length(encoded(tone(), container="FLAC"), 0), UndecodableError, "audio_length_unstated"),
    ],
)
def test_each_kind_of_unusable_file_has_its_own_error(content: bytes, kind: type[InputError], code: str) -> None:
    error = refusal(content)
    assert type(error) is kind
    assert error.code == code


@pytest.mark.parametrize("container", ["WAV", "FLAC", "OGG"])
@pytest.mark.parametrize("share", [0.3, 0.6, 0.9, 0.999])
def test_a_file_that_breaks_off_is_refused(container: str, share: float) -> None:
    noise = np.random.default_rng(0).normal(0, 0.1, 48_000)
    whole = encoded(noise, container=container)
    decode(whole, LIMITS)
    error = refusal(whole[: int(len(whole) * share)])
    assert isinstance(error, UndecodableError)
    assert error.code == "audio_truncated"


def test_limits_hold_just_under_and_just_over() -> None:
    content = encoded(tone(duration_s=2.0))
    for limits in (AudioLimits(max_bytes=len(content)), AudioLimits(max_duration_s=2.0)):
        decode(content, limits)
    for limits, code in (
        (AudioLimits(max_bytes=len(content) - 1), "audio_too_large"),
        (AudioLimits(max_duration_s=1.999), "audio_too_long"),
    ):
        error = refusal(content, limits)
        assert isinstance(error, TooLargeError)
        assert error.code == code


@pytest.mark.parametrize(("container", "minutes"), [("FLAC", 60), ("OGG", 3)])
def test_a_small_file_that_expands_beyond_the_limit_is_refused_by_its_header(container: str, minutes: int) -> None:
    file = io.BytesIO()
    with soundfile.SoundFile(file, "w", 16_000, 1, format=container) as sound:
        for _ in range(minutes):
            sound.write(np.zeros(60 * 16_000, dtype=np.int16))
    assert len(file.getvalue()) < 250_000
    assert refusal(file.getvalue()).code == "audio_too_long"


@pytest.mark.parametrize("channels", [1, 2])
def test_the_sound_is_held_once(channels: int) -> None:
    content = encoded(np.tile(tone()[:, None], (60, channels)))
    tracemalloc.start()
    audio, _ = decode(content, LIMITS)
    peak_bytes = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak_bytes < (channels + (channels > 1)) * audio.samples.nbytes + 4e6  # and blocks


def test_no_more_is_decoded_than_the_header_says() -> None:
    long = encoded(np.tile(tone(), 300), container="FLAC")
    assert refusal(long).code == "audio_too_long"
    assert decode(with_flac_length(long, 32_000), LIMITS)[0].duration_s == 2.0


@pytest.mark.parametrize(
    ("promised", "outcome"), [(0x7FFFFFFF, "audio_truncated"), (32_002, "audio_truncated"), (0, "audio_empty")]
)
def test_a_wav_header_that_lies_is_found_out(promised: int, outcome: str) -> None:
    content = encoded(tone())
    assert refusal(content[:40] + struct.pack("<I", promised) + content[44:]).code == outcome


def test_a_wav_written_to_a_pipe_is_read_to_its_end_with_a_notice() -> None:
    content = encoded(tone())
    audio, notices = decode(content[:40] + b"\xff" * 4 + content[44:], LIMITS)
    assert audio.duration_s == 1.0
    assert [notice.code for notice in notices] == ["audio_length_unstated"]


def test_chunks_before_the_sound_are_stepped_over() -> None:
    content = encoded(tone())
    padded = content[:36] + b"LIST" + struct.pack("<I", 3) + b"abc\0" + content[36:]
    assert decode(padded, LIMITS)[0].duration_s == 1.0


@pytest.mark.parametrize("container", ["WAV", "FLAC", "OGG"])
@examples(60)
@given(draw=st.data())
def test_damaged_bytes_give_a_sound_or_an_error_of_ours(container: str, draw: st.DataObject) -> None:
    content = bytearray(encoded(tone(duration_s=0.2), container=container))
    for _ in range(draw.draw(st.integers(1, 6))):
        content[draw.draw(st.integers(0, len(content) - 1))] = draw.draw(st.integers(0, 255))
    try:
        audio, _ = decode(bytes(content), LIMITS)
    except UnderstudyError:
        return
    assert np.isfinite(audio.samples).all()

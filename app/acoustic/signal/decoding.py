"""Decodes audio files to a mono signal at `SAMPLE_RATE_HZ`, or says clearly why this is not possible.

WAV, FLAC and OGG are read by libsndfile and resampled by soxr, both block by block, so that memory is bounded by the
limits and not by what a file expands to. Amplitudes are relative to full scale (±1). The limits are checked against the
header, and no more is ever decoded than it states, so small files that would expand to hours cost nothing, whether
their headers are correct or not. The mean is removed. Samples are in single precision.

Audio files are identified by their first bytes, and it is checked that they are complete, before they are decoded:
libsndfile reads some thirty formats, accepts a truncated WAV as a shorter one, and fails obscurely on a truncated Ogg.
"""

import io
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
import soundfile
import soxr

from ...errors import InputError, TooLargeError, UndecodableError, UnsupportedFormatError
from ...model import SAMPLE_RATE_HZ, Audio, FloatArray, Notice, SingleArray

_UNSTATED_WAV_BYTES = 0xFFFFFFFF
_WAV_HEADER_BYTES = 12
_CHUNK_HEADER_BYTES = 8
_FLAC_TOTAL = slice(21, 26)
_FLAC_TOTAL_BITS = 36
_OGG_PAGE_HEADER_BYTES = 27
_OGG_LAST_PAGE = 0x04


class Container(StrEnum):
    """The supported file formats."""

    WAV = "WAV"
    FLAC = "FLAC"
    OGG = "OGG"


def container_of(content: bytes) -> Container:
    """The container according to the first bytes. Raises UnsupportedFormatError for any other."""
    if content.startswith(b"RIFF") and content[8:12] == b"WAVE":
        return Container.WAV
    if content.startswith(b"fLaC"):
        return Container.FLAC
    if content.startswith(b"OggS"):
        return Container.OGG
    raise UnsupportedFormatError(
        "audio_format_unsupported",
        f"the audio is not WAV, FLAC or OGG (its first bytes are {content[:8]!r}); send one of these",
        field="audio",
    )


def check_complete(content: bytes, container: Container) -> tuple[Notice, ...]:
    """Raises UndecodableError if the file ends before the end that it states, as far as its bytes show.

    Truncated FLAC is detected only on decoding. The notice says that a file states no length.
    """
    if container is Container.WAV:
        return _check_wav(content)
    if container is Container.FLAC:
        _check_flac(content)
    else:
        _check_ogg(content)
    return ()


def truncated(what: str) -> UndecodableError:
    """The error for an incomplete file; `what` says which part is missing."""
    return UndecodableError(
        "audio_truncated", f"the audio is incomplete: {what}; send the complete file", field="audio"
    )


def _check_wav(content: bytes) -> tuple[Notice, ...]:
    """The data chunk must lie within the file, unless its size is all ones, as written to pipes."""
    position = _WAV_HEADER_BYTES
    while position + _CHUNK_HEADER_BYTES <= len(content):
        name, size = struct.unpack_from("<4sI", content, position)
        position += _CHUNK_HEADER_BYTES
        if name == b"data":
            return _check_wav_data(size, len(content) - position)
        position += size + size % 2
    raise truncated("the WAV file ends before its data chunk")


def _check_wav_data(promised_bytes: int, present_bytes: int) -> tuple[Notice, ...]:
    if promised_bytes == _UNSTATED_WAV_BYTES:
        return (Notice("audio_length_unstated", "the WAV header gives no length; the file is assumed to be complete"),)
    if promised_bytes > present_bytes:
        raise truncated(f"the WAV header promises {promised_bytes} bytes of sound and {present_bytes} are there")
    return ()


def _check_flac(content: bytes) -> None:
    """The number of samples must be stated: libsndfile cannot find the end without it."""
    total = int.from_bytes(content[_FLAC_TOTAL], "big") & ((1 << _FLAC_TOTAL_BITS) - 1)
    if total == 0:
        raise UndecodableError(
            "audio_length_unstated",
            "the FLAC header gives no length, as when it is written to a pipe; write it to a file instead",
            field="audio",
        )


def _check_ogg(content: bytes) -> None:
    """The last page must be complete and marked as the last of the stream."""
    start = content.rfind(b"OggS")
    header = content[start : start + _OGG_PAGE_HEADER_BYTES]
    if len(header) < _OGG_PAGE_HEADER_BYTES:
        raise truncated("the OGG file ends within a page")
    body = start + _OGG_PAGE_HEADER_BYTES
    segments = content[body : body + header[-1]]
    if len(segments) < header[-1] or body + len(segments) + sum(segments) > len(content):
        raise truncated("the OGG file ends within a page")
    if not header[5] & _OGG_LAST_PAGE:
        raise truncated("the OGG file has no last page")


MIN_DURATION_S = 0.050
"""Shorter audio cannot contain a word."""

SILENT_PEAK = 1e-4
"""A signal with a peak below −80 dB of full scale (about three steps of 16 bits) counts as silent."""

QUIET_PEAK = 1e-2
"""Below −40 dB of full scale the quantization noise of 16 bits is within 50 dB of the voice."""

CLIPPED_SHARE = 1e-3
"""The share of samples that stay at full scale above which a recording counts as clipped."""

CANCELLING_COHERENCE = 0.1
"""The power of the channels' sum over the sum of their powers: 1 if uncorrelated, 0 if they cancel."""

_READ_FRAMES = 16_384
_FULL_SCALE = 0.999
_LOUDEST_USABLE = 1e6
_CODECS = frozenset(
    {"PCM_S8", "PCM_U8", "PCM_16", "PCM_24", "PCM_32", "FLOAT", "DOUBLE", "ULAW", "ALAW"}
    | {"IMA_ADPCM", "MS_ADPCM", "VORBIS", "OPUS"}
)
_UNIMPLEMENTED_CODEC = 18
_IMPOSSIBLE_CHANNELS = (32, 33)


@dataclass(frozen=True, slots=True)
class AudioLimits:
    """Upper limits (for the rate, also a lower one) of accepted audio."""

    max_duration_s: float = 120.0
    max_bytes: int = 32 * 1024 * 1024
    min_sample_rate_hz: int = 8_000
    max_sample_rate_hz: int = 192_000
    max_channels: int = 8


def decode(content: bytes, limits: AudioLimits) -> tuple[Audio, tuple[Notice, ...]]:
    """The mono signal of a WAV, FLAC or OGG file at `SAMPLE_RATE_HZ`, and notices about its quality.

    Raises TooLargeError (too many bytes, too long), UnsupportedFormatError (another container or codec),
    UndecodableError (broken or truncated) and InputError (empty, too short, silent, not finite, a rate or number of
    channels outside the limits). Notices: `audio_clipped`, `audio_quiet`, `audio_rescaled`, `audio_antiphase`,
    `audio_length_unstated`.
    """
    if not content:
        raise InputError("audio_empty", "the audio is empty: 0 bytes; send a WAV, FLAC or OGG file", field="audio")
    if len(content) > limits.max_bytes:
        message = f"the audio has {len(content)} bytes; at most {limits.max_bytes} are accepted"
        raise TooLargeError("audio_too_large", message, field="audio")
    notices = check_complete(content, container_of(content))
    with _opened(content) as file:
        _check_header(file, limits)
        channels, clipped = _resampled(file)
    mono, mono_notices = _mixed(channels)
    level_notices = _judged(mono)
    audio, scale_notices = _scaled(mono)
    return audio, notices + clipped + mono_notices + level_notices + scale_notices


def _opened(content: bytes) -> soundfile.SoundFile:
    try:
        return soundfile.SoundFile(io.BytesIO(content))
    except soundfile.LibsndfileError as error:
        if error.code in _IMPOSSIBLE_CHANNELS:
            raise InputError(
                "audio_channels", f"the audio's header is invalid: {error.error_string}", field="audio"
            ) from error
        if error.code == _UNIMPLEMENTED_CODEC:
            raise _codec_error("unknown, or its header is damaged") from error
        message = f"the audio cannot be read: {error.error_string}"
        raise UndecodableError("audio_undecodable", message, field="audio") from error


def _codec_error(codec: str) -> UnsupportedFormatError:
    message = f"the audio's coding ({codec}) is not supported; use PCM, float, FLAC, Vorbis or Opus"
    return UnsupportedFormatError("audio_codec_unsupported", message, field="audio")


def _check_header(file: soundfile.SoundFile, limits: AudioLimits) -> None:
    """Reject what the header alone shows to be unusable."""
    if file.subtype not in _CODECS:
        raise _codec_error(file.subtype)
    if not limits.min_sample_rate_hz <= file.samplerate <= limits.max_sample_rate_hz:
        message = (
            f"the audio has a sample rate of {file.samplerate} Hz; "
            f"{limits.min_sample_rate_hz} to {limits.max_sample_rate_hz} Hz are accepted"
        )
        raise InputError("audio_sample_rate", message, field="audio")
    if file.channels > limits.max_channels:
        message = f"the audio has {file.channels} channels; at most {limits.max_channels} are accepted"
        raise InputError("audio_channels", message, field="audio")
    duration_s = file.frames / file.samplerate
    if duration_s > limits.max_duration_s:
        message = f"the audio lasts {duration_s:.1f} s; at most {limits.max_duration_s:g} s are accepted"
        raise TooLargeError("audio_too_long", message, field="audio")
    if file.frames == 0:
        raise InputError("audio_empty", "the audio holds no samples; send a recording", field="audio")
    if duration_s < MIN_DURATION_S:
        message = f"the audio lasts {duration_s * 1000:.1f} ms; at least {MIN_DURATION_S * 1000:g} ms are needed"
        raise InputError("audio_too_short", message, field="audio")


def _resampled(file: soundfile.SoundFile) -> tuple[SingleArray, tuple[Notice, ...]]:
    """All channels at `SAMPLE_RATE_HZ` (samples × channels); the notice says that the file is clipped."""
    resampler = soxr.ResampleStream(file.samplerate, SAMPLE_RATE_HZ, file.channels, dtype="float64")
    channels = np.empty((_resampled_frames(file), file.channels), dtype=np.float32)
    done = clipped = 0
    for block in _blocks(file):
        clipped += _count_clipped(block)
        done += _append(resampler.resample_chunk(block), channels[done:])
    done += _append(resampler.resample_chunk(np.empty((0, file.channels)), last=True), channels[done:])
    share = clipped / (file.frames * file.channels)
    if share <= CLIPPED_SHARE:
        return channels[:done], ()
    message = f"the recording is clipped: {share:.1%} of its samples stay at full scale; record it at a lower level"
    return channels[:done], (Notice("audio_clipped", message),)


def _resampled_frames(file: soundfile.SoundFile) -> int:
    """An upper bound of the length at `SAMPLE_RATE_HZ`, to allocate the array once."""
    return int(file.frames * SAMPLE_RATE_HZ / file.samplerate) + 2


def _append(block: FloatArray, room: SingleArray) -> int:
    """Copy the block into the free space; returns its length."""
    room[: len(block)] = block
    return len(block)


def _blocks(file: soundfile.SoundFile) -> Iterator[FloatArray]:
    """The samples (frames × channels), block by block; never more than the header states.

    Raises UndecodableError if fewer can be decoded, InputError at a sample that is not a usable number.
    """
    done = 0
    while done < file.frames:
        try:
            block: FloatArray = file.read(_READ_FRAMES, dtype="float64", always_2d=True)
        except soundfile.LibsndfileError as error:
            raise _broken_off(done, file) from error
        if not len(block):
            raise _broken_off(done, file)
        usable = np.abs(block) < _LOUDEST_USABLE
        if not usable.all():
            frame, channel = np.argwhere(~usable)[0]
            raise _unusable_sample(block[frame, channel], (done + frame) / file.samplerate)
        yield block
        done += len(block)


def _broken_off(done: int, file: soundfile.SoundFile) -> UndecodableError:
    rate_hz = file.samplerate
    return truncated(f"it breaks off or is damaged after {done / rate_hz:.2f} s of {file.frames / rate_hz:.2f} s")


def _unusable_sample(value: float, time_s: float) -> InputError:
    message = f"the audio has a sample of {value:g} at {time_s:.3f} s; samples must be finite and full scale is ±1"
    return InputError("audio_bad_sample", message, field="audio")


def _count_clipped(block: FloatArray) -> int:
    """The number of samples that repeat the previous one at full scale; an unclipped wave only touches it."""
    loud = np.abs(block[1:]) >= _FULL_SCALE
    return int(np.count_nonzero(loud & (block[1:] == block[:-1])))


def _mixed(channels: SingleArray) -> tuple[SingleArray, tuple[Notice, ...]]:
    """The mean of the channels without its offset; if they cancel, the loudest channel.

    Works in place, to avoid a second copy of half an hour of audio.
    """
    channels -= channels.mean(axis=0, dtype=np.float64).astype(np.float32)
    if channels.shape[1] == 1:
        return channels[:, 0], ()
    powers = np.einsum("ij,ij->j", channels, channels, dtype=np.float64)
    mono: SingleArray = channels.mean(axis=1)
    summed_power = np.einsum("i,i->", mono, mono, dtype=np.float64) * len(powers) ** 2
    if summed_power >= CANCELLING_COHERENCE * powers.sum():
        return mono, ()
    loudest = int(np.argmax(powers))
    message = f"the channels cancel each other (one is inverted); channel {loudest + 1} of {len(powers)} is used alone"
    return channels[:, loudest].copy(), (Notice("audio_antiphase", message),)


def _judged(mono: SingleArray) -> tuple[Notice, ...]:
    """Reject a silent signal; add a notice for a quiet one."""
    peak = _peak(mono)
    if peak < SILENT_PEAK:
        message = (
            f"the audio is silent: it never passes {20 * np.log10(SILENT_PEAK):.0f} dB of full scale; send a voice"
        )
        raise InputError("audio_silent", message, field="audio")
    if peak >= QUIET_PEAK:
        return ()
    message = f"the recording is very quiet: its peak is at {20 * np.log10(peak):.0f} dB of full scale"
    return (Notice("audio_quiet", message),)


def _scaled(mono: SingleArray) -> tuple[Audio, tuple[Notice, ...]]:
    """The signal unchanged, or rescaled if it exceeds twice full scale, as when floats hold 16-bit integers."""
    peak = _peak(mono)
    if peak <= 2.0:
        return Audio(mono), ()
    message = f"the samples reach {peak:g} times full scale; they are divided by that"
    return Audio(mono / peak), (Notice("audio_rescaled", message),)


def _peak(mono: SingleArray) -> float:
    return float(max(mono.max(), -mono.min()))

"""Reads the microphone (needs the extra `microphone`, which includes PortAudio on Windows and macOS)."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ...errors import InputError
from ...model import FloatArray

FULL_SCALE = 32768
_INSTEAD = "or send the sound to standard input: arecord -t raw -f S16_LE -r 16000 | understudy live - --rate 16000"


def microphone_chunks(rate_hz: int, chunk_s: float) -> Iterator[FloatArray]:
    """Mono samples in [-1, 1], `chunk_s` at a time, without end. Raises InputError `microphone_missing` at once."""
    try:
        import sounddevice  # an extra, which most do without
    except (ImportError, OSError) as error:
        told = f"no microphone can be heard: {error}; pip install '.[microphone]' with PortAudio, {_INSTEAD}"
        raise InputError("microphone_missing", told, field="microphone") from None
    try:
        stream = sounddevice.RawInputStream(rate_hz, round(chunk_s * rate_hz), channels=1, dtype="int16")
    except sounddevice.PortAudioError as error:
        message = f"no microphone can be heard: {error}; {_INSTEAD}"
        raise InputError("microphone_missing", message, field="microphone") from None
    return _chunks(stream)


def _chunks(stream: Any) -> Iterator[FloatArray]:  # noqa: ANN401 - sounddevice has no types
    with stream:
        while True:
            content, _overflowed = stream.read(stream.blocksize)
            yield np.frombuffer(content, dtype="<i2") / FULL_SCALE

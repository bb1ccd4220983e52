"""Short valid recordings, and ones with wrong headers or samples."""

import io
import struct
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

import numpy as np
import soundfile

from ..attacks import AUDIO
from .breaking import Rng

RATE_HZ = 16_000
SECONDS = 0.8


@cache
def recordings() -> Mapping[str, bytes]:
    """A short recording in every format that is read."""
    samples, _rate = soundfile.read(AUDIO, frames=int(RATE_HZ * SECONDS), start=RATE_HZ // 2, dtype="float32")
    made = {}
    kinds = (("WAV", "PCM_16"), ("WAV", "FLOAT"), ("WAV", "ULAW"), ("FLAC", "PCM_16"), ("OGG", "VORBIS"))
    for container, coding in kinds:
        file = io.BytesIO()
        soundfile.write(file, samples, RATE_HZ, coding, format=container)
        made[f"{container} {coding}"] = file.getvalue()
    return MappingProxyType(made)


def wav(rng: Rng) -> bytes:
    """A WAV file whose header has a wrong number in it, or odd samples."""
    samples = np.frombuffer(rng.randbytes(2 * 14_400), np.int16).astype(np.float32) / 32768
    if rng.random() < 0.3:
        samples[rng.randrange(len(samples))] = rng.choice((float("nan"), float("inf"), 1e30, -1e30, 1e-40))
    content = samples.astype("<f4").tobytes()
    fields = [3, 1, RATE_HZ, RATE_HZ * 4, 4, 32]
    for _ in range(rng.randint(0, 2)):
        fields[rng.randrange(6)] = rng.choice((0, 1, 2, 7, 8, 24, 64, 65_534, 65_535, 8_000, 192_000))
    odd = (0, 1, 7, len(content) - 1, len(content) + 1, 2**31, 2**32 - 1)
    size, chunk = (rng.choice(odd) if rng.random() < 0.2 else right for right in (len(content), 16))
    fields = [
        min(field, limit)
        for field, limit in zip(fields, (65_535, 65_535, 2**32 - 1, 2**32 - 1, 65_535, 65_535), strict=True)
    ]
    header = struct.pack("<4sI4s4sIHHIIHH", b"RIFF", 36 + len(content), b"WAVE", b"fmt ", chunk, *fields)
    return header + struct.pack("<4sI", b"data", size) + content

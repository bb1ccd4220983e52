"""`understudy live`: speech as it comes, what the body does as it is decided, one JSON object a line.

`{"type":"ready"}`; then `{"type":"gesture","part","state","start_s","heard_s"}` where a phase of hands, head or brows
begins; at last `{"type":"done","duration_s"}`.
"""

import argparse
import json
import sys
from collections.abc import Iterator
from typing import BinaryIO, TextIO

import numpy as np

from ...acoustic.signal.decoding import decode
from ...errors import InputError
from ...hearing import audio_limits
from ...live.events import LiveEvent, LiveEvents
from ...model import SAMPLE_RATE_HZ, FloatArray
from ...prosody_gestures.voice_model import VoiceModel
from ...resources import resource_folder
from ...settings import Settings, read_settings
from ..files import STANDARD, read_bytes
from ..log import Log

CHUNK_S = 0.04
FULL_SCALE = 32768
DECIMALS = 3


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    raw = arguments.rate is not None
    _check_rate(arguments.rate, settings)
    model = VoiceModel.load(resource_folder("models") / "prosody_gestures" / "voice.npz")
    if raw and arguments.audio == STANDARD:
        _perform(model, arguments.rate, _chunks_of(sys.stdin.buffer, arguments.rate), sys.stdout)
        return 0
    content = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    if raw:
        samples, rate_hz = _samples(content), arguments.rate
    else:
        audio, notices = decode(content, audio_limits(settings))
        log.warnings(notices)
        samples, rate_hz = audio.samples, SAMPLE_RATE_HZ
    _perform(model, rate_hz, _cut(samples, rate_hz), sys.stdout)
    return 0


def _check_rate(rate_hz: int | None, settings: Settings) -> None:
    lowest, highest = settings.min_sample_rate_hz, settings.max_sample_rate_hz
    if rate_hz is not None and not lowest <= rate_hz <= highest:
        raise InputError("value_wrong", f"--rate {rate_hz}; give {lowest} to {highest} samples a second", field="rate")


def _perform(model: VoiceModel, rate_hz: int, chunks: Iterator[FloatArray], out: TextIO) -> None:
    """Tells each event as soon as it is decided."""
    live = LiveEvents(model, rate_hz)
    _tell(out, {"type": "ready"})
    for chunk in chunks:
        for event in live.hear(chunk):
            _tell(out, _told(event))
    for event in live.finish():
        _tell(out, _told(event))
    _tell(out, {"type": "done", "duration_s": round(live.heard_s, DECIMALS)})


def _tell(out: TextIO, message: dict[str, object]) -> None:
    out.write(json.dumps(message) + "\n")
    out.flush()


def _told(event: LiveEvent) -> dict[str, object]:
    return {
        "type": "gesture",
        "part": event.part,
        "state": event.state,
        "start_s": round(event.start_s, DECIMALS),
        "heard_s": round(event.heard_s, DECIMALS),
    }


def _chunks_of(stream: BinaryIO, rate_hz: int) -> Iterator[FloatArray]:
    """16-bit samples as they come; a byte left over at the end is dropped."""
    size = 2 * round(CHUNK_S * rate_hz)
    while len(content := stream.read(size)) > 1:
        yield _samples(content)


def _samples(content: bytes) -> FloatArray:
    """Little-endian 16-bit samples, one channel."""
    return np.frombuffer(content[: len(content) // 2 * 2], dtype="<i2") / FULL_SCALE


def _cut(samples: FloatArray, rate_hz: int) -> Iterator[FloatArray]:
    size = round(CHUNK_S * rate_hz)
    return (samples[first : first + size] for first in range(0, len(samples), size))

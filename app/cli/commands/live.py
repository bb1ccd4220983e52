"""`understudy live`: speech as it comes, what the body does as it is decided, one JSON object a line (docs/live.md).

The lines are the messages of `WS /live`: `ready`, then behaviours, shapes of the mouth and, asked for, frames; at last
`done`.
"""

import argparse
import sys
from collections.abc import Iterator
from contextlib import ExitStack
from typing import BinaryIO, TextIO

from ...acoustic.signal.decoding import decode
from ...errors import InputError
from ...hearing import audio_limits
from ...live.models import LiveModels
from ...live.session import LiveSession
from ...live.telling import LiveOptions
from ...model import SAMPLE_RATE_HZ, FloatArray
from ...performance import Understudy
from ...schemas.live import read_samples, to_done, to_json, to_ready
from ...settings import Settings, read_settings
from ..files import STANDARD, read_bytes
from ..log import Log

CHUNK_S = 0.04


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    _check_rate(arguments.rate, settings)
    rate_hz, chunks = _sound(arguments, settings, log)
    options = LiveOptions(rate_hz, arguments.character, arguments.seed, arguments.frames)
    with ExitStack() as stack:
        out = sys.stdout if arguments.output == STANDARD else stack.enter_context(_opened(arguments.output))
        understudy = stack.enter_context(Understudy.load(settings))
        _perform(LiveModels.load(understudy), options, chunks, out)
    return 0


def _opened(path: str) -> TextIO:
    """A file that is written while the stream goes on. Raises InputError `file_unwritable`."""
    try:
        return open(path, "w", encoding="utf-8")
    except OSError as error:
        raise InputError("file_unwritable", f"{path}: cannot be written: {error.strerror}") from None


def _check_rate(rate_hz: int | None, settings: Settings) -> None:
    lowest, highest = settings.min_sample_rate_hz, settings.max_sample_rate_hz
    if rate_hz is not None and not lowest <= rate_hz <= highest:
        raise InputError("value_wrong", f"--rate {rate_hz}; give {lowest} to {highest} samples a second", field="rate")


def _sound(arguments: argparse.Namespace, settings: Settings, log: Log) -> tuple[int, Iterator[FloatArray]]:
    """The rate and the chunks of what is to be heard."""
    rate_hz = arguments.rate
    if rate_hz is not None and arguments.audio == STANDARD:
        return rate_hz, _chunks_of(sys.stdin.buffer, rate_hz)
    content = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    if rate_hz is not None:
        return rate_hz, _cut(_samples(content), rate_hz)
    audio, notices = decode(content, audio_limits(settings))
    log.warnings(notices)
    return SAMPLE_RATE_HZ, _cut(audio.samples, SAMPLE_RATE_HZ)


def _perform(models: LiveModels, options: LiveOptions, chunks: Iterator[FloatArray], out: TextIO) -> None:
    """Tells everything as soon as it is known."""
    session = LiveSession(models, options)
    joints = models.understudy.realizer.skeleton.names if options.frame_rate_hz else ()
    _tell(out, to_ready(options, tuple(joints)))
    for chunk in chunks:
        for told in session.hear(chunk):
            _tell(out, to_json(told))
    _tell(out, to_done(session.heard_s))


def _tell(out: TextIO, message: str) -> None:
    out.write(message + "\n")
    out.flush()


def _chunks_of(stream: BinaryIO, rate_hz: int) -> Iterator[FloatArray]:
    """16-bit samples as they come; a byte left over at the end is dropped."""
    size = 2 * round(CHUNK_S * rate_hz)
    while len(content := stream.read(size)) > 1:
        yield _samples(content)


def _samples(content: bytes) -> FloatArray:
    return read_samples(content[: len(content) // 2 * 2], 1)[:, 0]


def _cut(samples: FloatArray, rate_hz: int) -> Iterator[FloatArray]:
    size = round(CHUNK_S * rate_hz)
    return (samples[first : first + size] for first in range(0, len(samples), size))

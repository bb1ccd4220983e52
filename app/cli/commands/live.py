"""`understudy live`: performs speech as it arrives, and writes behaviours as they are decided, one JSON object a line
(docs/live.md).

The lines are the messages of `WS /live`: `ready`, then behaviours, mouth shapes and, on request, frames; finally
`done`. With `--vmc` or `--live-link-face` the frames go to programs that show avatars; a recording is then played in
real time. The microphone needs the extra `microphone`, which includes PortAudio on Windows and macOS.
"""

import argparse
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, closing
from dataclasses import dataclass, replace
from typing import Any, BinaryIO, TextIO

import numpy as np

from ...errors import InputError
from ...library.hearing import audio_limits, read_audio
from ...library.motion_models import Search, read_motion_model
from ...live.avatars import live_link_face, vmc
from ...live.avatars.sending import FrameSender, FrameWriter
from ...live.body import BodyFrame
from ...live.messages import LiveMessage, LiveOptions
from ...live.models import LiveModels
from ...live.session import LiveSession
from ...model import SAMPLE_RATE_HZ, FloatArray
from ...models import Understudy
from ...schemas.live import read_samples, to_done, to_json, to_ready
from ...settings import Settings, read_settings
from ..files import STANDARD, read_bytes
from ..log import Log

FULL_SCALE = 32768
_INSTEAD = "or send the sound to standard input: arecord -t raw -f S16_LE -r 16000 | understudy live - --rate 16000"


def microphone_chunks(rate_hz: int, chunk_s: float) -> Iterator[FloatArray]:
    """Mono samples in [-1, 1], `chunk_s` at a time, without end. Raises InputError `microphone_missing` at once."""
    try:
        import sounddevice  # an extra, which most do without
    except (ImportError, OSError) as error:
        told = f"no microphone is available: {error}; pip install '.[microphone]' with PortAudio, {_INSTEAD}"
        raise InputError("microphone_missing", told, field="microphone") from None
    try:
        stream = sounddevice.RawInputStream(rate_hz, round(chunk_s * rate_hz), channels=1, dtype="int16")
    except sounddevice.PortAudioError as error:
        message = f"no microphone is available: {error}; {_INSTEAD}"
        raise InputError("microphone_missing", message, field="microphone") from None
    return _chunks(stream)


def _chunks(stream: Any) -> Iterator[FloatArray]:  # noqa: ANN401 - sounddevice has no types
    with stream:
        while True:
            content, _overflowed = stream.read(stream.blocksize)
            yield np.frombuffer(content, dtype="<i2") / FULL_SCALE


AVATAR_FRAME_RATE_HZ = 60
Address = tuple[str, int]


def avatar_addresses(arguments: argparse.Namespace) -> tuple[Address | None, Address | None]:
    """The addresses for VMC and for Live Link Face, if given. Raises InputError `value_wrong`."""
    asked = (("vmc", arguments.vmc, vmc.PORT), ("live-link-face", arguments.live_link_face, live_link_face.PORT))
    body, face = (_address(text, port, f"--{name}") if text else None for name, text, port in asked)
    return body, face


def avatar_senders(
    arguments: argparse.Namespace, understudy: Understudy, frame_rate_hz: int, stack: ExitStack
) -> tuple[FrameSender, ...]:
    """The senders of frames, closed with the stack. Raises InputError `value_wrong`, `address_unusable`."""
    body, face = avatar_addresses(arguments)
    parts = vmc.VmcParts(head=not arguments.vmc_without_head, face=vmc.VmcFace(arguments.vmc_face))
    skeleton = understudy.realizer.performer(arguments.character).skeleton
    writers: list[tuple[Address | None, FrameWriter]] = [
        (body, vmc.VmcWriter(skeleton, parts)),
        (face, live_link_face.LiveLinkFaceWriter(frame_rate_hz)),
    ]
    return tuple(stack.enter_context(closing(FrameSender(to, writer))) for to, writer in writers if to)


def _address(text: str, port: int, option: str) -> Address:
    host, _, given = text.rpartition(":") if ":" in text else (text, "", str(port))
    if not host or not given.isdecimal() or not 0 < int(given) < 65536:
        message = f"{option} {text}; give HOST:PORT, as 127.0.0.1:{port}"
        raise InputError("value_wrong", message, field=option.removeprefix("--"))
    return host.strip("[]"), int(given)


CHUNK_S = 0.04


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    _check_rate(arguments.rate, settings)
    moves_avatars = any(avatar_addresses(arguments))
    rate_hz, chunks = _sound(arguments, settings, log)
    model = read_motion_model(arguments.model) if arguments.model else None
    options = replace(
        LiveOptions(rate_hz, arguments.character, arguments.seed, arguments.frames), search=_search(arguments)
    )
    if moves_avatars and not options.frame_rate_hz:
        options = replace(options, frame_rate_hz=AVATAR_FRAME_RATE_HZ)
    with ExitStack() as stack:
        out = sys.stdout if arguments.output == STANDARD else stack.enter_context(_opened(arguments.output))
        understudy = stack.enter_context(Understudy.load(settings))
        senders: tuple[FrameSender, ...] = ()
        if moves_avatars:
            senders = avatar_senders(arguments, understudy, options.frame_rate_hz or AVATAR_FRAME_RATE_HZ, stack)
            chunks = chunks if arguments.microphone else _paced(chunks, rate_hz)
        sink = _Sink(out, senders, tells_frames=arguments.frames is not None)
        _perform(replace(LiveModels.load(understudy), motion=model), options, chunks, sink)
    return 0


@dataclass(frozen=True, slots=True)
class _Sink:
    """The destinations of the output."""

    out: TextIO
    senders: tuple[FrameSender, ...]
    tells_frames: bool

    def line(self, message: str) -> None:
        self.out.write(message + "\n")
        self.out.flush()

    def told(self, told: LiveMessage) -> None:
        if isinstance(told, BodyFrame):
            for sender in self.senders:
                sender.send(told)
        if not isinstance(told, BodyFrame) or self.tells_frames:
            self.line(to_json(told))


def _search(arguments: argparse.Namespace) -> Search:
    """RTS' m and n. Raises InputError `value_wrong`, `usage`."""
    step, best = arguments.search or (1, None)
    if arguments.search and not arguments.model:
        raise InputError("usage", "--search needs --model")
    if step < 1 or (best is not None and best < 1):
        raise InputError("value_wrong", f"--search {step} {best}; give 1 or more for both", field="search")
    return Search(step, best)


def _opened(path: str) -> TextIO:
    """A file that is written during the stream. Raises InputError `file_unwritable`."""
    try:
        return open(path, "w", encoding="utf-8")
    except OSError as error:
        raise InputError("file_unwritable", f"{path}: cannot be written: {error.strerror}") from None


def _check_rate(rate_hz: int | None, settings: Settings) -> None:
    limits = audio_limits(settings)
    lowest, highest = limits.min_sample_rate_hz, limits.max_sample_rate_hz
    if rate_hz is not None and not lowest <= rate_hz <= highest:
        raise InputError("value_wrong", f"--rate {rate_hz}; give {lowest} to {highest} samples a second", field="rate")


def _sound(arguments: argparse.Namespace, settings: Settings, log: Log) -> tuple[int, Iterator[FloatArray]]:
    """The sample rate and the chunks of the input."""
    rate_hz = arguments.rate
    if arguments.microphone:
        return rate_hz or SAMPLE_RATE_HZ, microphone_chunks(rate_hz or SAMPLE_RATE_HZ, CHUNK_S)
    if rate_hz is not None and arguments.audio == STANDARD:
        return rate_hz, _chunks_of(sys.stdin.buffer, rate_hz)
    content = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    if rate_hz is not None:
        return rate_hz, _cut(_samples(content), rate_hz)
    audio, notices = read_audio(content, settings)
    log.warnings(notices)
    return SAMPLE_RATE_HZ, _cut(audio.samples, SAMPLE_RATE_HZ)


def _perform(models: LiveModels, options: LiveOptions, chunks: Iterator[FloatArray], sink: _Sink) -> None:
    """Writes everything as soon as it is known."""
    session = LiveSession(models, options)
    joints = models.understudy.realizer.skeleton.names if sink.tells_frames else ()
    sink.line(to_ready(options, tuple(joints)))
    for chunk in chunks:
        for told in session.hear(chunk):
            sink.told(told)
    sink.line(to_done(session.heard_s))


def _paced(chunks: Iterator[FloatArray], rate_hz: int) -> Iterator[FloatArray]:
    """The chunks in real time: none before its end would have been heard."""
    began_s, heard_s = time.monotonic(), 0.0
    for chunk in chunks:
        heard_s += len(chunk) / rate_hz
        time.sleep(max(0.0, began_s + heard_s - time.monotonic()))
        yield chunk


def _chunks_of(stream: BinaryIO, rate_hz: int) -> Iterator[FloatArray]:
    """16-bit samples as they arrive; an odd byte at the end is dropped."""
    size = 2 * round(CHUNK_S * rate_hz)
    while len(content := stream.read(size)) > 1:
        yield _samples(content)


def _samples(content: bytes) -> FloatArray:
    return read_samples(content[: len(content) // 2 * 2], 1)[:, 0]


def _cut(samples: FloatArray, rate_hz: int) -> Iterator[FloatArray]:
    size = round(CHUNK_S * rate_hz)
    return (samples[first : first + size] for first in range(0, len(samples), size))

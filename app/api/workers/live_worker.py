"""The process of one live stream: its main loop, in which messages come in and go out over its socket until the stream
or the socket ends, and the conversation, a client's messages in, the service's messages out, in order (docs/live.md).

A process for each stream is cheap, for it shares what the nursery has loaded, and no stream waits for another. Wrong
words or silences are reported and the stream goes on; any other error ends it.
"""

import logging
import os
import socket
import time
from collections.abc import Iterator
from dataclasses import replace

import psutil

from ...errors import InputError, ServiceError, TooLargeError, UnderstudyError
from ...library.hearing import audio_limits
from ...live.messages import LiveMessage
from ...live.models import LiveModels
from ...live.session import LiveSession
from ...model import FloatArray
from ...schemas.live import (
    ClientMessage,
    CommandMessage,
    ListenMessage,
    SilenceMessage,
    StartMessage,
    WordsMessage,
    read_message,
    read_samples,
    to_done,
    to_error,
    to_json,
    to_ready,
)
from ...settings import Settings
from .families import end_with
from .limits import ProcessorShare, ProcessorTimeError, give_way, limit_memory, processor_time, too_large, too_long
from .messages import LiveInput, LiveOutput, Ready, receive, send

STEP_S = 0.1
"""Longer chunks are processed in parts, so that messages carry the time at which they were due."""


class Conversation:
    """One stream. After it has `ended`, nothing is answered."""

    def __init__(self, models: LiveModels, settings: Settings) -> None:
        self._models, self._settings = models, settings
        self._session: LiveSession | None = None
        self._start: StartMessage | None = None
        self._listens = False
        self.ended = False

    @property
    def heard_s(self) -> float:
        return self._session.heard_s if self._session else 0.0

    def answer(self, content: bytes, *, is_text: bool) -> Iterator[str]:
        """The answers to one message of the client."""
        try:
            yield from self._text(content) if is_text else self._sound(content)
        except UnderstudyError as error:
            self.ended = True
            yield to_error(error)

    def _text(self, content: bytes) -> Iterator[str]:
        message = read_message(content)
        if isinstance(message, StartMessage):
            yield self._started(message)
            return
        session = self._begun("a message")
        try:
            yield from map(to_json, self._told(session, message))
        except UnderstudyError as error:
            yield to_error(error, goes_on=True)
        if isinstance(message, CommandMessage) and message.type == "end":
            self.ended = True
            yield to_done(session.heard_s)

    def _told(self, session: LiveSession, message: ClientMessage) -> tuple[LiveMessage, ...]:
        match message:
            case WordsMessage(text=None, words=()):
                raise InputError("field_missing", "words: send text, or words with times", field="words")
            case WordsMessage(text=str(text), words=()):
                return session.text(text)
            case WordsMessage(text=None):
                return session.words(message.timed)
            case WordsMessage():
                raise InputError("value_wrong", "words: send text or words with times, not both", field="words")
            case SilenceMessage():
                self._require_room(session, message.duration_s)
                return session.silence(message.duration_s)
            case ListenMessage():
                self._listens = message.type == "listen"
            case CommandMessage(type="interrupt"):
                return session.interrupt()
        return ()

    def _started(self, message: StartMessage) -> str:
        """Raises InputError `live_started`, `value_wrong`, `unknown_character`, `motion_model`."""
        if self._session is not None:
            raise InputError("live_started", "this stream has already started; open another")
        limits = audio_limits(self._settings)
        lowest, highest = limits.min_sample_rate_hz, limits.max_sample_rate_hz
        if not lowest <= message.sample_rate_hz <= highest:
            told = f"sample_rate_hz: {message.sample_rate_hz}; give {lowest} to {highest}"
            raise InputError("value_wrong", told, field="sample_rate_hz")
        self._start, self._session = message, LiveSession(self._models_for(message), message.options)
        joints = self._models.understudy.realizer.skeleton.names if message.frames else ()
        return to_ready(message.options, tuple(joints))

    def _models_for(self, message: StartMessage) -> LiveModels:
        if message.motion_model is None:
            return self._models
        from ...library.motion_models import motion_model_named  # imported late: few streams need it

        return replace(self._models, motion=motion_model_named(message.motion_model, self._settings))

    def _sound(self, content: bytes) -> Iterator[str]:
        session = self._begun("sound")
        assert self._start is not None, "a session has a start"
        samples = read_samples(content, self._start.channels)
        self._require_room(session, len(samples) / self._start.sample_rate_hz)
        step = max(1, round(STEP_S * self._start.sample_rate_hz))
        for first in range(0, len(samples), step):
            yield from map(to_json, self._heard(session, samples[first : first + step]))

    def _heard(self, session: LiveSession, samples: FloatArray) -> tuple[LiveMessage, ...]:
        if samples.shape[1] == 2:
            return session.hear(samples[:, 0], samples[:, 1])
        return session.hear(None, samples[:, 0]) if self._listens else session.hear(samples[:, 0])

    def _begun(self, what: str) -> LiveSession:
        if self._session is None:
            raise InputError("live_not_started", f'{what} came before the start; send {{"type": "start"}} first')
        return self._session

    def _require_room(self, session: LiveSession, duration_s: float) -> None:
        if session.heard_s + duration_s > self._settings.live_s:
            message = f"a stream lasts {self._settings.live_s:g} s at most; begin another"
            raise TooLargeError("live_too_long", message)


_LOGGER = logging.getLogger(__name__)
_FRAME = '{"type":"frame"'

STARTS_WITH_S, USUAL_SHARE = 5.0, 0.5
"""The processor time that a stream may use at first, and its share afterwards; with frames it uses .15 of a core."""

STREAMS_NICE = 5
"""Beside a line each of two streams on its core still gets a quarter of it, more than it needs, and fourteen that begin
at once leave the line a third."""

FASTEST_CLOCK = 1.02
"""A sender whose clock runs no faster is never throttled; the clocks of sound cards are within .005 of true."""


def stream(service: socket.socket, models: LiveModels, settings: Settings, turns: int) -> None:
    """Answers one client until its stream is over. `turns` is a file that all streams share (`ProcessorShare`)."""
    os.nice(STREAMS_NICE)
    end_with(service)
    limit_memory(settings.worker_memory_bytes)
    send(service, Ready(os.getpid(), psutil.Process().memory_info().rss))
    conversation, pace = Conversation(models, settings), ProcessorShare(turns)
    began_s, spent_s = time.monotonic(), time.process_time()
    while not conversation.ended:
        try:
            message, content, _ = receive(service)
            assert isinstance(message, LiveInput)
            pace.earn(conversation.heard_s, time.monotonic() - began_s)
            _answer(service, conversation, settings, bytes(content), is_text=message.is_text, pace=pace)
        except (EOFError, OSError):
            break
        passed_s = time.monotonic() - began_s
        if takes_too_much(time.process_time() - spent_s, passed_s):
            give_way()
        time.sleep(too_soon_s(conversation.heard_s, passed_s, settings.live_ahead_s))
    models.understudy.close()


def takes_too_much(processor_s: float, passed_s: float) -> bool:
    """Whether a stream has used more processor time than speech in real time needs, as in an attack."""
    return processor_s > STARTS_WITH_S + USUAL_SHARE * passed_s


def too_soon_s(heard_s: float, passed_s: float, ahead_s: float) -> float:
    """How long to wait before reading more sound: the sound heard may be `ahead_s` ahead of the clock."""
    return max(0.0, heard_s - passed_s * FASTEST_CLOCK - ahead_s)


def _answer(
    service: socket.socket,
    conversation: Conversation,
    settings: Settings,
    content: bytes,
    *,
    is_text: bool,
    pace: ProcessorShare,
) -> None:
    """Sends the answers to a message; a bug is logged and sent as `internal_error`."""
    frames: list[str] = []
    others: list[str] = []
    try:
        with processor_time(settings.live_message_s, pace):
            for told in conversation.answer(content, is_text=is_text):
                (frames if told.startswith(_FRAME) else others).append(told)
    except ProcessorTimeError:
        conversation.ended = True
        others.append(to_error(too_long(settings.live_message_s)))
    except MemoryError:
        conversation.ended = True
        others.append(to_error(too_large(settings.worker_memory_bytes)))
    except Exception:
        _LOGGER.exception("internal error in a live stream")
        conversation.ended = True
        others.append(to_error(ServiceError("internal_error", "see the log")))
    if frames:
        send(service, LiveOutput(ended=False, are_frames=True), "\n".join(frames).encode())
    if others:
        send(service, LiveOutput(ended=conversation.ended, are_frames=False), "\n".join(others).encode())

"""The conversation of a live stream: a client's messages in, the service's messages out, in order (docs/live.md).

Wrong words or silences are reported and the stream goes on; any other error ends it.
"""

from collections.abc import Iterator
from dataclasses import replace

from ...errors import InputError, TooLargeError, UnderstudyError
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
            raise InputError("live_started", "this stream has begun already; open another for another start")
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

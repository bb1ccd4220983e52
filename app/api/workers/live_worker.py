"""The main loop of a process with one live stream: messages come in and go out over its socket, until the stream or the
socket ends. A process for each stream is cheap, for it shares what the nursery has loaded, and no stream waits for
another.
"""

import logging
import os
import socket
import time

import psutil

from ...errors import ServiceError
from ...live.models import LiveModels
from ...schemas.live import to_error
from ...settings import Settings
from .conversation import Conversation
from .families import end_with
from .limits import ProcessorTimeError, give_way, limit_memory, processor_time, too_large, too_long
from .messages import LiveInput, LiveOutput, Ready, receive, send

_LOGGER = logging.getLogger(__name__)
_FRAME = '{"type":"frame"'

STARTS_WITH_S, USUAL_SHARE = 5.0, 0.5
"""The processor time that a stream may use at first, and its share afterwards; with frames it uses .15 of a core."""

FASTEST_CLOCK = 1.02
"""A sender whose clock runs no faster is never throttled; the clocks of sound cards are within .005 of true."""


def stream(service: socket.socket, models: LiveModels, settings: Settings, turns: int) -> None:
    """Answers one client until its stream is over. `turns` is a file that all streams share (`processor_time`)."""
    end_with(service)
    limit_memory(settings.worker_memory_bytes)
    send(service, Ready(os.getpid(), psutil.Process().memory_info().rss))
    conversation = Conversation(models, settings)
    began_s, spent_s = time.monotonic(), time.process_time()
    while not conversation.ended:
        before_s = time.process_time()
        try:
            message, content, _ = receive(service)
            assert isinstance(message, LiveInput)
            _answer(service, conversation, settings, bytes(content), is_text=message.is_text, turns=turns)
        except (EOFError, OSError):
            break
        processor_s, passed_s = time.process_time(), time.monotonic() - began_s
        if takes_too_much(processor_s - spent_s, passed_s):
            give_way()
        rest_s = rest_after_s(processor_s - before_s, conversation.heard_s, passed_s)
        time.sleep(max(rest_s, too_soon_s(conversation.heard_s, passed_s, settings.live_ahead_s)))
    models.understudy.close()


def takes_too_much(processor_s: float, passed_s: float) -> bool:
    """Whether a stream has used more processor time than speech in real time needs, as in an attack."""
    return processor_s > STARTS_WITH_S + USUAL_SHARE * passed_s


def rest_after_s(processor_s: float, heard_s: float, passed_s: float) -> float:
    """How long to rest after a message that took so much processor time: as long again while the sound is ahead of the
    clock, so that it takes half a core at most. A voice is never ahead."""
    return processor_s if heard_s > passed_s else 0.0


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
    turns: int,
) -> None:
    """Sends the answers to a message; a bug is logged and sent as `internal_error`."""
    frames: list[str] = []
    others: list[str] = []
    try:
        with processor_time(settings.live_message_s, turns=turns):
            for told in conversation.answer(content, is_text=is_text):
                (frames if told.startswith(_FRAME) else others).append(told)
    except ProcessorTimeError:
        conversation.ended = True
        others.append(to_error(too_long(settings.live_message_s)))
    except MemoryError:
        conversation.ended = True
        others.append(to_error(too_large(settings.worker_memory_bytes)))
    except Exception:
        _LOGGER.exception("a mistake of ours in a live stream")
        conversation.ended = True
        others.append(to_error(ServiceError("internal_error", "see the log")))
    if frames:
        send(service, LiveOutput(ended=False, are_frames=True), "\n".join(frames).encode())
    if others:
        send(service, LiveOutput(ended=conversation.ended, are_frames=False), "\n".join(others).encode())

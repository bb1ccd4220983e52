"""The messages between the service and its processes over local sockets: a pickled value and binary content.

A message is two lengths (network order, 8 bytes each), the pickle, then the content, which is not pickled because it
may be many megabytes of audio or motion. Both ends are our own processes, joined by a socket pair.
"""

import asyncio
import pickle
import socket
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any, TypeAlias

from ...errors import UnderstudyError
from ...settings import Settings

_LENGTHS = struct.Struct("!QQ")
_LARGEST_READ = 1 << 20

Content: TypeAlias = bytes | bytearray


class Task(StrEnum):
    """The kind of a request."""

    PERFORM = "perform"
    REALIZE = "realize"
    FUNCTIONS = "functions"
    GESTURE_CHECK = "gesture_check"
    GESTURE_MOTION = "gesture_motion"
    GESTURE_POSE = "gesture_pose"
    RULE_CHECK = "rule_check"
    RULE_EXPLANATION = "rule_explanation"
    RULE_COMPARISON = "rule_comparison"


@dataclass(frozen=True, slots=True)
class Job:
    """An unparsed request; its body is the content."""

    task: Task
    content_type: str
    accept: str | None


@dataclass(frozen=True, slots=True)
class Answer:
    """The response; its body is the content."""

    media_type: str
    headers: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class JobFailure:
    """The error of a job."""

    error: UnderstudyError


@dataclass(frozen=True, slots=True)
class Start:
    """To the nursery, first: the settings, and the configuration of `logging.config` (None: no logging). A renewal
    takes the place of a nursery that died, and forks before it warms up."""

    settings: Settings
    logging: dict[str, Any] | None
    is_renewal: bool = False


@dataclass(frozen=True, slots=True)
class LoadedLibrary:
    """From the nursery, after each loading: the library as JSON, by path."""

    library: Mapping[str, bytes]


@dataclass(frozen=True, slots=True)
class Fork:
    """To the nursery, with a socket: fork a worker at its other end, with these settings; for jobs or for one live
    stream."""

    settings: Settings
    is_live: bool = False


@dataclass(frozen=True, slots=True)
class Divide:
    """To the nursery, with a socket: fork a second nursery, with all that is loaded, at its other end."""


@dataclass(frozen=True, slots=True)
class Reload:
    """To the nursery: read rules, words, characters and gestures again."""


@dataclass(frozen=True, slots=True)
class Ready:
    """From a forked process, first: its process id, its memory at that time, which is shared, bytes, and whether it
    has inherited what is loaded lazily."""

    pid: int
    shared_bytes: int
    is_warm: bool = True


@dataclass(frozen=True, slots=True)
class LiveInput:
    """To a live worker: a message of its client, in the content."""

    is_text: bool


@dataclass(frozen=True, slots=True)
class LiveOutput:
    """From a live worker: messages for the client, one a line, in the content. Outputs that `are_frames` may be
    dropped; none follows one that has `ended`."""

    ended: bool
    are_frames: bool


Message: TypeAlias = (
    Job | Answer | JobFailure | Start | LoadedLibrary | Fork | Divide | Reload | Ready | LiveInput | LiveOutput
)


def send(to: socket.socket, message: Message, content: Content = b"", *, pass_on: tuple[int, ...] = ()) -> None:
    """Sends a message, and with it file descriptors. Raises OSError when nobody is there."""
    value = pickle.dumps(message)
    socket.send_fds(to, [_LENGTHS.pack(len(value), len(content))], pass_on)
    to.sendall(value)
    to.sendall(content)


def receive(of: socket.socket) -> tuple[Message, bytearray, list[int]]:
    """The next message, its content, and the descriptors that came with it. Raises EOFError when there is no more."""
    lengths, passed, _flags, _address = socket.recv_fds(of, _LENGTHS.size, 1)
    head = bytearray(lengths).ljust(_LENGTHS.size, b"\0")
    if not lengths:
        raise EOFError
    _fill(of, memoryview(head)[len(lengths) :])
    value_bytes, content_bytes = _LENGTHS.unpack(head)
    value, content = bytearray(value_bytes), bytearray(content_bytes)
    _fill(of, memoryview(value))
    _fill(of, memoryview(content))
    message: Message = pickle.loads(value)
    return message, content, passed


async def send_soon(to: socket.socket, message: Message, content: Content = b"") -> None:
    """As `send`, while the event loop goes on; the socket does not block."""
    loop, value = asyncio.get_running_loop(), pickle.dumps(message)
    await loop.sock_sendall(to, _LENGTHS.pack(len(value), len(content)) + value)
    await loop.sock_sendall(to, content)


async def receive_soon(of: socket.socket) -> tuple[Message, bytearray]:
    """As `receive`, while the event loop goes on; the socket does not block."""
    value_bytes, content_bytes = _LENGTHS.unpack(await _filled(of, _LENGTHS.size))
    message: Message = pickle.loads(await _filled(of, value_bytes))
    return message, await _filled(of, content_bytes)


def _fill(of: socket.socket, rest: memoryview) -> None:
    while rest:
        count = of.recv_into(rest, min(len(rest), _LARGEST_READ))
        if not count:
            raise EOFError
        rest = rest[count:]


async def _filled(of: socket.socket, size: int) -> bytearray:
    loop, content = asyncio.get_running_loop(), bytearray(size)
    rest = memoryview(content)
    while rest:
        count = await loop.sock_recv_into(of, rest[:_LARGEST_READ])
        if not count:
            raise EOFError
        rest = rest[count:]
    return content

"""`WS /live`: relays messages between a client and the process of its stream (docs/live.md).

Messages are not parsed here. What is sent waits in a queue: a slow reader gets only the newest frames, with a count of
the skipped ones, and all other messages; when the queue is full the stream blocks. A client that reads or sends nothing
for too long is disconnected. A disconnect is noticed at once, and ends the process.
"""

import asyncio
import fcntl
import termios
from collections import deque
from collections.abc import Mapping
from contextlib import suppress
from types import MappingProxyType

from fastapi import APIRouter, WebSocket
from starlette.websockets import WebSocketDisconnect, WebSocketState

from ..errors import ForbiddenError, ServiceError, SlowClientError, TooLargeError, TooManyError, UnderstudyError
from ..schemas.live import to_error, to_frames_skipped
from ..settings import Settings
from .admission.access import LETS_IN
from .admission.keys import PROTOCOL, caller_of, offers_protocol
from .service import Service
from .websockets import GONE
from .workers.messages import LiveInput, LiveOutput, receive_soon, send_soon
from .workers.processes import Worker
from .workers.streams import stopping

MOST_FRAMES, MOST_OTHERS = 32, 64
"""Outputs that may wait, of frames and of everything else. An output has the frames of one chunk of sound."""


class OutgoingQueue:
    """A queue of outputs and their lines, for one producer and one consumer."""

    def __init__(self) -> None:
        self._waiting: deque[tuple[LiveOutput, str]] = deque()
        self._skipped = 0
        self._changed = asyncio.Condition()

    async def put(self, output: LiveOutput, lines: str) -> None:
        """Frames never wait: the oldest give way. Everything else waits for room."""
        async with self._changed:
            await self._changed.wait_for(lambda: output.are_frames or self._count(are_frames=False) < MOST_OTHERS)
            self._waiting.append((output, lines))
            if self._count(are_frames=True) > MOST_FRAMES:
                self._skip()
            self._changed.notify_all()

    async def take(self) -> tuple[LiveOutput, str]:
        """The next output, when there is one; after frames were skipped, first their number."""
        async with self._changed:
            await self._changed.wait_for(lambda: self._waiting)
            if self._skipped:
                count, self._skipped = self._skipped, 0
                return LiveOutput(ended=False, are_frames=False), to_frames_skipped(count)
            taken = self._waiting.popleft()
            self._changed.notify_all()
            return taken

    def _count(self, *, are_frames: bool) -> int:
        return sum(output.are_frames is are_frames for output, _ in self._waiting)

    def _skip(self) -> None:
        """Leaves out the oldest frames."""
        oldest = next(place for place, (output, _) in enumerate(self._waiting) if output.are_frames)
        self._skipped += len(self._waiting[oldest][1].splitlines())
        del self._waiting[oldest]


BEHIND_S = 60.0
"""How long a client need not send while what it sent ahead of the clock waits: the longest silence of a message."""

KEYS_EVERY_S = 1.0
"""How often it is looked whether a stream's key is still in use."""

GOING_AWAY, ENDED, TRY_AGAIN, IDLE, ABNORMAL = 1001, 1000, 1013, 1008, 1006

CLOSED_WITH: Mapping[str, int] = MappingProxyType(
    {"service_stopping": GOING_AWAY, "live_idle": IDLE, "live_unread": IDLE, "key_wrong": IDLE, "live_too_long": ENDED}
)
"""Close codes by error code; `TRY_AGAIN` for all others."""

router = APIRouter()


@router.websocket("/live")
async def live(socket: WebSocket) -> None:
    """A stream of speech in, gestures out."""
    service: Service = socket.app.state.service
    await socket.accept(PROTOCOL if offers_protocol(socket.headers) else None)
    try:
        service.rates.take(socket.client.host if socket.client else "")
        async with service.streams.process(caller_of(socket)) as worker:
            await _converse(socket, service, worker)
    except (ForbiddenError, ServiceError, SlowClientError, TooLargeError, TooManyError) as error:
        await _refuse(socket, error)
    except (WebSocketDisconnect, ConnectionError):
        pass


async def _converse(socket: WebSocket, service: Service, worker: Worker) -> None:
    """Relays until one side ends the stream."""
    told = OutgoingQueue()
    tasks = {
        asyncio.create_task(_listen(socket, worker, service.settings)),
        asyncio.create_task(_hear(worker, told)),
        asyncio.create_task(_tell(socket, told, service.settings)),
        asyncio.create_task(_stop(service)),
        asyncio.create_task(_expire(service.settings)),
        asyncio.create_task(_leave(socket)),
        asyncio.create_task(_shut_out(socket)),
    }
    try:
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        for task in done:
            task.result()
    finally:
        for task in tasks:
            task.cancel()
        ended, _ = await asyncio.wait(tasks)  # gather would take a cancellation of this for one of theirs
        for task in ended:
            if not task.cancelled():
                task.exception()  # retrieved: it was sent, or came too late


async def _listen(socket: WebSocket, worker: Worker, settings: Settings) -> None:
    """Passes the client's messages to the process. Raises WebSocketDisconnect, SlowClientError `live_idle`, but not
    before the process has read what came, or `BEHIND_S` have passed."""
    waited_s = 0.0
    while True:
        try:
            async with asyncio.timeout(settings.live_idle_s):
                message = await socket.receive()
        except TimeoutError:
            waited_s += settings.live_idle_s
            if waited_s <= BEHIND_S and _is_behind(worker):
                continue
            told = f"nothing was sent for {waited_s:g} s; send silence while a microphone is off"
            raise SlowClientError("live_idle", told) from None
        waited_s = 0.0
        if message["type"] == "websocket.disconnect":
            raise WebSocketDisconnect(message.get("code", ENDED))
        text = message.get("text")
        content = message.get("bytes") or b"" if text is None else text.encode("utf-8", "surrogatepass")
        with suppress(BrokenPipeError, ConnectionError):  # it has ended; its last output says why
            await send_soon(worker.socket, LiveInput(is_text=text is not None), content)


def _is_behind(worker: Worker) -> bool:
    """Whether messages wait for the process, which reads one at a time, and sound when its time has come."""
    try:
        unread = fcntl.ioctl(worker.socket, termios.TIOCOUTQ, bytes(4))
    except OSError:  # not known of such sockets here
        return False
    return any(unread)


async def _hear(worker: Worker, told: OutgoingQueue) -> None:
    """Queues the process's messages. Raises ServiceError `worker_lost` if it ended unexpectedly."""
    while True:
        try:
            output, content = await receive_soon(worker.socket)
        except (EOFError, OSError):
            raise ServiceError("worker_lost", "the process of this stream ended; open another") from None
        assert isinstance(output, LiveOutput)
        await told.put(output, content.decode())
        if output.ended:
            await asyncio.Event().wait()  # until `_tell` has sent the last output


async def _tell(socket: WebSocket, told: OutgoingQueue, settings: Settings) -> None:
    """Sends the queue to the client, until the last message. Raises SlowClientError `live_unread`."""
    while True:
        output, lines = await told.take()
        for line in lines.split("\n"):
            try:
                async with asyncio.timeout(settings.idle_s):
                    await socket.send_text(line)
            except TimeoutError:
                raise SlowClientError("live_unread", f"nothing was read for {settings.idle_s:g} s") from None
        if output.ended:
            await socket.close(ENDED)
            return


async def _stop(service: Service) -> None:
    await service.streams.stopped()
    raise stopping()


async def _expire(settings: Settings) -> None:
    """Limits a stream in wall-clock time as in sound; one without sound would otherwise never end."""
    await asyncio.sleep(settings.live_s)
    raise TooLargeError("live_too_long", f"a stream lasts {settings.live_s:g} s at most; begin another")


async def _leave(socket: WebSocket) -> None:
    """Raises WebSocketDisconnect when the connection is lost; `_listen` would notice only at its next receive."""
    gone: asyncio.Event = socket.scope.get("extensions", {}).get(GONE) or asyncio.Event()
    await gone.wait()
    raise WebSocketDisconnect(ABNORMAL)


async def _shut_out(socket: WebSocket) -> None:
    """Raises ForbiddenError `key_wrong` when the key that the stream began with is removed or expires."""
    while getattr(socket.state, LETS_IN)():
        await asyncio.sleep(KEYS_EVERY_S)
    raise ForbiddenError("key_wrong", "the API key has expired or is no longer in use")


async def _refuse(socket: WebSocket, error: UnderstudyError) -> None:
    """Sends the error and closes, if the client still reads; otherwise `websockets.py` cuts the client off."""
    with suppress(RuntimeError, WebSocketDisconnect, TimeoutError, ConnectionError):
        async with asyncio.timeout(1.0):
            if socket.application_state is WebSocketState.CONNECTED:
                await socket.send_text(to_error(error))
            await socket.close(CLOSED_WITH.get(error.code, TRY_AGAIN))

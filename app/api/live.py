"""`WS /live`: passes a client's messages to the process of its stream, and back what that tells (docs/live.md).

Nothing of a message is read here. A client that reads slowly gets fewer frames and is told so, but every other message;
one that reads nothing, or sends nothing, for too long is let go. One that has left is noticed at once, whatever is
being waited for, and its process ended.
"""

import asyncio
from collections.abc import Mapping
from contextlib import suppress
from types import MappingProxyType

from fastapi import APIRouter, WebSocket
from starlette.websockets import WebSocketDisconnect, WebSocketState

from ..errors import ServiceError, SlowClientError, TooLargeError, TooManyError, UnderstudyError
from ..schemas.live import to_error
from ..settings import Settings
from .admission.callers import caller_of
from .admission.keys import PROTOCOL, offers_protocol
from .service import Service
from .unsent import Unsent
from .websockets import GONE
from .workers.messages import LiveInput, LiveOutput, receive_soon, send_soon
from .workers.processes import Worker
from .workers.streams import stopping

GOING_AWAY, ENDED, TRY_AGAIN, IDLE, ABNORMAL = 1001, 1000, 1013, 1008, 1006

CLOSED_WITH: Mapping[str, int] = MappingProxyType(
    {"service_stopping": GOING_AWAY, "live_idle": IDLE, "live_unread": IDLE, "live_too_long": ENDED}
)
"""By the code of the error; with `TRY_AGAIN` for any other."""

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
    except (ServiceError, SlowClientError, TooLargeError, TooManyError) as error:
        await _refuse(socket, error)
    except (WebSocketDisconnect, ConnectionError):
        pass


async def _converse(socket: WebSocket, service: Service, worker: Worker) -> None:
    """Until one side ends it."""
    told = Unsent()
    tasks = {
        asyncio.create_task(_listen(socket, worker, service.settings)),
        asyncio.create_task(_hear(worker, told)),
        asyncio.create_task(_tell(socket, told, service.settings)),
        asyncio.create_task(_stop(service)),
        asyncio.create_task(_expire(service.settings)),
        asyncio.create_task(_leave(socket)),
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
                task.exception()  # which has been told, or came too late


async def _listen(socket: WebSocket, worker: Worker, settings: Settings) -> None:
    """The client's messages to the process. Raises WebSocketDisconnect, SlowClientError `live_idle`."""
    while True:
        try:
            async with asyncio.timeout(settings.live_idle_s):
                message = await socket.receive()
        except TimeoutError:
            told = f"nothing was sent for {settings.live_idle_s:g} s; send silence while a microphone is off"
            raise SlowClientError("live_idle", told) from None
        if message["type"] == "websocket.disconnect":
            raise WebSocketDisconnect(message.get("code", ENDED))
        text = message.get("text")
        content = message.get("bytes") or b"" if text is None else text.encode("utf-8", "surrogatepass")
        with suppress(BrokenPipeError, ConnectionError):  # it has ended, of which its last output tells more
            await send_soon(worker.socket, LiveInput(is_text=text is not None), content)


async def _hear(worker: Worker, told: Unsent) -> None:
    """What the process tells, into the queue. Raises ServiceError `worker_lost` where it ended unasked."""
    while True:
        try:
            output, content = await receive_soon(worker.socket)
        except (EOFError, OSError):
            raise ServiceError("worker_lost", "the process of this stream ended; begin again") from None
        assert isinstance(output, LiveOutput)
        await told.put(output, content.decode())
        if output.ended:
            await asyncio.Event().wait()  # the last output is told, and then all is over


async def _tell(socket: WebSocket, told: Unsent, settings: Settings) -> None:
    """What is in the queue to the client, until the last. Raises SlowClientError `live_unread`."""
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
    """A stream lasts as long by the clock as by its sound, or it could hold a place for ever without any."""
    await asyncio.sleep(settings.live_s)
    raise TooLargeError("live_too_long", f"a stream lasts {settings.live_s:g} s at most; begin another")


async def _leave(socket: WebSocket) -> None:
    """Raises WebSocketDisconnect when the connection is lost, which `_listen` learns only when it next receives."""
    gone: asyncio.Event = socket.scope.get("extensions", {}).get(GONE) or asyncio.Event()
    await gone.wait()
    raise WebSocketDisconnect(ABNORMAL)


async def _refuse(socket: WebSocket, error: UnderstudyError) -> None:
    """Says why, if anybody still listens; who reads nothing is cut off below (`websockets.py`)."""
    with suppress(RuntimeError, WebSocketDisconnect, TimeoutError, ConnectionError):
        async with asyncio.timeout(1.0):
            if socket.application_state is WebSocketState.CONNECTED:
                await socket.send_text(to_error(error))
            await socket.close(CLOSED_WITH.get(error.code, TRY_AGAIN))

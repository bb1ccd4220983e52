"""What all requests share, and how a request for work is answered: its body is read and given to a worker, which is
stopped when the client has gone.
"""

import asyncio
from collections.abc import AsyncIterator, Coroutine
from contextlib import asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, TypeVar

from fastapi import Depends, Request, Response
from starlette.requests import ClientDisconnect

from ..settings import Settings
from .admission.keys import caller_of
from .admission.rates import Rates
from .bodies import Uploads, body_limit, declared_bytes
from .metrics import Metrics
from .workers.limits import Deadline
from .workers.messages import Job, Task
from .workers.pool import Pool
from .workers.streams import Streams
from .workers.turns import Caller

Result = TypeVar("Result")


@dataclass(slots=True)
class Service:
    """The shared state. `not_reloaded` says why saved files are not in use (`--reload`). Authored files are
    saved in `author_folder`; if None, nowhere."""

    settings: Settings
    pool: Pool
    streams: Streams
    uploads: Uploads
    rates: Rates
    metrics: Metrics
    not_reloaded: str | None = None
    author_folder: Path | None = None


def service_of(request: Request) -> Service:
    """The shared state of the application of `request`."""
    service: Service = request.app.state.service
    return service


Shared = Annotated[Service, Depends(service_of)]


async def worked(request: Request, service: Service, task: Task) -> Response:
    """The answer of a worker. Raises UnderstudyError, ClientDisconnect."""
    deadline, content_type = Deadline.starting_now(service.settings.deadline_s), request.headers.get("content-type", "")
    job = Job(task, content_type, request.headers.get("accept"))
    most_bytes = body_limit(task, content_type, service.settings)
    declared = declared_bytes(request.headers)
    async with (
        _admitted(request, service) as caller,
        service.uploads.body(request.receive, most_bytes=most_bytes, declared_bytes=declared) as body,
    ):
        answer, content = await _unless_gone(request, service.pool.run(job, body, deadline, caller))
    return Response(bytes(content), media_type=answer.media_type, headers=dict(answer.headers))


async def answered(request: Request, service: Service, job: Job, body: bytes) -> bytes:
    """What a worker answers to a job of the service's own, for a request whose body has been read. Raises as `worked`
    does."""
    deadline = Deadline.starting_now(service.settings.deadline_s)
    async with _admitted(request, service) as caller:
        _, content = await _unless_gone(request, service.pool.run(job, bytearray(body), deadline, caller))
    return bytes(content)


@asynccontextmanager
async def _admitted(request: Request, service: Service) -> AsyncIterator[Caller]:
    """The caller, for whom there is a place; whoever does not wait until there is one is answered later."""
    service.rates.take(request.client.host if request.client else "")
    caller = Caller(caller_of(request), request.headers.get("x-request-id", "")[:64])
    async with service.pool.refusals.held_back(caller.client):
        service.pool.require_place(caller)
        yield caller


async def _unless_gone(request: Request, work: Coroutine[Any, Any, Result]) -> Result:
    """The result of `work`, which is cancelled when the client disconnects. Raises ClientDisconnect."""
    working = asyncio.create_task(work)
    gone = asyncio.create_task(_disconnected(request))
    try:
        await asyncio.wait({working, gone}, return_when=asyncio.FIRST_COMPLETED)
        if not working.done():
            raise ClientDisconnect
        return working.result()
    finally:
        working.cancel()
        gone.cancel()


async def _disconnected(request: Request) -> None:
    """Returns when the client has disconnected; the whole body must have been read before."""
    while (await request.receive())["type"] != "http.disconnect":
        pass

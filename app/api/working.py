"""A request for work, from its body to its answer: read, given to a worker, and stopped when its client has gone."""

import asyncio
from collections.abc import Coroutine
from typing import Any, TypeVar

from fastapi import Request, Response
from starlette.requests import ClientDisconnect

from .admission.callers import caller_of
from .bodies import body_limit
from .deadlines import Deadline
from .service import Service
from .uploads import declared_bytes
from .workers.messages import Job, Task

Result = TypeVar("Result")


async def worked(request: Request, service: Service, task: Task) -> Response:
    """The answer of a worker. Raises UnderstudyError for whatever went wrong, ClientDisconnect."""
    service.rates.take(request.client.host if request.client else "")
    caller = f"{caller_of(request)} {request.headers.get('x-request-id', '')[:64]}"
    service.pool.require_place(caller)
    deadline = Deadline.starting_now(service.settings.deadline_s)
    content_type = request.headers.get("content-type", "")
    job = Job(task, content_type, request.headers.get("accept"))
    most_bytes = body_limit(task, content_type, service.settings)
    declared = declared_bytes(request.headers)
    async with service.uploads.body(request.receive, most_bytes=most_bytes, declared_bytes=declared) as body:
        answer, content = await _unless_gone(request, service.pool.run(job, body, deadline, caller))
    return Response(bytes(content), media_type=answer.media_type, headers=dict(answer.headers))


async def _unless_gone(request: Request, work: Coroutine[Any, Any, Result]) -> Result:
    """What `work` brings, which is cancelled when the client goes away. Raises ClientDisconnect."""
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
    """Returns when the client has gone; the whole body has been read before."""
    while (await request.receive())["type"] != "http.disconnect":
        pass

"""Bodies just under and just over the limit, however they arrive."""

import asyncio
from collections.abc import Sequence

import pytest
from starlette.requests import Request
from starlette.types import Message, Receive, Scope, Send

from understudy.api.body_limit import BodyLimit
from understudy.errors import TooLargeError

LIMIT = 100


def _read_through(chunks: Sequence[bytes], headers: Sequence[tuple[bytes, bytes]] = ()) -> tuple[bytes, int]:
    """The body as the application reads it, and how many chunks are left; raises what the limit raises."""
    left = list(chunks)
    bodies: list[bytes] = []

    async def receive() -> Message:
        chunk = left.pop(0)
        return {"type": "http.request", "body": chunk, "more_body": bool(left)}

    async def send(_message: Message) -> None: ...

    async def read(scope: Scope, receive: Receive, _send: Send) -> None:
        bodies.append(await Request(scope, receive).body())

    scope = {"type": "http", "method": "POST", "path": "/", "headers": list(headers)}
    asyncio.run(BodyLimit(read, LIMIT)(scope, receive, send))
    return bodies[0], len(left)


@pytest.mark.parametrize("chunks", [[b"x" * LIMIT], [b"x"] * LIMIT, [b"x" * (LIMIT - 1), b"", b"x"]])
def test_a_body_of_the_limit_passes(chunks: list[bytes]) -> None:
    assert _read_through(chunks) == (b"x" * LIMIT, 0)


@pytest.mark.parametrize("headers", [[], [(b"content-length", b"5")], [(b"content-length", b"101")]])
@pytest.mark.parametrize("chunks", [[b"x" * (LIMIT + 1)], [b"x"] * (LIMIT + 1)])
def test_one_byte_more_is_refused_whatever_the_length_header_says(
    chunks: list[bytes], headers: list[tuple[bytes, bytes]]
) -> None:
    with pytest.raises(TooLargeError) as caught:
        _read_through(chunks, headers)
    assert caught.value.code == "body_too_large"


def test_what_follows_is_dropped_only_up_to_the_limit_again() -> None:
    taken: list[int] = []

    async def receive() -> Message:
        taken.append(1)
        return {"type": "http.request", "body": b"x" * 10, "more_body": True}

    async def send(_message: Message) -> None: ...

    async def read(scope: Scope, receive: Receive, _send: Send) -> None:
        await Request(scope, receive).body()

    scope = {"type": "http", "method": "POST", "path": "/", "headers": []}
    with pytest.raises(TooLargeError):
        asyncio.run(BodyLimit(read, LIMIT)(scope, receive, send))
    assert len(taken) * 10 <= 2 * LIMIT + 20

"""Bodies just under and just over the limits, however they arrive."""

import asyncio
from collections.abc import Sequence

import pytest
from starlette.datastructures import Headers
from starlette.requests import ClientDisconnect
from starlette.types import Message, Receive

from understudy.api.bodies import Uploads, declared_bytes
from understudy.errors import ServiceError, SlowClientError, TooLargeError
from understudy.settings import Settings

LIMIT = 100


def _arriving(chunks: Sequence[bytes], *, then: Message | None = None) -> tuple[Receive, list[bytes]]:
    """A connection on which the chunks arrive, and what is left of them; after them `then`, or nothing for ever."""
    left = list(chunks)

    async def receive() -> Message:
        if left:
            chunk = left.pop(0)
            return {"type": "http.request", "body": chunk, "more_body": bool(left) or then is not None}
        if then is None or then["type"] != "http.disconnect":
            await asyncio.Event().wait()
        assert then is not None
        return then

    return receive, left


async def _read(uploads: Uploads, receive: Receive) -> bytes:
    async with uploads.body(receive, most_bytes=LIMIT) as body:
        assert uploads.held_bytes >= len(body)
        return bytes(body)


@pytest.mark.parametrize("chunks", [[b"x" * LIMIT], [b"x"] * LIMIT, [b"x" * (LIMIT - 1), b"", b"x"]])
def test_a_body_of_the_limit_passes_and_is_then_forgotten(chunks: list[bytes]) -> None:
    uploads = Uploads(Settings())
    assert asyncio.run(_read(uploads, _arriving(chunks)[0])) == b"x" * LIMIT
    assert uploads.held_bytes == 0


@pytest.mark.parametrize("chunks", [[b"x" * (LIMIT + 1)], [b"x"] * (LIMIT + 1)])
def test_one_byte_more_is_refused(chunks: list[bytes]) -> None:
    uploads = Uploads(Settings())
    with pytest.raises(TooLargeError) as caught:
        asyncio.run(_read(uploads, _arriving(chunks)[0]))
    assert caught.value.code == "body_too_large"
    assert uploads.held_bytes == 0


def test_what_is_declared_as_too_large_is_not_read() -> None:
    async def scenario() -> None:
        receive, left = _arriving([b"x" * 10] * 100)
        with pytest.raises(TooLargeError) as caught:
            async with Uploads(Settings()).body(receive, most_bytes=LIMIT, declared_bytes=LIMIT + 1):
                pass
        assert caught.value.code == "body_too_large"
        assert len(left) == 100
        async with Uploads(Settings()).body(receive, most_bytes=1000, declared_bytes=1000) as body:
            assert len(body) == 1000

    asyncio.run(scenario())


@pytest.mark.parametrize(("length", "declared"), [("12", 12), ("", None), (None, None), ("-1", None), ("x", None)])
def test_the_declared_length_is_that_of_the_header(length: str | None, declared: int | None) -> None:
    assert declared_bytes(Headers({} if length is None else {"Content-Length": length})) == declared


def test_what_follows_is_dropped_only_up_to_the_limit_again() -> None:
    receive, left = _arriving([b"x" * 10] * 100)
    with pytest.raises(TooLargeError):
        asyncio.run(_read(Uploads(Settings()), receive))
    assert (100 - len(left)) * 10 <= 2 * LIMIT + 20


def test_all_bodies_together_have_a_limit() -> None:
    async def scenario() -> None:
        uploads = Uploads(Settings(max_uploads_bytes=LIMIT + 9))
        async with uploads.body(_arriving([b"x" * 10])[0], most_bytes=LIMIT):
            with pytest.raises(ServiceError) as caught:
                await _read(uploads, _arriving([b"x" * LIMIT])[0])
            assert caught.value.code == "uploads_full"
            assert uploads.held_bytes == 10
        assert await _read(uploads, _arriving([b"x" * LIMIT])[0])

    asyncio.run(scenario())


@pytest.mark.parametrize("settings", [{"idle_s": 0.01}, {"upload_s": 0.01}])
def test_a_body_that_does_not_come_is_not_waited_for(settings: dict[str, float]) -> None:
    uploads = Uploads(Settings.model_validate(settings))
    receive, _ = _arriving([b"x"], then={"type": "never"})
    with pytest.raises(SlowClientError) as caught:
        asyncio.run(_read(uploads, receive))
    assert caught.value.code == "upload_slow"
    assert uploads.held_bytes == 0


def test_a_client_that_leaves_is_told_apart() -> None:
    receive, _ = _arriving([b"x"], then={"type": "http.disconnect"})
    with pytest.raises(ClientDisconnect):
        asyncio.run(_read(Uploads(Settings()), receive))

"""An unusable address is reported before anything is loaded."""

import asyncio
import socket
from collections.abc import Iterator
from contextlib import ExitStack

import pytest

from understudy.api.workers.processes import Nursery
from understudy.cli.main import main
from understudy.cli.service import bind, listen
from understudy.errors import InputError

Captured = pytest.CaptureFixture[str]


@pytest.fixture
def taken() -> Iterator[int]:
    with socket.create_server(("127.0.0.1", 0)) as server:
        yield server.getsockname()[1]


def test_nobody_connects_before_it_listens() -> None:
    with ExitStack() as stack:
        bound = [stack.enter_context(each) for each in bind("127.0.0.1", 0)]
        address = bound[0].getsockname()
        with pytest.raises(ConnectionRefusedError):
            socket.create_connection(address)
        listen(bound)
        socket.create_connection(address).close()


def test_every_address_of_a_name_has_the_same_port() -> None:
    with ExitStack() as stack:
        bound = [stack.enter_context(each) for each in bind("localhost", 0)]
        assert len({each.getsockname()[1] for each in bound}) == 1
        assert "127.0.0.1" in {each.getsockname()[0] for each in bound}


def test_an_answer_in_two_writes_does_not_wait_for_the_client_to_acknowledge_the_first() -> None:
    """Without TCP_NODELAY the second waits 40 ms (Nagle's algorithm and delayed acknowledgements)."""

    async def accepted() -> int:
        found: asyncio.Future[int] = asyncio.get_running_loop().create_future()

        def on_client(_reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            found.set_result(writer.get_extra_info("socket").getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY))
            writer.close()

        [bound] = bind("127.0.0.1", 0)
        async with await asyncio.start_server(on_client, sock=bound):
            with socket.create_connection(bound.getsockname()):
                return await found

    assert asyncio.run(accepted())


@pytest.mark.parametrize("host", ["203.0.113.1", "no-such-host.invalid", "a" * 70, "256.1.1.1"])
def test_an_address_of_others_is_the_callers_mistake(host: str) -> None:
    with pytest.raises(InputError) as caught:
        bind(host, 0)
    assert caught.value.code == "address_unusable"


def test_two_that_are_bound_to_one_port_cannot_both_listen() -> None:
    with ExitStack() as stack:
        first = [stack.enter_context(each) for each in bind("127.0.0.1", 0)]
        second = [stack.enter_context(each) for each in bind("127.0.0.1", first[0].getsockname()[1])]
        listen(first)
        with pytest.raises(InputError) as caught:
            listen(second)
    assert caught.value.code == "address_unusable"


@pytest.fixture
def nothing_is_loaded(monkeypatch: pytest.MonkeyPatch) -> None:
    """All that is large is loaded in the nursery, which must not be started."""

    def start(*_arguments: object, **_named: object) -> None:
        raise AssertionError("the nursery is started")

    monkeypatch.setattr(Nursery, "start", start)


@pytest.mark.usefixtures("nothing_is_loaded")
def test_serve_on_a_taken_port_ends_before_loading(taken: int, capsys: Captured) -> None:
    assert main(["serve", "--port", str(taken)]) == 2
    [told] = capsys.readouterr().err.splitlines()
    assert f"127.0.0.1:{taken}" in told


@pytest.mark.usefixtures("nothing_is_loaded")
@pytest.mark.parametrize(
    ("settings", "told"),
    [
        ({"UNDERSTUDY_HOST": "0.0.0.0"}, "UNDERSTUDY_API_KEYS"),
        ({"UNDERSTUDY_HOST": "0.0.0.0", "UNDERSTUDY_API_KEYS": "short"}, "characters"),
        ({"UNDERSTUDY_API_KEYS_FILE": "/nowhere/keys"}, "/nowhere/keys"),
    ],
)
def test_serve_where_others_reach_it_wants_a_key_before_loading(
    settings: dict[str, str], told: str, monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    for name, value in settings.items():
        monkeypatch.setenv(name, value)
    assert main(["serve", "--port", "0"]) == 2
    [line] = capsys.readouterr().err.splitlines()
    assert told in line


@pytest.mark.usefixtures("nothing_is_loaded")
@pytest.mark.parametrize("port", ["-1", "65536", "http", "9" * 5000])
def test_serve_with_what_is_no_port_ends_before_loading(port: str, capsys: Captured) -> None:
    assert main(["serve", "--port", port]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1

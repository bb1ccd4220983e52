"""An unusable address is reported before anything is loaded."""

import asyncio
import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack

import pytest

from understudy.cli.service import bind, listen
from understudy.errors import InputError

SERVE = "import sys; from understudy.cli.main import main; ended = main(['serve', *sys.argv[1:]]); "


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


def test_serve_on_a_taken_port_ends_before_loading(taken: int) -> None:
    code = SERVE + "print(ended, 'spacy' in sys.modules, 'pocketsphinx' in sys.modules)"
    command = [sys.executable, "-c", code, "--port", str(taken)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["2", "False", "False"]
    [told] = done.stderr.splitlines()
    assert f"127.0.0.1:{taken}" in told


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        ({"UNDERSTUDY_HOST": "0.0.0.0"}, "UNDERSTUDY_API_KEYS"),
        ({"UNDERSTUDY_HOST": "0.0.0.0", "UNDERSTUDY_API_KEYS": "short"}, "characters"),
        ({"UNDERSTUDY_API_KEYS_FILE": "/nowhere/keys"}, "/nowhere/keys"),
    ],
)
def test_serve_where_others_reach_it_wants_a_key_before_loading(settings: dict[str, str], told: str) -> None:
    code = SERVE + "print(ended, 'spacy' in sys.modules)"
    command = [sys.executable, "-c", code, "--port", "0"]
    done = subprocess.run(command, capture_output=True, text=True, check=True, env={**os.environ, **settings})
    assert done.stdout.split() == ["2", "False"]
    [line] = done.stderr.splitlines()
    assert told in line


@pytest.mark.parametrize("port", ["-1", "65536", "http", "9" * 5000])
def test_serve_with_what_is_no_port_ends_before_loading(port: str) -> None:
    code = SERVE + "print(ended, 'spacy' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code, "--port", port], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["2", "False"]
    assert len(done.stderr.splitlines()) == 1

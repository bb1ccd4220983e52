"""What clients of `WS /live` do wrong or on purpose, and what happens to its processes: over sockets."""

import json
import os
import signal
import socket
import struct
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import psutil
import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from tests.support.served import HOST, Served, served
from understudy.api.workers.processes import Nursery

START = json.dumps({"type": "start", "frames": 60})
PATIENCE_S = 60.0
FREED_WITHIN_S = 20.0
"""On a busy machine; the drill asks for 5 s."""


def until(holds: Callable[[], bool], within_s: float = PATIENCE_S) -> None:
    ends_s = time.monotonic() + within_s
    while not holds():
        assert time.monotonic() < ends_s, "it never came about"
        time.sleep(0.02)


@contextmanager
def stream(running: Served) -> Iterator[ClientConnection]:
    """A stream that has begun."""
    with connect(f"ws://{HOST}:{running.port}/live", compression=None, proxy=None) as opened:
        opened.send(START)
        assert json.loads(opened.recv())["type"] == "ready"
        yield opened


def last(opened: ClientConnection) -> tuple[dict[str, object], int]:
    """The last message, and the code with which the stream is closed."""
    message = ""
    try:
        while True:
            message = str(opened.recv(PATIENCE_S))
    except ConnectionClosed as closed:
        return json.loads(message), closed.rcvd.code if closed.rcvd else 1006


def live_processes(nursery: Nursery, running: Served) -> set[int]:
    """The children of the nursery that are neither workers of the pool nor would take its place."""
    others = {worker.process.pid for worker in running.service.pool._workers()} | {nursery.next_pid}
    return {child.pid for child in psutil.Process(nursery.pid).children()} - others


def test_a_stream_begins_though_the_nursery_was_killed(nursery: Nursery) -> None:
    with nursery.divided() as own, served(own) as running:
        pool = running.service.pool
        own.require_next()
        os.kill(own.pid, signal.SIGKILL)
        with stream(running):
            assert pool.nursery is not own


@pytest.mark.parametrize("left", ["reset", "silences"])
def test_a_client_that_leaves_while_its_process_is_behind_frees_its_place_and_the_process_ends(
    nursery: Nursery, left: str
) -> None:
    with served(nursery) as running, stream(running) as opened:
        until(lambda: len(live_processes(nursery, running)) == 1)
        [pid] = live_processes(nursery, running)
        raw = opened.socket
        raw.settimeout(0.5)
        message = json.dumps({"type": "silence", "duration_s": 60}).encode() if left == "silences" else bytes(60_000)
        kind = 0x81 if left == "silences" else 0x82
        length = bytes([0x80 | len(message)]) if len(message) < 126 else b"\xfe" + struct.pack("!H", len(message))
        with suppress(TimeoutError):
            for _ in range(1000):
                raw.sendall(bytes([kind]) + length + b"\0\0\0\0" + message)
        raw.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        raw.shutdown(socket.SHUT_RDWR)
        until(lambda: running.service.streams.count == 0, FREED_WITHIN_S)
        until(lambda: not psutil.pid_exists(pid), FREED_WITHIN_S)


def test_a_process_ends_with_the_service_s_end_of_its_socket_whatever_it_does(nursery: Nursery) -> None:
    with served(nursery) as running, stream(running) as opened:
        until(lambda: len(live_processes(nursery, running)) == 1)
        [pid] = live_processes(nursery, running)
        opened.send(json.dumps({"type": "silence", "duration_s": 60}))
        opened.send(json.dumps({"type": "silence", "duration_s": 60}))
        opened.close()
        until(lambda: not psutil.pid_exists(pid), FREED_WITHIN_S)


def test_a_message_may_take_only_so_much_of_a_processor(nursery: Nursery) -> None:
    with served(nursery, deadline_s=3.0) as running, stream(running) as opened:
        words = " ".join("".join(chr(97 + (7 * n + k * k) % 26) for k in range(90)) for n in range(200))
        opened.send(json.dumps({"type": "words", "text": words}))
        told, code = last(opened)
    assert (told["code"], told["goes_on"], code) == ("work_too_large", False, 1000)


def test_a_stream_lasts_only_so_long_by_the_clock_whatever_it_sends(nursery: Nursery) -> None:
    with served(nursery, live_s=1.0) as running, stream(running) as opened:
        opened.send(json.dumps({"type": "listen"}))
        told, code = last(opened)
        assert (told["code"], code) == ("live_too_long", 1000)
        until(lambda: running.service.streams.count == 0, FREED_WITHIN_S)


def test_who_has_sent_ahead_of_the_clock_need_not_send_until_that_is_read(nursery: Nursery) -> None:
    """Two and a half seconds, which take two by the clock, and what comes after them."""
    with served(nursery, live_idle_s=1.0, live_ahead_s=0.5) as running, stream(running) as opened:
        opened.send(json.dumps({"type": "silence", "duration_s": 2.5}))
        opened.send(json.dumps({"type": "end"}))
        told, code = last(opened)
    assert (told["type"], code) == ("done", 1000)


def test_one_caller_does_not_have_all_places(nursery: Nursery) -> None:
    key = "a-key-of-sixteen-letters-or-more"
    with served(nursery, live_streams=2, api_keys=key) as running:
        headers, address = {"Authorization": f"Bearer {key}"}, f"ws://{HOST}:{running.port}/live"
        with connect(address, additional_headers=headers, proxy=None) as first:
            first.send(START)
            assert json.loads(first.recv())["type"] == "ready"
            with connect(address, additional_headers=headers, proxy=None) as second:
                told, code = last(second)
        assert (told["code"], code) == ("too_many_streams", 1013)


def test_a_stream_whose_key_is_removed_ends(nursery: Nursery, tmp_path: Path) -> None:
    keys, key = tmp_path / "keys", "a-key-of-sixteen-letters-or-more"
    keys.write_text(key)
    with served(nursery, api_keys_file=keys) as running:
        address, headers = f"ws://{HOST}:{running.port}/live", {"Authorization": f"Bearer {key}"}
        with connect(address, additional_headers=headers, proxy=None) as opened:
            opened.send(START)
            assert json.loads(opened.recv())["type"] == "ready"
            keys.write_text("another-" + key)
            told, code = last(opened)
    assert (told["code"], told["goes_on"], code) == ("key_wrong", False, 1008)


def test_words_of_impossible_length_are_told_and_nothing_computed(nursery: Nursery) -> None:
    with served(nursery) as running, stream(running) as opened:
        for words in (
            [{"text": "hello", "start_s": 0, "end_s": 1e5}],
            [{"text": "a", "start_s": 30 * n, "end_s": 30 * n + 30} for n in range(30)],
        ):
            opened.send(json.dumps({"type": "words", "words": words}))
            told = json.loads(opened.recv(PATIENCE_S))
            assert (told["type"], told["code"], told["goes_on"]) == ("error", "value_wrong", True)


def test_who_begins_streams_without_end_waits_for_some_of_them(nursery: Nursery) -> None:
    """Two at once, and eight a second from then on."""
    with served(nursery, live_streams=2) as running:
        began_s = time.monotonic()
        for _ in range(6):
            with stream(running):
                pass
            until(lambda: running.service.streams.count == 0)
        assert time.monotonic() - began_s > 0.45

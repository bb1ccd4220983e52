"""Sends requests to a service over persistent connections, from several threads, and judges each response."""

import json
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from http.client import HTTPConnection, HTTPException
from threading import Lock, local
from typing import Self, TypeVar

from .attacks import Attack
from .watching import HOST

Item = TypeVar("Item")
Result = TypeVar("Result")

FULL = 503
ALLOWED_ABOVE_500 = frozenset({503, 504})
PROBLEM = "application/problem+json"
LONGEST_S = 120.0
TRIES = 200


@dataclass(frozen=True, slots=True)
class Told:
    """An answer: its status, 0 where the connection ended without one, its content, how long it took, and how long
    whoever was refused is told to wait."""

    status: int
    media_type: str
    content: bytes
    took_s: float
    retry_after_s: float = 0.0

    @property
    def fault(self) -> str | None:
        """What an answer to any input may not be; None for one that it may."""
        if self.status == 0:
            return "no answer"
        if self.status >= 500 and self.status not in ALLOWED_ABOVE_500:
            return f"{self.status} {self.content[:200].decode(errors='replace')}"
        if self.status >= 400:
            return self._fault_of_problem()
        return None if self.content and self._is_json else f"{self.status} with {self.content[:200]!r}"

    @property
    def _is_json(self) -> bool:
        """False where the content claims to be JSON and is not, as with NaN in it."""
        if self.media_type != "application/json":
            return True
        try:
            json.loads(self.content, parse_constant=_refused)
        except ValueError:
            return False
        return True

    def _fault_of_problem(self) -> str | None:
        if self.media_type != PROBLEM:
            return f"{self.status} as {self.media_type}"
        problem = json.loads(self.content)
        if {"type", "title", "status", "code", "detail"} - problem.keys():
            return f"a problem without {sorted({'type', 'title', 'status', 'code', 'detail'} - problem.keys())}"
        return f"a detail of {len(problem['detail'])} characters" if len(problem["detail"]) > 2001 else None


def _refused(constant: str) -> float:
    raise ValueError(f"{constant} is not JSON")


class Client:
    """Asks one service; each thread has a connection of its own, which is kept as long as the service keeps it."""

    def __init__(self, port: int) -> None:
        self._port = port
        self._own = local()
        self._all: list[HTTPConnection] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        for connection in self._all:
            connection.close()

    def ask(self, asked: Attack) -> Told:
        """The answer; asks once more where a connection that was kept had been closed meanwhile."""
        media_type, body = asked.make()
        headers = {"Content-Type": media_type, "Accept": asked.accept}
        told = self._ask(asked.path, body, headers)
        return told if told.status or not self._close() else self._ask(asked.path, body, headers)

    def ask_until_taken(self, asked: Attack) -> Told:
        """The answer, asked for again while the service is full."""
        for _ in range(TRIES):
            told = self.ask(asked)
            if told.status != FULL:
                break
            time.sleep(0.05)
        return told

    def _ask(self, path: str, body: bytes, headers: dict[str, str]) -> Told:
        if getattr(self._own, "connection", None) is None:
            self._own.connection = HTTPConnection(HOST, self._port, timeout=LONGEST_S)
            self._all.append(self._own.connection)
        connection: HTTPConnection = self._own.connection
        began_s = time.perf_counter()
        try:
            connection.request("POST", path, body, headers)
            answer = connection.getresponse()
            content = answer.read()
        except (OSError, HTTPException):
            connection.close()
            return Told(0, "", b"", time.perf_counter() - began_s)
        media_type = (answer.getheader("Content-Type") or "").partition(";")[0]
        wait_s = float(answer.getheader("Retry-After") or 0)
        return Told(answer.status, media_type, content, time.perf_counter() - began_s, wait_s)

    def _close(self) -> bool:
        self._own.connection.close()
        return True


def in_threads(work: Callable[[Item], Result], items: Iterable[Item], threads: int) -> Iterator[Result]:
    """What `work` makes of each item, in any order; an item is taken when a thread is free for it."""
    source, lock = iter(items), Lock()

    def taken() -> list[Result]:
        results: list[Result] = []
        while True:
            with lock:
                item = next(source, None)
            if item is None:
                return results
            results.append(work(item))

    with ThreadPoolExecutor(threads) as pool:
        for each in [pool.submit(taken) for _ in range(threads)]:
            yield from each.result()

"""How fast a service works with one worker and with two, and how fast a place is free again."""

import socket
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager

from .asking import Client, in_threads
from .attacks import Attack
from .bars import Bar
from .lines import line_of, usual
from .watching import HOST, Running, percentile, serving


def freed() -> Iterator[Bar]:
    """How long a place is taken after its client went away, and after a 504."""
    quick, long = usual()[0], line_of(60.0)
    with serving({"workers": "1", "queue": "4"}) as service, Client(service.port) as client:
        usual_s = min(client.ask(quick).took_s for _ in range(5))
        gone_s = []
        for _ in range(3):
            with leaving(service, long):
                time.sleep(0.7)
            gone_s.append(client.ask(quick).took_s - usual_s)
    with serving({"workers": "1", "queue": "4", "deadline_s": "0.7"}) as service, Client(service.port) as client:
        late_s = []
        for _ in range(3):
            client.ask(long)
            late_s.append(client.ask_until_taken(quick).took_s - usual_s)
    for what, values in (("a disconnect", gone_s), ("a 504", late_s)):
        yield Bar(f"place freed after {what}", f"{max(values):.2f} s", "1 s", max(values) <= 1.0)


@contextmanager
def leaving(service: Running, asked: Attack) -> Iterator[None]:
    """A client that goes away without waiting for its answer."""
    media_type, body = asked.make()
    head = f"POST {asked.path} HTTP/1.1\r\nHost: x\r\nContent-Type: {media_type}\r\nContent-Length: {len(body)}\r\n\r\n"
    with socket.create_connection((HOST, service.port)) as connection:
        connection.sendall(head.encode() + body)
        yield


def loaded(count: int) -> Iterator[Bar]:
    """Lines a second of one worker and of two, and one client's wait for a line of five seconds."""
    line, rates, waits_s = line_of(5.0), list[float](), tuple[float, ...]()
    for workers in (1, 2):
        with serving({"workers": str(workers), "queue": "16"}) as service, Client(service.port) as client:
            list(in_threads(client.ask, [line] * 4, 2))
            if workers == 2:
                waits_s = tuple(client.ask(line).took_s for _ in range(count))
            began_s = time.monotonic()
            statuses = Counter(told.status for told in in_threads(client.ask, [line] * count, 4))
            rates.append(count / (time.monotonic() - began_s))
            print(f"{workers} workers: {rates[-1]:.2f} lines/s, {dict(statuses)}")
    p50_s = percentile(waits_s, 50)
    yield Bar(
        "throughput of two workers against one", f"{rates[1] / rates[0]:.2f} x", "1.8 x", rates[1] / rates[0] >= 1.8
    )
    yield Bar("POST /perform of 5 s, one client, p50", f"{p50_s:.3f} s", "0.30 s", p50_s <= 0.30)

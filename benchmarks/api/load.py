"""The service under load: throughput by workers, latency for one client and for sixteen, time until a place is free.

    python -m benchmarks.api.load [--part latency|throughput|freed] [--seconds N]

A client asks again as soon as it is answered, with a line of five seconds; one that is refused (503) waits as long as
it is told. Each part has services of its own. Bars: issue 15.
"""

import argparse
import socket
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from .asking import FULL, Client, in_threads
from .attacks import Attack
from .bars import Bar
from .lines import line_of, usual
from .watching import HOST, Running, percentile, serving, watching

CROWD = 16
USUAL_S = 15.0
"""How long clients ask."""

WARM_UP = 6


@dataclass(slots=True)
class Answers:
    """How long accepted requests took, how many were refused, and what else was answered, by status."""

    took_s: list[float] = field(default_factory=list)
    refused: int = 0
    others: Counter[int] = field(default_factory=Counter)


def latency(seconds: float) -> Iterator[Bar]:
    """One client, then a crowd."""
    with serving() as service:
        alone = tuple(asked(service, 1, seconds).took_s)
        with watching(service) as enough:
            answers = asked(service, CROWD, seconds)
            seen = enough()
    many = tuple(answers.took_s)
    print(f"1 client: p50 {percentile(alone, 50):.3f} s, p95 {percentile(alone, 95):.3f} s of {len(alone)}")
    print(
        f"{CROWD} clients: p50 {percentile(many, 50):.3f} s, p95 {percentile(many, 95):.3f} s of {len(many)}, ", end=""
    )
    print(f"{answers.refused} refused, others {dict(answers.others)}")
    p50_s, ratio = percentile(alone, 50), percentile(many, 95) / percentile(alone, 95)
    health_ms = seen.percentile_s(99) * 1000
    yield Bar("POST /perform of 5 s, one client, p50", f"{p50_s:.3f} s", "0.30 s", p50_s <= 0.30)
    yield Bar(f"p95 of {CROWD} clients against that of one", f"{ratio:.1f} x", "3 x", ratio <= 3.0)
    yield Bar(f"/healthz p99, {CROWD} clients", f"{health_ms:.0f} ms", "100 ms", health_ms <= 100)


def throughput(seconds: float) -> Iterator[Bar]:
    """Lines a second of one worker and of two, each with two clients a worker."""
    rates = []
    for workers in (1, 2):
        with serving({"workers": str(workers), "queue": "16"}) as service:
            answers = asked(service, 2 * workers, seconds)
        rates.append(len(answers.took_s) / seconds)
        print(f"{workers} workers: {rates[-1]:.2f} lines/s, others {dict(answers.others)}")
    ratio = rates[1] / rates[0]
    yield Bar("throughput of two workers against one", f"{ratio:.2f} x", "1.8 x", ratio >= 1.8)


def freed(_seconds: float = 0.0) -> Iterator[Bar]:
    """How long a place is taken after its client went away, and after a 504, beyond what the next request takes."""
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


PARTS: dict[str, Callable[[float], Iterator[Bar]]] = {"latency": latency, "throughput": throughput, "freed": freed}


def asked(service: Running, clients: int, seconds: float) -> Answers:
    """So many clients for so long."""
    line, answers, lock = line_of(5.0), Answers(), threading.Lock()
    with Client(service.port) as client:
        list(in_threads(client.ask_until_taken, [line] * WARM_UP, 2))
        until_s = time.monotonic() + seconds

        def keep_asking() -> None:
            while time.monotonic() < until_s:
                told = client.ask(line)
                with lock:
                    if told.status == 200:
                        answers.took_s.append(told.took_s)
                    elif told.status == FULL:
                        answers.refused += 1
                    else:
                        answers.others[told.status] += 1
                time.sleep(told.retry_after_s)

        threads = [threading.Thread(target=keep_asking) for _ in range(clients)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    return answers


@contextmanager
def leaving(service: Running, asked: Attack) -> Iterator[None]:
    """A client that goes away without waiting for its answer."""
    media_type, body = asked.make()
    head = f"POST {asked.path} HTTP/1.1\r\nHost: x\r\nContent-Type: {media_type}\r\nContent-Length: {len(body)}\r\n\r\n"
    with socket.create_connection((HOST, service.port)) as connection:
        connection.sendall(head.encode() + body)
        yield


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--seconds", type=float, default=USUAL_S, help="how long clients ask")
    arguments.add_argument("--part", choices=PARTS, action="append")
    options = arguments.parse_args()
    bars = [bar for part in options.part or PARTS for bar in PARTS[part](options.seconds)]
    print("\n| what | measured | floor | |\n|---|---|---|---|", *bars, sep="\n")
    return 0 if all(bar.met for bar in bars) else 1


if __name__ == "__main__":
    sys.exit(main())

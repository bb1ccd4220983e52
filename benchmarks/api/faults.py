"""How a running service stands load and faults: throughput by workers, latency under 16 clients, what is lost.

    python -m benchmarks.api.faults [--seconds N]

Clients ask again as soon as they are answered, with the bundled line cut to five seconds; one that is refused (503)
waits as long as it is told. Each part has a service of its own. Bars (issue 15): one client p50 .30 s; two workers
1.8 × one; at 16 clients p95 of what is accepted 3 × that of one and `/healthz` p99 100 ms; a place is free within 1 s
after its client has gone or its deadline has passed; nothing is lost when workers are killed.
"""

import argparse
import io
import socket
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from http.client import HTTPConnection

import psutil
import soundfile

from .attacks import AUDIO, Attack, bml, line
from .watching import HOST, Running, percentile, serving, watching

LINE_S = 5.0
TEXT = "No, I have never seen anything like those lights before! Are you really sure this is the best way?"
_BEATS = "".join(
    f'<gesture id="g{n}" lexeme="BEAT" start="{n * 1.5}" stroke="{n * 1.5 + 0.7}" end="{n * 1.5 + 1.4}"/>'
    for n in range(90)
)
LONG = Attack("two minutes of beats", "/realize", lambda: bml(_BEATS))


@dataclass(slots=True)
class Answers:
    """How long accepted requests took, how many were refused, and what else was answered."""

    took_s: list[float] = field(default_factory=list)
    refused: int = 0
    others: list[str] = field(default_factory=list)


def five_seconds() -> tuple[str, bytes]:
    """The line as a form."""
    samples, rate_hz = soundfile.read(AUDIO)
    cut = io.BytesIO()
    soundfile.write(cut, samples[: int(LINE_S * rate_hz)], rate_hz, format="WAV")
    return line(audio=("a.wav", cut.getvalue()), text=TEXT)


def ask(service: Running, body: tuple[str, bytes], answers: Answers, until_s: float) -> None:
    """One client, until the time has come."""
    connection = HTTPConnection(HOST, service.port, timeout=120)
    while time.monotonic() < until_s:
        began_s = time.monotonic()
        try:
            connection.request("POST", "/perform", body[1], {"Content-Type": body[0]})
            answer = connection.getresponse()
            answer.read()
        except OSError as error:
            answers.others.append(type(error).__name__)
            connection.close()
            continue
        if answer.status == 200:
            answers.took_s.append(time.monotonic() - began_s)
        elif answer.status == 503:
            answers.refused += 1
            time.sleep(float(answer.getheader("Retry-After", "1")))
        else:
            answers.others.append(str(answer.status))
    connection.close()


def asked(service: Running, clients: int, seconds: float) -> Answers:
    """So many clients for so long."""
    body, answers = five_seconds(), Answers()
    ask(service, body, Answers(), time.monotonic() + 3)
    until_s = time.monotonic() + seconds
    threads = [threading.Thread(target=ask, args=(service, body, answers, until_s)) for _ in range(clients)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return answers


def throughput(seconds: float) -> None:
    """Lines a second by workers, each with two clients a worker."""
    rates = []
    for workers in (1, 2):
        with serving({"workers": str(workers)}) as service:
            answers = asked(service, 2 * workers, seconds)
            rates.append(len(answers.took_s) / seconds)
            print(f"{workers} workers: {rates[-1]:.2f} lines/s; others: {answers.others}")
    print(f"two workers against one: {rates[1] / rates[0]:.2f} ×")


def latency(seconds: float) -> None:
    """One client, and sixteen."""
    with serving() as service:
        alone = tuple(asked(service, 1, seconds).took_s)
        print(f"1 client: p50 {percentile(alone, 50):.3f} s, p95 {percentile(alone, 95):.3f} s of {len(alone)}")
        with watching(service) as enough:
            answers = asked(service, 16, seconds)
            seen = enough()
        many = tuple(answers.took_s)
        ratio = percentile(many, 95) / percentile(alone, 95)
        print(f"16 clients: p50 {percentile(many, 50):.3f} s, p95 {percentile(many, 95):.3f} s ({ratio:.1f} ×)")
        print(f"{len(many)} answered, {answers.refused} refused, others: {answers.others}")
        health = f"p99 {seen.percentile_s(99) * 1000:.0f} ms, worst {seen.worst_s * 1000:.0f} ms"
        print(f"healthz {health}; memory {seen.peak_mb:.0f} MB")


def freed_after(service: Running, leave: Callable[[], None]) -> float:
    """Seconds until the only worker has answered a short request after `leave` has left a long one."""
    leave()
    began_s = time.monotonic()
    while Attack("", "/functions", lambda: ("application/json", b'{"text":"No."}')).send(HOST, service.port)[0] != 200:
        time.sleep(0.02)
    return time.monotonic() - began_s


def _disconnect(port: int) -> None:
    media_type, body = LONG.make()
    head = f"POST /realize HTTP/1.1\r\nHost: x\r\nContent-Type: {media_type}\r\nContent-Length: {len(body)}\r\n\r\n"
    with socket.create_connection((HOST, port)) as connection:
        connection.sendall(head.encode() + body)
        time.sleep(0.4)


def freed() -> None:
    """After a disconnect and after 504, five times each."""
    with serving({"workers": "1", "queue": "0"}) as service:
        times = [freed_after(service, partial(_disconnect, service.port)) for _ in range(5)]
        print("free after a disconnect:", ", ".join(f"{each:.2f}" for each in times), "s")
    with serving({"workers": "1", "queue": "0", "deadline_s": "0.5"}) as service:
        statuses: list[int] = []
        times = [freed_after(service, lambda: statuses.append(LONG.send(HOST, service.port)[0])) for _ in range(5)]
        print("free after", set(statuses), ", ".join(f"{each:.2f}" for each in times), "s")


def _workers(service: Running) -> list[psutil.Process]:
    """The children of the nursery."""
    return [worker for child in psutil.Process(service.process.pid).children() for worker in child.children()]


def kills(count: int) -> None:
    """Workers killed, one every second and a half, while two clients ask."""
    with serving({"queue": "8"}) as service:
        body, answers = five_seconds(), Answers()
        until_s = time.monotonic() + 1.5 * count + 3
        clients = [threading.Thread(target=ask, args=(service, body, answers, until_s)) for _ in range(2)]
        for client in clients:
            client.start()
        for number in range(count):
            time.sleep(1.5)
            with suppress(psutil.NoSuchProcess, IndexError):
                _workers(service)[number % 2].kill()
        for client in clients:
            client.join()
        told = f"{len(answers.took_s)} answered, {answers.refused} refused, {answers.others} lost"
        print(f"{count} workers killed: {told}")


def main(parts: Sequence[str] = ("throughput", "latency", "freed", "kills")) -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--seconds", type=float, default=30.0, help="how long each part of a load lasts")
    arguments.add_argument("--part", choices=parts, action="append")
    options = arguments.parse_args()
    chosen = options.part or parts
    if "latency" in chosen:
        latency(options.seconds)
    if "throughput" in chosen:
        throughput(options.seconds)
    if "freed" in chosen:
        freed()
    if "kills" in chosen:
        kills(20)


if __name__ == "__main__":
    main()

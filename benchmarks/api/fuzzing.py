"""Sends broken inputs to a service, and counts the responses by kind."""

import time
from collections import Counter
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from .asking import Client, Told, in_threads
from .attacks import Attack
from .bars import Bar, watched
from .broken.inputs import inputs
from .watching import Running, watching


def fuzzed(service: Running, count: int, *, seed: int, clients: int, keep: Path) -> Iterator[Bar]:
    """So many broken inputs."""
    answers, faults = Counter[tuple[str, int]](), Counter[str]()

    def asked(item: tuple[str, Attack]) -> tuple[str, Attack, Told]:
        return *item, client.ask_until_taken(item[1])

    began_s = time.monotonic()
    with Client(service.port) as client, watching(service) as enough:
        for kind, attack, told in in_threads(asked, islice(inputs(seed), count), clients):
            answers[kind, told.status] += 1
            if told.fault:
                faults[f"{kind}: {told.fault}"] += 1
                kept(attack, f"{seed}-{sum(faults.values())}", keep)
        seen = enough()
    print(f"{count} inputs in {time.monotonic() - began_s:.0f} s; answers by kind and status:")
    for kind in sorted({kind for kind, _ in answers}):
        row = ", ".join(f"{status}: {answers[kind, status]}" for name, status in sorted(answers) if name == kind)
        print(f"  {kind:20s} {row}")
    for fault, number in faults.most_common():
        print(f"  FAULT {number} x {fault}")
    yield Bar(f"wrong answers to {count} inputs", str(sum(faults.values())), "0", not faults)
    yield from watched("fuzzing", seen)


def kept(attack: Attack, name: str, folder: Path) -> None:
    """Writes down a request that was answered wrong."""
    folder.mkdir(parents=True, exist_ok=True)
    media_type, body = attack.make()
    (folder / f"{name}{attack.path.replace('/', '-')}").write_bytes(f"{media_type}\n".encode() + body)

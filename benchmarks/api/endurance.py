"""A service under load for a long time, and one whose workers are killed while they work."""

import random
import statistics
import time
from collections import Counter
from collections.abc import Iterator
from itertools import chain, cycle, islice
from threading import Event, Thread

import psutil

from .asking import Client, in_threads
from .bars import Bar, watched
from .lines import usual
from .watching import Running, memory_mb, watching

ASKERS = 3
"""While workers are killed: one more than there are usually workers, so that one waits."""


WARM_UP = 1000
"""Requests before memory is looked at: in its first few hundred a worker still comes to its usual size."""


def soaked(service: Running, count: int, clients: int, *, warm_up: int = WARM_UP) -> Iterator[Bar]:
    """So many usual requests after those that warm the workers up, with memory and descriptors looked at fifty times:
    the last fifth of the looks against the first."""
    looks, statuses = list[tuple[float, int]](), Counter[int]()
    part = max(1, count // 50)
    asked = cycle(usual())
    with Client(service.port) as client:
        statuses.update(told.status for told in in_threads(client.ask_until_taken, islice(asked, warm_up), clients))
    began_s = time.monotonic()
    for _ in range(0, count, part):
        with Client(service.port) as client:
            statuses.update(told.status for told in in_threads(client.ask_until_taken, islice(asked, part), clients))
            looks.append((memory_mb(service.family()), descriptors(service)))
    print(f"{warm_up} requests to warm up and {count} of soak in {time.monotonic() - began_s:.0f} s: {dict(statuses)}")
    fifth = max(1, len(looks) // 5)
    for name, at in (("memory", 0), ("descriptors", 1)):
        values = [look[at] for look in looks]
        early, late = statistics.median(values[:fifth]), statistics.median(values[-fifth:])
        growth = late / early - 1
        print(f"  {name}: {early:.0f} in the first fifth, {late:.0f} in the last, {max(values):.0f} at most")
        yield Bar(f"{name} over {count} requests", f"{growth:+.1%}", "5 %", growth <= 0.05)
    failed = sum(number for status, number in statuses.items() if status not in (200, 415))
    yield Bar(f"failures in {warm_up + count} requests of soak", str(failed), "0", failed == 0)


def descriptors(service: Running) -> int:
    """Files and sockets that the service's processes hold open together."""
    total = 0
    for process in service.family():
        try:
            total += process.num_fds()
        except (psutil.NoSuchProcess, psutil.AccessDenied):
            continue
    return total


def killed(service: Running, count: int, seed: int) -> Iterator[Bar]:
    """Workers killed one after another while lines are performed. The next is killed when every line that was under way
    at the last has been answered: a line that is killed is done once more, one that is killed twice is answered 503."""
    rng, stop = random.Random(seed), Event()
    answers: list[list[int]] = [[] for _ in range(ASKERS)]
    line = usual()[1]

    def keep_asking(statuses: list[int]) -> None:
        while not stop.is_set():
            statuses.append(client.ask(line).status)

    askers = [Thread(target=keep_asking, args=(statuses,)) for statuses in answers]
    with Client(service.port) as client, watching(service) as enough:
        for asker in askers:
            asker.start()
        for _ in range(count):
            time.sleep(rng.uniform(0.1, 0.4))
            kill_one(service, rng)
            before = [len(statuses) for statuses in answers]
            while any(len(statuses) < had + 2 for had, statuses in zip(before, answers, strict=True)):
                time.sleep(0.05)
        stop.set()
        for asker in askers:
            asker.join()
        seen = enough()
    done = Counter(chain.from_iterable(answers))
    print(f"{count} workers killed: {dict(done)}")
    lost = sum(number for status, number in done.items() if status != 200)
    yield Bar(f"requests lost in {count} kills, of {sum(done.values())}", str(lost), "0", lost == 0)
    yield from watched("kills", seen)


def kill_one(service: Running, rng: random.Random) -> None:
    """Kills a worker, which is a child of the process that forks them."""
    workers = [each for nursery in service.nursery() for each in nursery.children()]
    if workers:
        rng.choice(workers).kill()

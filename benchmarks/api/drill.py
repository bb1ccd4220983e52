"""Tests the service with broken inputs, a long soak, killed workers and attacks, and prints a table of the bars.

    python -m benchmarks.api.drill [--inputs 100000] [--messages 10000] [--files 10000] [--soak 10000] [--kills 20]
                                   [--seed 0] [--clients 4] [--only WORDS] [--no-attacks] [--no-disturbances]
                                   [--no-load] [--keep FOLDER]

`make drill` runs a short one.

Starts services of its own on free ports of 127.0.0.1, with the settings that a service has by default. Every answer but
a 5xx other than 503 and 504 is right, as long as it is a problem with a code or has content, and JSON where it says so;
inputs that are answered otherwise are kept in FOLDER (default out/drill). `broken.inputs` has the requests,
`broken.streams` the messages of live streams, `broken.files` what is read from disk; `attacks` has single requests,
`disturbances` what goes on while others ask honestly, `batch_faults` outputs that cannot be used, `clock_jumps` clocks
that jump, `unread` clients that do not read. What is opened in the studio's page, avatars and zip files, is attacked by
the page's own tests (`tests/studio/stage/glb_claims.test.js`, `tests/studio/exports/zip_files.test.js`). Ends
with 1 if a bar is missed.
"""

import argparse
import sys
import time
from collections.abc import Iterator
from pathlib import Path

from .asking import Client, in_threads
from .attacks import ATTACKS, hold_headers, hold_uploads
from .bars import Bar, watched
from .batch_faults import batch_faults
from .broken.files import files_broken
from .broken.streams import streams_broken
from .clock_jumps import clock_jumps
from .disturbed import disturbed
from .endurance import killed, soaked
from .fuzzing import fuzzed
from .lines import usual
from .load import PARTS, USUAL_S
from .unread import unread
from .watching import HOST, Watched, serving, watching

AFTERMATH_S = 0.3
"""So long an attack is watched after its answer."""

OUT = Path(__file__).resolve().parents[2] / "out" / "drill"


def attacked(only: str) -> Iterator[Bar]:
    """Each attack on one service, and the connections that never finish."""
    worst_s, peak_mb, wrong = 0.0, 0.0, list[str]()
    with serving() as service, Client(service.port) as client:
        client.ask(usual()[1])
        for attack in ATTACKS:
            if only not in attack.name:
                continue
            with watching(service) as enough:
                told = client.ask(attack)
                time.sleep(AFTERMATH_S)
                seen = enough()
            worst_s, peak_mb = max(worst_s, seen.worst_s), max(peak_mb, seen.peak_mb)
            wrong += [f"{attack.name}: {told.status}"] if told.status >= 500 and told.status not in (503, 504) else []
            print(f"  {attack.name:28s} {told.status} in {told.took_s:6.2f} s, /healthz {seen.worst_s * 1000:5.0f} ms")
        if not only:
            for hold in (hold_uploads, hold_headers):
                with watching(service) as enough, hold(HOST, service.port):
                    seen = enough()
                worst_s, peak_mb = max(worst_s, seen.worst_s), max(peak_mb, seen.peak_mb)
    yield from watched("attacks", Watched((worst_s,), peak_mb))
    yield Bar("5xx to attacks, but 503 and 504", ", ".join(wrong) or "0", "0", not wrong)


def drill(options: argparse.Namespace) -> list[Bar]:
    """Every part that is asked for."""
    bars: list[Bar] = []
    with serving() as service:
        with Client(service.port) as client:
            list(in_threads(client.ask_until_taken, usual() * 2, 2))
        if options.inputs:
            keep, seed = options.keep, options.seed
            bars += fuzzed(service, options.inputs, seed=seed, clients=options.clients, keep=keep)
        if options.messages:
            bars += streams_broken(service, options.messages, seed=options.seed, clients=options.clients)
        if options.soak:
            bars += soaked(service, options.soak, options.clients)
        if options.kills:
            bars += killed(service, options.kills, options.seed)
        runs = service.process.poll() is None
        bars.append(Bar("the service at the end", "runs" if runs else "ended", "runs", runs))
    if options.files:
        bars += files_broken(options.files, options.seed)
        bars += batch_faults()
    if not options.no_attacks:
        bars += attacked(options.only)
    if not options.no_disturbances:
        bars += disturbed(options.only)
        bars += clock_jumps() if options.only in "clock" else ()
        bars += unread() if options.only in "unread" else ()
    if not options.no_load:
        bars += [bar for part in PARTS.values() for bar in part(USUAL_S)]
    return bars


def main(argv: list[str] | None = None) -> int:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--inputs", type=int, default=100_000, help="broken inputs")
    arguments.add_argument("--messages", type=int, default=10_000, help="broken messages to live streams")
    arguments.add_argument("--files", type=int, default=10_000, help="broken files")
    arguments.add_argument("--soak", type=int, default=10_000, help="usual requests")
    arguments.add_argument("--kills", type=int, default=20, help="workers that are killed")
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--clients", type=int, default=4, help="requests at the same time")
    arguments.add_argument("--only", default="", help="attacks and disturbances with this in their names")
    arguments.add_argument("--no-attacks", action="store_true")
    arguments.add_argument("--no-disturbances", action="store_true", help="nothing that goes on while others ask")
    arguments.add_argument("--no-load", action="store_true", help="neither waits, throughput nor freed places")
    arguments.add_argument("--keep", type=Path, default=OUT, help="where inputs that were answered wrong are kept")
    bars = drill(arguments.parse_args(argv))
    print("\n| what | measured | floor | |\n|---|---|---|---|", *bars, sep="\n")
    return 0 if all(bar.met for bar in bars) else 1


if __name__ == "__main__":
    sys.exit(main())

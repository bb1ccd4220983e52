"""The effect of each attack of issue 15 on a running service: the worst `/healthz` during it, memory, the response.

    python -m benchmarks.api.under_attack [--only WORDS] [--times N]

Each attack meets a service that has performed before, N times at once (default 1); afterwards the service has to
perform a line. Bars: `/healthz` at worst 200 ms, the whole service 1.5 GB, no 5xx but 503 and 504.
"""

import argparse
import time
from concurrent.futures import ThreadPoolExecutor

from .attacks import ATTACKS, AUDIO, Attack, hold_headers, hold_uploads, line
from .watching import HOST, Running, Watched, serving, watching

LONGEST_S = 150.0
WARM = Attack("a line", "/perform", lambda: line(text=AUDIO.with_suffix(".txt").read_text()), "application/xml")


def told(answer: tuple[int, int] | OSError) -> str:
    """An answer in a few words."""
    if isinstance(answer, OSError):
        return type(answer).__name__
    return f"{answer[0]} ({answer[1] / 1e6:.1f} MB)" if answer[1] > 100_000 else str(answer[0])


def sent(attack: Attack, service: Running) -> tuple[int, int] | OSError:
    """The answer to an attack, or why there is none."""
    try:
        return attack.send(HOST, service.port, timeout_s=LONGEST_S)
    except OSError as error:
        return error


def row(name: str, took_s: float, seen: Watched, answers: str) -> str:
    """A line of the table."""
    health = f"{seen.worst_s * 1000:8.0f} ms {seen.percentile_s(99) * 1000:6.0f} ms"
    return f"{name:28s} {took_s:7.2f} s {health} {seen.peak_mb:7.0f} MB  {answers}"


def attacked(attack: Attack, service: Running, times: int) -> str:
    """One attack, so many times at once."""
    with watching(service) as enough, ThreadPoolExecutor(times) as senders:
        time.sleep(0.2)
        began_s = time.monotonic()
        answers = list(senders.map(lambda _: sent(attack, service), range(times)))
        took_s = time.monotonic() - began_s
        time.sleep(0.5)
        return row(attack.name, took_s, enough(), ", ".join(sorted({told(answer) for answer in answers})))


def held(service: Running) -> list[str]:
    """The connections that never finish."""
    rows = []
    for name, hold in (("60 uploads of 38 MB", hold_uploads), ("500 headers", hold_headers)):
        began_s = time.monotonic()
        with watching(service) as enough, hold(HOST, service.port):
            answer = told(sent(WARM, service))
            rows.append(row(name, time.monotonic() - began_s, enough(), f"a line meanwhile: {answer}"))
    return rows


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--only", default="", help="attacks with this in their names")
    arguments.add_argument("--times", type=int, default=1, help="how often at once")
    options = arguments.parse_args()
    print(f"{'attack':28s} {'took':>9s} {'healthz':>11s} {'p99':>9s} {'memory':>10s}  answer")
    for attack in ATTACKS:
        if options.only in attack.name:
            with serving() as service:
                sent(WARM, service)
                print(attacked(attack, service, options.times), "| then:", told(sent(WARM, service)), flush=True)
    if not options.only:
        with serving() as service:
            sent(WARM, service)
            print("\n".join(held(service)), flush=True)


if __name__ == "__main__":
    main()

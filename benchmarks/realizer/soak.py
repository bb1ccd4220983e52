"""Performs and realizes every recording with every character and level, and checks errors, jumps and limits.

    python -m benchmarks.realizer.soak [--seeds 5] [--every N] [--first K] [--physics]

The recordings are those of `benchmarks.realizer.liveliness`, each heard once; characters are all of the lexicon,
agitation all three levels. What must hold is in `tests/support/motion/motion_limits.py` and
`tests/support/motion/soaking.py`: no error, no number that is none, joints, head, eyes and hips within their speeds and
ranges in every frame, hands outside the body, valid BML, losers that lost to somebody. `--every N` takes each N-th
variant of a recording, and `--first K` begins with the K-th, so that a soak can be done in parts. With `--physics`
bodies have mass, and must not fall.
"""

import argparse
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

from benchmarks.realizer.liveliness import recorded_lines
from tests.support.motion.soaking import Variant, broken_by, variants
from understudy.model import Analysis
from understudy.models import Understudy
from understudy.performance import analyze
from understudy.settings import Settings


@dataclass(frozen=True, slots=True)
class Found:
    """A variant of a recording, and what is wrong with it."""

    recording: str
    variant: Variant
    broken: tuple[str, ...]


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--seeds", type=int, default=5)
    arguments.add_argument("--every", type=int, default=1)
    arguments.add_argument("--first", type=int, default=0)
    arguments.add_argument("--physics", action="store_true")
    options = arguments.parse_args()
    begun_s = time.monotonic()
    with Understudy.load(Settings()) as understudy:
        chosen = list(variants(sorted(understudy.behavior.characters.by_name), options.seeds))
        found = []
        for number, (name, line) in enumerate(recorded_lines().items()):
            analysis = analyze(understudy, line)
            part = chosen[(options.first + number) % options.every :: options.every]
            found += [Found(name, each, tried(understudy, analysis, each, physics=options.physics)) for each in part]
    report(found, time.monotonic() - begun_s)


def tried(understudy: Understudy, analysis: Analysis, variant: Variant, *, physics: bool) -> tuple[str, ...]:
    """What is wrong, an error among it: a soak goes on."""
    try:
        return tuple(broken_by(understudy, analysis, variant, physics=physics))
    except Exception as error:  # noqa: BLE001  # it tells of every error and goes on
        return (f"{type(error).__name__}: {error}",)


def report(found: list[Found], took_s: float) -> None:
    wrong = [each for each in found if each.broken]
    print(f"{len(found)} performances of {len({each.recording for each in found})} recordings in {took_s:.0f} s")
    print(f"with something wrong: {len(wrong)}")
    kinds = Counter(_kind(message) for each in wrong for message in each.broken)
    for kind, count in kinds.most_common():
        print(f"  {count:5} {kind}")
    for told in _told(wrong):
        print(told)


def _kind(message: str) -> str:
    return message.partition(":")[0]


def _told(wrong: list[Found], at_most: int = 40) -> Iterator[str]:
    for each in wrong[:at_most]:
        variant = each.variant
        yield f"{each.recording} {variant.character} {variant.level} {variant.seed}: {'; '.join(each.broken)}"


if __name__ == "__main__":
    main()

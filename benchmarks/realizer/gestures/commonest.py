"""The gestures that bodies make most often, which have to be told apart before all others.

    python -m benchmarks.realizer.gestures.commonest [--sentences N] [--write]

Plans the recorded lines of benchmarks/realizer/liveliness.py and N spoken sentences of GUM (default 500, three levels
of agitation in turns), `default`, and counts the clips that are played. `--write` keeps the first `MANY` in
commonest.yaml, with how often each was made; `silhouettes.py` and its tests read it.
"""

import argparse
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from itertools import cycle, islice
from pathlib import Path

import yaml

from benchmarks.realizer.liveliness import realized_lines, recorded_lines
from benchmarks.realizer.motion import of_sentences
from understudy.model import Level, Schedule
from understudy.models import load_realizer
from understudy.realization import schedule_of
from understudy.realizer.gestures.library import Library
from understudy.realizer.scheduling.planning import plan_gestures

MANY = 60
FILE = Path(__file__).with_name("commonest.yaml")
_HEAD = "# What bodies make most often, and how often: python -m benchmarks.realizer.gestures.commonest --write\n"


def commonest() -> dict[str, int]:
    """The gestures of the file, the commonest first."""
    found: dict[str, int] = yaml.safe_load(FILE.read_text())
    return found


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--sentences", type=int, default=500)
    arguments.add_argument("--write", action="store_true")
    options = arguments.parse_args()
    library = load_realizer().library
    counts = Counter(name for schedule in _schedules(options.sentences) for name in _made(library, schedule))
    print(f"{counts.total()} gestures, {len(counts)} different ones")
    for name, count in counts.most_common(MANY):
        print(f"{count:4} {name}")
    if options.write:
        FILE.write_text(_HEAD + yaml.safe_dump(dict(counts.most_common(MANY)), sort_keys=False))


def _schedules(sentences: int) -> Iterator[Schedule]:
    realizer = load_realizer()
    for line in realized_lines(realizer, recorded_lines(), "default", 0):
        yield line.schedule
    for performance, level in zip(islice(of_sentences("default"), sentences), cycle(Level), strict=False):
        yield replace(schedule_of(performance), agitation=level)


def _made(library: Library, schedule: Schedule) -> Iterator[str]:
    """The name of each gesture of the plan, once if two arms make it."""
    plan = plan_gestures(library, schedule, seed=0)
    yield from {each.behavior: each.placed.clip.name for each in plan.gestures}.values()


if __name__ == "__main__":
    main()

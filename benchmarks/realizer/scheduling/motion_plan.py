"""What happens to gestures between the schedule and the arms, and how long their phases last.

    python -m benchmarks.realizer.scheduling.motion_plan [--sentences N]
        [--recordings FOLDER] [--character NAME] [--seed N]

The lines are those of benchmarks/realizer/motion.py: N spoken sentences of GUM with made-up times, and in FOLDER
(default: ../shared/data/speech/lines) each recording NAME.flac with its words in NAME.txt. Phases are those of arms; of
two that do the same one counts. The figures beside ours are people's (shared/motion.md): storytelling, labelled by
hand.
"""

import argparse
import statistics
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from benchmarks.realizer.motion import LINES, of_lines, of_sentences
from understudy.model import Channel, Performance, Schedule
from understudy.models import load_realizer
from understudy.realization import schedule_of
from understudy.realizer.gestures.gesture_plan import ArmGesture, GesturePlan
from understudy.realizer.gestures.library import Library
from understudy.realizer.scheduling.planning import plan_gestures

PEOPLE = {
    "preparation": (0.53, 0.30, 1.05),
    "stroke": (0.73, 0.23, 2.64),
    "post-stroke hold": (0.43, 0.20, 1.10),
    "retraction": (0.53, 0.30, 1.10),
}
"""Median, 10th and 90th percentile in seconds."""
STROKES_A_UNIT = (60, 27, 4, 4, 2, 4)
"""Percent of units with 1, 2, 3, 4, 5 and more strokes."""
_PHASE_S = 0.03
"""What is shorter is no phase: nobody labels a hold of one frame."""


@dataclass(frozen=True, slots=True)
class Planned:
    """A line's schedule and its plan."""

    schedule: Schedule
    plan: GesturePlan


def planned(library: Library, performance: Performance, seed: int) -> Planned:
    """The line's plan."""
    schedule = schedule_of(performance)
    return Planned(schedule, plan_gestures(library, schedule, seed=seed))


def phase_durations_s(plans: Sequence[GesturePlan]) -> dict[str, list[float]]:
    """Every phase that lasts; the way from one gesture to the next is a preparation."""
    found: dict[str, list[float]] = {name: [] for name in PEOPLE}
    for plan in plans:
        alike = {(arm.behavior, arm.markers): arm for arm in plan.gestures}
        for arm in alike.values():
            for name, duration_s in zip(PEOPLE, _phases_s(arm), strict=True):
                if duration_s >= _PHASE_S:
                    found[name].append(duration_s)
    return found


def _phases_s(arm: ArmGesture) -> tuple[float, float, float, float]:
    markers = arm.markers
    struck_s = max([markers.stroke_end, *(repeat.end_s for repeat in arm.placed.repeats)])
    return (
        markers.ready - markers.start,
        struck_s - markers.stroke_start,
        markers.relax - struck_s,
        markers.end - markers.relax,
    )


def report(planned: Sequence[Planned]) -> None:
    plans = [line.plan for line in planned]
    asked = sum(each.kept and each.kind is Channel.GESTURE for line in planned for each in line.schedule.behaviors)
    minutes = sum(line.schedule.duration_s for line in planned) / 60
    played = sum(len(plan.realized) for plan in plans)
    decided = Counter(
        each for plan in plans for each in sorted({(told.behavior, told.action) for told in plan.decisions})
    )
    actions = Counter(action for _behavior, action in decided.elements())
    print(f"{len(planned)} lines, {minutes:.1f} minutes, {asked} gestures, {played / minutes:.1f} strokes a minute")
    shares = [f"{action} {_percent(count, asked)}" for action, count in actions.most_common()]
    print(f"placed {_percent(played, asked)}; {', '.join(shares)}")
    print(f"strokes off their BML time by at most {1000 * max(_off_s(line) for line in planned):.3f} ms")
    for name, durations_s in phase_durations_s(plans).items():
        report_phase(name, durations_s)
    sizes = Counter(min(len(unit.behaviors), len(STROKES_A_UNIT)) for plan in plans for unit in plan.units)
    units = [_percent(sizes[size], sizes.total()) for size in range(1, len(STROKES_A_UNIT) + 1)]
    print(f"strokes a unit: {' '.join(units)}; people {STROKES_A_UNIT}")
    rests = Counter(rest.pose for plan in plans for rest in plan.rests)
    print("rests: " + ", ".join(f"{pose} {count}" for pose, count in rests.most_common()))


def report_phase(name: str, durations_s: Sequence[float]) -> None:
    if len(durations_s) < 2:
        return
    tenths = statistics.quantiles(durations_s, n=10)
    median_s, people = statistics.median(durations_s), PEOPLE[name]
    off = 100 * (median_s / people[0] - 1)
    print(
        f"{name}: {median_s:.2f} s ({tenths[0]:.2f} to {tenths[-1]:.2f}), people {people[0]:.2f} s "
        f"({people[1]:.2f} to {people[2]:.2f}), {off:+.0f} %, {len(durations_s)} of them"
    )


def _off_s(line: Planned) -> float:
    asked = {each.id: each.sync.stroke or 0.0 for each in line.schedule.behaviors}
    return max((abs((sync.stroke or 0.0) - asked[name]) for name, sync in line.plan.realized.items()), default=0.0)


def _percent(count: int, whole: int) -> str:
    return f"{100 * count / max(whole, 1):.0f} %"


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--sentences", type=int, default=300)
    arguments.add_argument("--recordings", type=Path, default=LINES)
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--seed", type=int, default=0)
    options = arguments.parse_args()
    library = load_realizer().performer(options.character).library
    report(
        [planned(library, each, options.seed) for each in islice(of_sentences(options.character), options.sentences)]
    )
    if options.recordings.is_dir():
        report([planned(library, each, options.seed) for each in of_lines(options.recordings, options.character)])


if __name__ == "__main__":
    main()

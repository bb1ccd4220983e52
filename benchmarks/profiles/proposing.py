"""What `understudy profiles propose` finds in motion whose strokes are known.

    python -m benchmarks.profiles.proposing [--every N]

Ours: the lines of `benchmarks.realizer.liveliness` by both profiles, written as BVH and read again, against the main
strokes as they were played. People: storytellers whose wrists were tracked and whose strokes were annotated
(`benchmarks.realizer.storytellers`), against all strokes. A stroke is found if one that is proposed shares half of the
shorter one's time; each counts once. Errors of its limits are medians of those that were found; recall by chance is
that of the same proposals, half the motion later.
"""

import argparse
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from benchmarks.realizer.liveliness import recorded_lines
from benchmarks.realizer.storytellers import RATE_HZ, Take, storytellers
from understudy.model import Channel, Interval
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.profiles.annotation.model import PhaseKind
from understudy.profiles.proposing import ProposedUnit, WristPaths, proposed_units, read_wrists
from understudy.realization import MotionFormat, PreparedSchedule, RealizedSchedule, realize_prepared, write_motion
from understudy.settings import Settings


@dataclass(frozen=True, slots=True)
class Found:
    """The strokes of a motion, those that are proposed, and how long it is."""

    known: tuple[Interval, ...]
    proposed: tuple[Interval, ...]
    duration_s: float


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--every", type=int, default=4)
    options = parser.parse_args()
    print(
        f"{'':18}{'strokes':>8}{'proposed':>9}{'recall':>8}{'chance':>8}{'precision':>10}{'start, s':>10}{'end, s':>8}"
    )
    with Understudy.load(Settings()) as understudy:
        for profile in ("sweeping", "sparing"):
            report(f"ours, {profile}", list(our_motions(understudy, profile, options.every)))
    for name, takes in storytellers().items():
        report(f"people, {name}", list(map(in_take, takes)))


def our_motions(understudy: Understudy, profile: str, every: int) -> Iterator[Found]:
    """The main strokes of each line."""
    for line in list(recorded_lines().values())[::every]:
        prepared = PreparedSchedule.of(perform(understudy, line, Options(profile=profile)))
        realized = realize_prepared(understudy.realizer, prepared, frame_rate_hz=60, tail_s=1.0)
        content = write_motion(realized, understudy.realizer, MotionFormat.BVH)
        wrists = read_wrists(content, Path("line.bvh"))
        proposed = [_strokes(unit, all_of_them=False) for unit in proposed_units(wrists)]
        yield Found(tuple(_played(realized)), tuple(sum(proposed, ())), len(wrists.left_m) / wrists.frame_rate_hz)


def _played(realized: RealizedSchedule) -> Iterator[Interval]:
    gestures = {each.id for each in realized.schedule.behaviors if each.kept and each.kind is Channel.GESTURE}
    for name in sorted(gestures & realized.motion.realized.keys()):
        sync = realized.motion.realized[name]
        if sync.stroke_start is not None and sync.stroke_end is not None and sync.stroke_end > sync.stroke_start:
            yield Interval(sync.stroke_start, sync.stroke_end)


def in_take(take: Take) -> Found:
    """The strokes of a storyteller, seen from the trunk as those of a BVH are from the hips."""
    wrists = WristPaths(RATE_HZ, take.left_m - take.trunk_m, take.right_m - take.trunk_m)
    proposed = [_strokes(unit, all_of_them=True) for unit in proposed_units(wrists)]
    return Found(take.strokes, tuple(sum(proposed, ())), len(take.left_m) / RATE_HZ)


def _strokes(unit: ProposedUnit, *, all_of_them: bool) -> tuple[Interval, ...]:
    """The main strokes of a unit's phrases, or all."""
    strokes = [[phase.interval for phase in phrase.phases if phase.kind is PhaseKind.STROKE] for phrase in unit.phrases]
    return tuple(interval for own in strokes for interval in (own if all_of_them else own[:1]))


def report(name: str, found: Sequence[Found]) -> None:
    pairs = [list(_matched(each.known, each.proposed)) for each in found]
    known, proposed = (sum(len(getattr(each, which)) for each in found) for which in ("known", "proposed"))
    hits = sum(map(len, pairs))
    shifted = sum(len(list(_matched(each.known, tuple(_later(each))))) for each in found)
    starts, ends = ([getattr(b, at) - getattr(a, at) for own in pairs for a, b in own] for at in ("start_s", "end_s"))
    row = f"{hits / known:8.0%}{shifted / known:8.0%}{hits / proposed:10.0%}{median(starts):+10.2f}{median(ends):+8.2f}"
    print(f"{name:18}{known:8}{proposed:9}{row}")


def _later(found: Found) -> Iterator[Interval]:
    """What is proposed, half the motion later, what goes beyond its end from its start on."""
    for each in found.proposed:
        start_s = (each.start_s + found.duration_s / 2) % found.duration_s
        yield Interval(start_s, start_s + each.duration_s)


def _matched(known: Iterable[Interval], proposed: Sequence[Interval]) -> Iterator[tuple[Interval, Interval]]:
    """Each known stroke with the proposed one that shares the most of its time, each once."""
    left = list(proposed)
    for stroke in known:
        best = max(left, key=lambda each: _shared_s(stroke, each), default=None)
        if best is not None and _shared_s(stroke, best) >= 0.5 * min(stroke.duration_s, best.duration_s) > 0:
            left.remove(best)
            yield stroke, best


def _shared_s(one: Interval, other: Interval) -> float:
    return min(one.end_s, other.end_s) - max(one.start_s, other.start_s)


if __name__ == "__main__":
    main()

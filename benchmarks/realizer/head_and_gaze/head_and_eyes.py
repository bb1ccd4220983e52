"""Head turns and looks during a line: how far, how often, how fast, from its start to its end.

    python -m benchmarks.realizer.head_and_gaze.head_and_eyes [--character NAME] [--seed N] [--recordings-only]

Lines are those of `benchmarks.realizer.liveliness`. Conventions: degrees in the world; a look aside is a `LOOK` with a
direction, and its size is how far the head, or the line of sight, is from where it was as the look began, at its
farthest; the beginning is the first `START_S` of a line, the end its last `END_S`, the middle what is between.
"""

import argparse
from collections.abc import Iterator, Sequence

import numpy as np

from benchmarks.realizer.liveliness import recorded_lines
from benchmarks.realizer.motion import Realized, realized_once
from understudy.files import resource_folder
from understudy.model import Behavior, Channel, FloatArray
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import Realizer, schedule_of
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import angle_between, to_pitch_yaw_roll
from understudy.settings import Settings

FRAME_RATE_HZ = 60
START_S, END_S = 3.0, 1.0


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--recordings-only", action="store_true")
    options = arguments.parse_args()
    realizer, realized = Realizer.load(resource_folder("lexicon")), []
    with Understudy.load(Settings()) as understudy:
        for line in recorded_lines(recordings_only=options.recordings_only).values():
            performance = perform(understudy, line, Options(character=options.character, seed=options.seed))
            realized.append(realized_once(realizer, schedule_of(performance), FRAME_RATE_HZ))
    report(realized, realizer.skeleton)


def report(realized: Sequence[Realized], skeleton: Skeleton) -> None:
    minutes = sum(each.motion.duration_s for each in realized) / 60
    print(f"{len(realized)} lines, {minutes:.1f} minutes")
    for lexeme in ("LOOK", "GLANCE"):
        asides = [each for line in realized for each in looks(line, lexeme)]
        print(
            f"{lexeme}s aside: {len(asides) / minutes:.1f} a minute, {_spread([_seconds(each) for each in asides])} s"
        )
    blinks = sum(each.lexeme == "BLINK" for line in realized for each in line.schedule.behaviors)
    print(f"blinks: {blinks / minutes:.1f} a minute")
    for name, joint in (("head", "head"), ("line of sight", "leftEye")):
        sizes = [size for line in realized for size in sizes_degrees(line, skeleton, joint)]
        print(f"the {name} goes aside in a look by {_spread(sizes)} degrees")
    angles = np.median([head_sd_degrees(line, skeleton) for line in realized], axis=0)
    print("head, sd of pitch, yaw and roll in a line, degrees: " + ", ".join(f"{each:.1f}" for each in angles))
    for name, during in (("first 3 s", (0.0, START_S)), ("middle", (START_S, -END_S)), ("last second", (-END_S, 0.0))):
        speeds = [speed for line in realized for speed in speeds_degrees_s(line, skeleton, *during)]
        print(f"head speed, {name}: mean {np.mean(speeds):.1f}, p50 {np.median(speeds):.1f} degrees/s")


def looks(line: Realized, lexeme: str) -> Iterator[Behavior]:
    """The gazes of this lexeme that go aside."""
    for each in line.schedule.behaviors:
        if each.kind is Channel.GAZE and each.lexeme == lexeme and each.direction is not None:
            yield each


def sizes_degrees(line: Realized, skeleton: Skeleton, joint: str) -> Iterator[float]:
    """How far the joint turns from where it was, in each look."""
    turned, rate_hz = orientations(line, skeleton, joint), line.motion.frame_rate_hz
    for look in looks(line, "LOOK"):
        first, last = (round(at_s * rate_hz) for at_s in (look.sync.start, look.sync.end))
        during = turned[min(first, len(turned) - 1) : last + 1]
        yield float(np.degrees(angle_between(during, during[0]).max()))


def head_sd_degrees(line: Realized, skeleton: Skeleton) -> FloatArray:
    """Of pitch, yaw and roll (3,)."""
    return np.asarray(np.degrees(np.std(to_pitch_yaw_roll(orientations(line, skeleton, "head")), axis=1)))


def speeds_degrees_s(line: Realized, skeleton: Skeleton, from_s: float, to_s: float) -> FloatArray:
    """The head's speeds (T,) between two times, counted from the line's end where they are negative or it."""
    turned, rate_hz = orientations(line, skeleton, "head"), line.motion.frame_rate_hz
    speeds = np.degrees(angle_between(turned[1:], turned[:-1])) * rate_hz
    end = round(line.schedule.duration_s * rate_hz)
    first = round(from_s * rate_hz) + (end if from_s < 0 else 0)
    last = round(to_s * rate_hz) + (end if to_s <= 0 else 0)
    return np.asarray(speeds[max(first, 0) : max(last, 0)])


def orientations(line: Realized, skeleton: Skeleton, joint: str) -> FloatArray:
    """Of a joint in the world (T, 4)."""
    body = line.motion.body
    _at_m, turned = forward(skeleton, body.rotations, body.hips_m)
    return np.asarray(turned[:, skeleton.index[joint]])


def _seconds(look: Behavior) -> float:
    return look.sync.end - look.sync.start


def _spread(values: Sequence[float]) -> str:
    p10, p50, p90 = np.percentile(values, (10, 50, 90)) if values else (0.0, 0.0, 0.0)
    return f"median {p50:.1f} ({p10:.1f} to {p90:.1f})"


if __name__ == "__main__":
    main()

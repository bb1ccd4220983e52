"""Effects of physics on motion: whether the body stands, the deviation from the target motion, overshoot of wrists.

    python -m benchmarks.realizer.physics [--every N] [--characters NAME …]

Every line of `benchmarks.realizer.liveliness` by each character, with and without physics, at 60 frames a second.
Errors are root mean squares of the angle between both motions, by joint, and of the distance of the wrists. A wrist
arrives where, without physics, it slows down below .1 m/s after a peak above .6 m/s; what it overshoots is how far it
goes on, within .4 s, in the direction in which it came, beyond where it arrives; the hand's swing is its largest angle
from what was asked in that time. The lag is the shift at which the wrists' speeds agree best. Soles slide in the
simulation, not in the motion, whose feet stay where they are. Speed is processor time of physics alone against the
line's duration.
"""

import argparse
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.realizer.liveliness import recorded_lines
from understudy.model import FloatArray
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import realize, schedule_of
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import SIDES, Skeleton, forward
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.physics.course import course_of
from understudy.realizer.physics.physical_body import physical_body
from understudy.realizer.physics.simulation import simulate
from understudy.realizer.physics.tracking import with_physics
from understudy.settings import Settings

RATE_HZ = 60
FAST_M_S, ARRIVED_M_S, WINDOW_S = 0.6, 0.1, 0.4
JOINTS = ("hips", "chest", "head", "UpperArm", "LowerArm", "Hand")


@dataclass(frozen=True, slots=True, eq=False)
class Tracked:
    """A line's motion without and with physics, how long physics took, and whether the body fell."""

    skeleton: Skeleton
    asked: BodyMotion
    made: BodyMotion
    took_s: float
    fell: bool


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--every", type=int, default=1)
    arguments.add_argument("--characters", nargs="+", default=["default", "expansive", "formal_elder", "reserved"])
    options = arguments.parse_args()
    for character in options.characters:
        report(character, list(tracked_lines(character, options.every)))


def tracked_lines(character: str, every: int) -> Iterator[Tracked]:
    with Understudy.load(Settings()) as understudy:
        for line in list(recorded_lines().values())[::every]:
            schedule = schedule_of(perform(understudy, line, Options(character=character)))
            yield tracked(
                understudy.realizer.performer(character).skeleton, realize(understudy.realizer, schedule).body
            )


def tracked(skeleton: Skeleton, asked: BodyMotion) -> Tracked:
    begun_s = time.process_time()
    made, told = with_physics(skeleton, asked)
    return Tracked(skeleton, asked, made, time.process_time() - begun_s, bool(told))


def report(character: str, lines: Sequence[Tracked]) -> None:
    long_s = sum(float(each.asked.times_s[-1]) for each in lines)
    took_s = sum(each.took_s for each in lines)
    print(f"{character}: {len(lines)} lines, {long_s:.0f} s; fell: {sum(each.fell for each in lines)}")
    print(f"  {long_s / took_s:.0f} × real time, the slowest line {min(map(_speed, lines)):.0f} ×")
    errors = {name: np.concatenate([degrees(each, name) for each in lines]) for name in JOINTS}
    told = ", ".join(f"{name} {_rms(error):.1f} ({error.max():.0f})" for name, error in errors.items())
    print(f"  error, degrees rms (largest): {told}")
    wrists_cm = np.concatenate([100 * np.linalg.norm(b - a, axis=-1).ravel() for a, b in map(wrists_m, lines)])
    print(f"  wrists: {_rms(wrists_cm):.1f} cm rms, {wrists_cm.max():.1f} at most; lag {_lag_ms(lines):.0f} ms")
    found = np.array([each for line in lines for each in arrivals(line)])
    quarters = np.percentile(found, (50, 90), axis=0)
    asked, made, swing = (f"{middle:.2f} ({large:.2f})" for middle, large in quarters.T)
    print(f"  {len(found)} arrivals, median (p90): overshoot {made} cm, as asked {asked} cm; hand's swing {swing}°")
    print(f"  soles slide {1000 * max(slides_m(each) for each in lines[::8]):.2f} mm at most (in every eighth line)")


def degrees(line: Tracked, joint: str) -> FloatArray:
    """How far the joint, or both sides' joints, are from what was asked (N,)."""
    names = [side + joint for side in SIDES] if joint[0].isupper() else [joint]
    rows = line.skeleton.chain(*names)
    return np.degrees(angle_between(line.made.rotations[:, rows], line.asked.rotations[:, rows])).ravel()


def wrists_m(line: Tracked) -> tuple[FloatArray, FloatArray]:
    """The wrists (T, 2, 3) in the space of the hips, as asked and as made."""
    rows = line.skeleton.chain(*(side + "Hand" for side in SIDES))
    asked, made = (
        forward(line.skeleton, body.rotations, body.hips_m)[0][:, rows] - body.hips_m[:, None]
        for body in (line.asked, line.made)
    )
    return asked, made


def arrivals(line: Tracked) -> Iterator[tuple[float, float, float]]:
    """For each arrival of a wrist: the overshoot in cm as asked and as made, and the hand's swing in degrees."""
    asked_m, made_m = wrists_m(line)
    window = round(WINDOW_S * RATE_HZ)
    for side in range(len(SIDES)):
        swing = degrees(line, "Hand").reshape(-1, 2)[:, side]
        speed = np.linalg.norm(np.gradient(asked_m[:, side], 1 / RATE_HZ, axis=0), axis=1)
        for peak, arrived in _slowing(speed):
            way = asked_m[arrived, side] - asked_m[peak, side]
            way /= np.linalg.norm(way)
            after = slice(arrived, arrived + window)
            beyond = [float(((each[after, side] - asked_m[arrived, side]) @ way).max()) for each in (asked_m, made_m)]
            yield 100 * beyond[0], 100 * beyond[1], float(swing[after].max())


def _slowing(speed: FloatArray) -> Iterator[tuple[int, int]]:
    """The frames of peaks of speed and of the arrivals after them."""
    peak = 0
    for frame, now in enumerate(speed):
        if now > FAST_M_S and (not peak or now > speed[peak]):
            peak = frame
        elif now < ARRIVED_M_S and peak:
            yield peak, frame
            peak = 0


def _lag_ms(lines: Sequence[Tracked]) -> float:
    """By how much wrists are later than asked: at the best correlation of speeds, between frames by a parabola."""
    shifts = np.arange(-6, 7)
    total = np.zeros(len(shifts))
    for line in lines:
        asked, made = (np.linalg.norm(np.diff(each, axis=0), axis=-1) for each in wrists_m(line))
        total += [float((asked[6:-6] * np.roll(made, -shift, axis=0)[6:-6]).sum()) for shift in shifts]
    best = int(np.clip(np.argmax(total), 1, len(shifts) - 2))
    before, at, after = total[best - 1 : best + 2]
    return float(1000 / RATE_HZ * (shifts[best] + (before - after) / (2 * (before - 2 * at + after))))


def slides_m(line: Tracked) -> float:
    """How far a foot of the simulated body moves on the floor, at most."""
    physical = physical_body(line.skeleton)
    course = course_of(physical, line.skeleton, line.asked)
    return simulate(physical, course).slide_m


def _speed(line: Tracked) -> float:
    return float(line.asked.times_s[-1]) / line.took_s


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2)))


if __name__ == "__main__":
    main()

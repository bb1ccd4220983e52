"""The body without its gestures: whether it freezes, feet slide, eyes miss, joints jump or nods are late.

    python -m benchmarks.realizer.controllers [--lines N] [--character NAME] [--seed N] [--rate HZ]

Schedules are those of the first N texts of ../shared/data/functions/dev.jsonl with made-up times
(`benchmarks.bml.schedule`), each realized by idle, gaze and head as `understudy.realizer.realizing` has them, without
arms.
"""

import argparse
import json
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from benchmarks.bml.schedule import TEXTS, Stages, outcome
from understudy.model import Channel, FloatArray, Schedule
from understudy.realizer.body.limits import violations
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import (
    angle_between,
    inverse,
    multiply,
    rotate,
    shortest_rotation,
    to_pitch_yaw_roll,
)
from understudy.realizer.head_and_gaze.gaze import EYES, SIDEWAYS_LIMIT, UPRIGHT_LIMIT, apply_gaze
from understudy.realizer.head_and_gaze.gaze_targets import LISTENER_M
from understudy.realizer.head_and_gaze.head import apply_head_movements
from understudy.realizer.torso.idle import idle_motion

BODY = Skeleton.standing()
AHEAD = np.array([0.0, 0.0, 1.0])
SETTLED_S = 0.3
"""A gaze this long over, and no other begun, leaves the eyes on the listener."""

FROZEN_DEGREES_S = 0.01
NODS = frozenset({"NOD", "TILT_LEFT_NOD", "TILT_RIGHT_NOD"})


@dataclass(frozen=True, slots=True)
class Found:
    """What was measured of a line; each array has an entry a frame, nod or joint."""

    frozen_frames: int
    slide_mm: float
    missed_degrees: FloatArray
    joint_speeds: FloatArray
    eye_speed: float
    beyond_limits: int
    nods_late_ms: FloatArray
    spent_ms: dict[str, float]
    duration_s: float


def realized(schedule: Schedule, times_s: FloatArray, seed: int) -> tuple[BodyMotion, BodyMotion, dict[str, float]]:
    """The motion before and after the head's movements, and the time of each controller."""
    spent_ms: dict[str, float] = {}

    def clocked(name: str, make: Callable[[], BodyMotion]) -> BodyMotion:
        start_s = time.process_time()
        body = make()
        spent_ms[name] = 1000 * (time.process_time() - start_s)
        return body

    still = clocked("idle", lambda: idle_motion(BODY, times_s, schedule, seed=seed))
    gazing = clocked("gaze", lambda: apply_gaze(BODY, still, schedule, seed=seed)[0])
    return gazing, clocked("head", lambda: apply_head_movements(BODY, gazing.copy(), schedule, seed=seed)), spent_ms


def measure(schedule: Schedule, *, rate_hz: int, seed: int) -> Found:
    times_s = np.arange(int(schedule.duration_s * rate_hz)) / rate_hz
    gazing, body, spent_ms = realized(schedule, times_s, seed)
    places_m, turned = forward(BODY, body.rotations, body.hips_m)
    speeds = angle_between(body.rotations[1:], body.rotations[:-1]) * rate_hz
    eyes = BODY.chain(*EYES)
    others = [joint for joint in range(len(BODY.names)) if joint not in eyes]
    feet_m = places_m[:, BODY.chain("leftFoot", "rightFoot", "leftToes", "rightToes")]
    lines, ways = rotate(turned[:, eyes], AHEAD), np.array(LISTENER_M) - places_m[:, eyes]
    missed = np.degrees(2 * np.arccos(np.clip(shortest_rotation(lines, ways)[..., 3], -1, 1))).max(axis=1)
    return Found(
        frozen_frames=int(np.sum(np.degrees(speeds[:, others]).max(axis=1) < FROZEN_DEGREES_S)),
        slide_mm=1000 * float(np.abs(feet_m - feet_m[0]).max()),
        missed_degrees=missed[on_listener(schedule, times_s)],
        joint_speeds=speeds[:, others].max(axis=0),
        eye_speed=float(speeds[:, eyes].max()),
        beyond_limits=beyond_limits(body),
        nods_late_ms=np.array(list(nods_late_ms(schedule, gazing, body))),
        spent_ms=spent_ms,
        duration_s=schedule.duration_s,
    )


def on_listener(schedule: Schedule, times_s: FloatArray) -> FloatArray:
    """The frames in which every gaze is long over."""
    free = np.ones(len(times_s), dtype=bool)
    for behavior in schedule.behaviors:
        if behavior.kept and behavior.kind is Channel.GAZE:
            free &= (times_s < behavior.sync.start) | (times_s > behavior.sync.end + SETTLED_S)
    return free


def beyond_limits(body: BodyMotion) -> int:
    """Frames in which a joint or an eye is turned farther than it can be."""
    pitch, yaw, _roll = to_pitch_yaw_roll(body.rotations[:, BODY.chain(*EYES)])
    eyes = (np.abs(pitch) > UPRIGHT_LIMIT + 1e-6) | (np.abs(yaw) > SIDEWAYS_LIMIT + 1e-6)
    return int(np.sum((violations(BODY, body.rotations) > 0).any(axis=1) | eyes.any(axis=1)))


def nods_late_ms(schedule: Schedule, gazing: BodyMotion, body: BodyMotion) -> Iterator[float]:
    """How long after its stroke the head is lowest, of each single nod, by what the head's movements add."""
    added = np.zeros(len(body.times_s))
    for joint in BODY.chain("neck", "head"):
        added += to_pitch_yaw_roll(multiply(inverse(gazing.rotations[:, joint]), body.rotations[:, joint]))[0]
    for behavior in schedule.behaviors:
        stroke_s = behavior.sync.stroke
        if not behavior.kept or behavior.lexeme not in NODS or behavior.repetitions != 1 or stroke_s is None:
            continue
        during = (body.times_s >= behavior.sync.start) & (body.times_s <= behavior.sync.end)
        if during.any():
            yield 1000 * (peak_s(body.times_s[during], added[during]) - stroke_s)


def peak_s(times_s: FloatArray, course: FloatArray) -> float:
    """When the course is highest, between the frames: at the top of the parabola through three of them."""
    top = int(np.clip(np.argmax(course), 1, len(course) - 2))
    before, at, after = course[top - 1 : top + 2]
    return float(times_s[top] + (times_s[1] - times_s[0]) * (before - after) / (2 * (before - 2 * at + after)))


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--lines", type=int, default=60)
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--rate", type=int, default=60)
    options = arguments.parse_args()
    stages = Stages.load(options.character)
    lines = TEXTS.read_text(encoding="utf-8").splitlines()[: options.lines]
    outcomes = [outcome(stages, json.loads(line)["text"], options.seed) for line in lines]
    schedules = [Schedule(each.behaviors, each.duration_s) for each in outcomes]
    report([measure(schedule, rate_hz=options.rate, seed=options.seed) for schedule in schedules])


def report(found: list[Found]) -> None:
    seconds = sum(each.duration_s for each in found)
    missed = np.concatenate([each.missed_degrees for each in found])
    late = np.abs(np.concatenate([each.nods_late_ms for each in found]))
    speeds = np.max([each.joint_speeds for each in found], axis=0)
    others = [name for name in BODY.names if name not in EYES]
    fastest = sorted(zip(speeds, others, strict=True), reverse=True)[:4]
    print(f"{len(found)} lines, {seconds:.0f} s")
    print(f"frames in which nothing but the eyes moves: {sum(each.frozen_frames for each in found)}")
    print(f"feet slide at most: {max(each.slide_mm for each in found):.6f} mm")
    print(f"eyes miss the listener by: median {np.median(missed):.2f}, worst {missed.max():.2f} degrees")
    print(f"frames in which a joint or an eye is beyond its limits: {sum(each.beyond_limits for each in found)}")
    print(f"nods are lowest off their stroke by: median {np.median(late):.0f}, worst {late.max():.0f} ms ({len(late)})")
    print(f"fastest: eyes {max(each.eye_speed for each in found):.1f} rad/s,", end=" ")
    print(", ".join(f"{name} {speed:.1f}" for speed, name in fastest))
    for controller in found[0].spent_ms:
        spent_ms = sum(each.spent_ms[controller] for each in found)
        print(f"{controller}: {spent_ms / seconds:.2f} ms of processor time a second of motion")


if __name__ == "__main__":
    main()

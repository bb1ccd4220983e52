"""The bars of the realizer: whether motion resembles people's, is on time, complete and fast.

    python -m benchmarks.realizer.motion [--sentences N] [--lines FOLDER] [--fps 30|60] [--character NAME]
    python -m benchmarks.realizer.motion --minutes 10

The schedules are those of recorded lines (default: ../shared/data/speech/lines, NAME.flac with NAME.txt) and of N
sentences of GUM with made-up times (`benchmarks.bml.schedule`). Wrists are measured in the space of the world as
shared/motion.md measures people (`benchmarks.realizer.wrist_measures`). `--minutes` realizes one long schedule of so
many minutes instead, and prints its time and the most memory the process ever held. Speed is processor time on one
core, which other work on the machine does not lengthen much: set OMP_NUM_THREADS=1.

People, for the speed histogram: the hands of storytellers (../shared/data/motion/gesture-phases), whose unit is scaled
so that head and spine are as far apart as the mannequin's.
"""

import argparse
import csv
import resource
import statistics
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from itertools import chain, combinations, islice
from multiprocessing import get_context
from pathlib import Path

import numpy as np

from benchmarks.bml.schedule import Stages, performed, spoken_sentences
from benchmarks.realizer.wrist_measures import WristMeasures, hellinger, measured, together
from understudy.model import Channel, FloatArray, Hand, Interval, Line, Performance, Schedule, Viseme
from understudy.models import Understudy, load_realizer
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import Realizer, realize, schedule_of
from understudy.realizer.arms.arm_keys import arm_track
from understudy.realizer.arms.posing import wrist_of
from understudy.realizer.body.contacts import penetrations_m
from understudy.realizer.body.limits import violations
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import Skeleton, arm_joints, forward
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.gestures.gesture_plan import GesturePlan
from understudy.realizer.realizing import frame_times_s
from understudy.realizer.scheduling.gesture_controller import apply_gestures
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.torso.idle import idle_motion
from understudy.settings import Settings

SHARED = Path(__file__).resolve().parents[3] / "shared" / "data"
LINES = SHARED / "speech" / "lines"
PEOPLE = SHARED / "motion" / "gesture-phases"
WRISTS = ("leftHand", "rightHand")
EYES = frozenset({"leftEye", "rightEye"})
MILLISECONDS = 1000.0
FROZEN_RAD, FROZEN_WEIGHT = 1e-6, 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Realized:
    """A schedule, its motion, and the seconds of processor time it took."""

    schedule: Schedule
    motion: Motion
    took_s: float


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--sentences", type=int, default=200)
    arguments.add_argument("--lines", type=Path, default=LINES)
    arguments.add_argument("--fps", type=int, choices=(30, 60), default=60)
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--minutes", type=float, default=0.0)
    options = arguments.parse_args()
    if options.minutes:
        report_long(long_schedule(options.character, options.sentences, options.minutes), options.fps)
        return
    realizer = load_realizer()
    sentences = islice(of_sentences(options.character), options.sentences)
    schedules = [schedule_of(each) for each in chain(of_lines(options.lines, options.character), sentences)]
    realized_once(realizer, schedules[0], options.fps)
    realized = [realized_once(realizer, each, options.fps) for each in schedules]
    report(realized, realizer.performer(options.character).skeleton)
    report_keys(realizer, realized)


def realized_once(realizer: Realizer, schedule: Schedule, frame_rate_hz: int) -> Realized:
    begun_s = time.process_time()
    motion = realize(realizer, schedule, frame_rate_hz=frame_rate_hz)
    return Realized(schedule, motion, time.process_time() - begun_s)


def of_lines(folder: Path, character: str) -> Iterator[Performance]:
    with Understudy.load(Settings()) as understudy:
        for path in sorted(folder.glob("*.flac")):
            yield perform(
                understudy, Line(path.read_bytes(), path.with_suffix(".txt").read_text()), Options(character=character)
            )


def of_sentences(character: str) -> Iterator[Performance]:
    stages = Stages.load(character)
    return (performed(stages, text, seed=0) for text in spoken_sentences() if len(text.split()) > 3)


def long_schedule(character: str, sentences: int, minutes: float) -> Schedule:
    """Made in a process of its own, so that parser and rules are not in the memory that is measured."""
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as elsewhere:
        return elsewhere.submit(_long_schedule, character, sentences, minutes).result()


def _long_schedule(character: str, sentences: int, minutes: float) -> Schedule:
    return joined(list(islice(of_sentences(character), sentences)), 60 * minutes)


def joined(performances: Sequence[Performance], duration_s: float) -> Schedule:
    """The performances one after the other, again and again, until `duration_s`."""
    parts: list[Schedule] = []
    at_s = 0.0
    while at_s < duration_s:
        part = shifted(schedule_of(performances[len(parts) % len(performances)]), at_s, len(parts))
        parts.append(part)
        at_s = part.duration_s
    return replace(
        parts[0],
        behaviors=tuple(chain.from_iterable(part.behaviors for part in parts)),
        visemes=tuple(chain.from_iterable(part.visemes for part in parts)),
        phrases=tuple(chain.from_iterable(part.phrases for part in parts)),
        emphases_s=tuple(chain.from_iterable(part.emphases_s for part in parts)),
        words=(),
        duration_s=at_s,
    )


def shifted(schedule: Schedule, by_s: float, number: int) -> Schedule:
    return replace(
        schedule,
        behaviors=tuple(replace(b, id=f"{b.id}.{number}", sync=b.sync.shifted(by_s)) for b in schedule.behaviors),
        visemes=tuple(_later_viseme(viseme, by_s) for viseme in schedule.visemes),
        phrases=tuple(_later(phrase, by_s) for phrase in schedule.phrases),
        emphases_s=tuple(time_s + by_s for time_s in schedule.emphases_s),
        duration_s=schedule.duration_s + by_s,
    )


def _later_viseme(viseme: Viseme, by_s: float) -> Viseme:
    return replace(viseme, interval=_later(viseme.interval, by_s))


def _later(interval: Interval, by_s: float) -> Interval:
    return Interval(interval.start_s + by_s, interval.end_s + by_s)


def report(realized: Sequence[Realized], skeleton: Skeleton) -> None:
    minutes = sum(each.motion.duration_s for each in realized) / 60
    gestures = sum(b.kind is Channel.GESTURE for each in realized for b in each.schedule.behaviors)
    actions = Counter(d.action for each in realized for d in each.motion.decisions)
    print(f"{len(realized)} schedules, {minutes:.1f} minutes, {gestures} gestures asked for")
    print("decisions: " + ", ".join(f"{action} {count}" for action, count in actions.most_common()))
    report_strokes(realized)
    wrists = together([measure for each in realized for measure in wrists_of(each.motion, skeleton)])
    report_wrists(wrists)
    report_people(wrists)
    report_soundness(realized, skeleton)
    report_speed(realized)


def report_strokes(realized: Sequence[Realized]) -> None:
    """How far the strokes that are played fall from their times in the BML."""
    pairs = [
        (each.motion.realized[b.id].stroke, b.sync.stroke)
        for each in realized
        for b in each.schedule.behaviors
        if b.kind is Channel.GESTURE and b.id in each.motion.realized
    ]
    errors_ms = [1000 * abs(one - other) for one, other in pairs if one is not None and other is not None]
    print(f"strokes played: {len(errors_ms)}", end="; ")
    print(f"from their BML time: mean {np.mean(errors_ms):.1f}, most {max(errors_ms):.1f} ms")


def report_keys(realizer: Realizer, realized: Sequence[Realized]) -> None:
    """How far wrists are from where the marked key poses of strokes have them, at the very time of each."""
    off_m = np.array([off for each in realized for off in off_keys_m(realizer, each.schedule)])
    figures = np.percentile(off_m, (50, 90, 100)) * 100
    print(f"wrists off their marked keys, at their times: median {figures[0]:.2f}, p90 {figures[1]:.2f}", end=", ")
    print(f"most {figures[2]:.2f} cm, of {len(off_m)}")


def _planned(realizer: Realizer, schedule: Schedule) -> GesturePlan:
    performer = realizer.performer(schedule.character)
    return plan_gestures(performer.library, schedule, seed=0, leading=performer.leading, style=performer.style)


def off_keys_m(realizer: Realizer, schedule: Schedule) -> Iterator[float]:
    """Of one schedule, at 60 frames a second; arms smoothed as they are played, before anything collides."""
    performer = realizer.performer(schedule.character)
    skeleton, plan = performer.skeleton, _planned(realizer, schedule)
    times_s = frame_times_s(schedule.duration_s, 60)
    body = apply_gestures(skeleton, idle_motion(skeleton, times_s, schedule, seed=0), plan, seed=0)
    for side in (Hand.LEFT, Hand.RIGHT):
        wrist_m = wrist_of(skeleton, side, body.rotations[:, skeleton.chain(*arm_joints(side))])
        for key in arm_track(skeleton, side, plan).keys:
            if key.marked and key.pose.wrist_m is not None:
                at_m = [np.interp(key.time_s, times_s, wrist_m[:, axis]) for axis in range(3)]
                yield float(np.linalg.norm(np.array(at_m) - key.pose.wrist_m))


def wrists_of(motion: Motion, skeleton: Skeleton) -> Iterator[WristMeasures]:
    positions_m, _turns = forward(skeleton, motion.body.rotations, motion.body.hips_m)
    for wrist in WRISTS:
        yield measured(positions_m[:, skeleton.index[wrist]], motion.frame_rate_hz)


def report_wrists(wrists: WristMeasures) -> None:
    speed = np.percentile(wrists.speed_m_s, (50, 95, 99))
    print(
        f"wrist speed: mean {wrists.speed_m_s.mean():.2f}, p50 {speed[0]:.2f}, p95 {speed[1]:.2f}, p99 {speed[2]:.2f}, "
        f"most {wrists.speed_m_s.max():.2f} m/s (bands: p99 2.0, never above 3.0)"
    )
    print(f"acceleration p95: {np.percentile(wrists.acceleration_m_s2, 95):.1f} m/s² (band: 10)")
    print(f"jerk mean {wrists.jerk_m_s3.mean():.0f}, p99 {np.percentile(wrists.jerk_m_s3, 99):.0f} m/s³ (band: 200)")


def report_people(wrists: WristMeasures) -> None:
    """How unlike our speeds are to storytellers', and theirs to each other's, over frames in which hands move."""
    if not PEOPLE.is_dir():
        print("speed histogram: no ../shared, nobody to compare with")
        return
    people = {path.stem: people_m_s(path) for path in sorted(PEOPLE.glob("*_raw.csv"))}
    ours = [hellinger(wrists.speed_m_s, speeds) for speeds in people.values()]
    theirs = [hellinger(people[one], people[other]) for one, other in combinations(people, 2)]
    print(f"Hellinger distance of wrist speeds to {len(people)} storytellers: {_spread(ours)}", end="; ")
    print(f"among them: {_spread(theirs)}")


def _spread(distances: Sequence[float]) -> str:
    return f"mean {np.mean(distances):.2f} ({min(distances):.2f} to {max(distances):.2f})"


def people_m_s(path: Path) -> FloatArray:
    """The speeds of both wrists of a storyteller, 30 frames a second."""
    with path.open() as file:
        rows = list(csv.DictReader(file))
    tracks = {
        name: np.array([[float(row[name + axis]) for axis in "xyz"] for row in rows]) for name in ("lw", "rw", "h", "s")
    }
    skeleton = Skeleton.standing()
    spine_to_head_m = float(
        sum(skeleton.offsets_m[skeleton.index[name], 1] for name in ("chest", "upperChest", "neck", "head"))
    )
    metre = spine_to_head_m / float(np.median(np.linalg.norm(tracks["h"] - tracks["s"], axis=-1)))
    times_s = np.array([int(row["timestamp"]) for row in rows]) / MILLISECONDS
    even_s = np.arange(times_s[0], times_s[-1], 1 / 30)
    measures = []
    for name in ("lw", "rw"):
        path_m = np.stack([np.interp(even_s, times_s, metre * tracks[name][:, axis]) for axis in range(3)], axis=-1)
        measures.append(measured(path_m, 30))
    return together(measures).speed_m_s


def report_soundness(realized: Sequence[Realized], skeleton: Skeleton) -> None:
    jumps = [jump for each in realized for jump in velocity_jumps(each.motion, skeleton)]
    frozen = sum(frozen_frames(each.motion) for each in realized)
    outside = sum(int(np.count_nonzero(violations(skeleton, each.motion.body.rotations))) for each in realized)
    deep_m = [
        float(np.max(penetrations_m(skeleton, each.motion.body.rotations, each.motion.body.hips_m)))
        for each in realized
    ]
    print(f"joint velocity jumps from frame to frame: most {max(jumps):.1f} rad/s (bar: 20)")
    print(f"joint limit violations: {outside}; hands or forearms inside the body: {100 * max(deep_m):.1f} cm at most")
    print(f"frames in which nothing moves: {frozen}")


def velocity_jumps(motion: Motion, skeleton: Skeleton) -> FloatArray:
    """By how much the angular velocity of any joint but the eyes changes between frames, the most of each frame."""
    joints = [joint for joint, name in enumerate(skeleton.names) if name not in EYES]
    rotations = motion.body.rotations[:, joints]
    speeds = angle_between(rotations[:-1], rotations[1:]) * motion.frame_rate_hz
    return np.asarray(np.abs(np.diff(speeds, axis=0)).max(axis=-1))


def frozen_frames(motion: Motion) -> int:
    turned = angle_between(motion.body.rotations[:-1], motion.body.rotations[1:]).max(axis=-1)
    changed = np.abs(np.diff(motion.shapes, axis=0)).max(axis=-1)
    return int(np.sum((turned < FROZEN_RAD) & (changed < FROZEN_WEIGHT)))


def report_speed(realized: Sequence[Realized]) -> None:
    rates = [each.motion.duration_s / each.took_s for each in realized]
    whole = sum(each.motion.duration_s for each in realized) / sum(each.took_s for each in realized)
    print(f"speed: {whole:.0f} × real time over all, median of the lines {statistics.median(rates):.0f} ×")


def report_long(schedule: Schedule, frame_rate_hz: int) -> None:
    realizer = load_realizer()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    found = realized_once(realizer, schedule, frame_rate_hz)
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(
        f"{found.motion.duration_s / 60:.1f} minutes at {frame_rate_hz} frames a second: {found.took_s:.1f} s", end=", "
    )
    print(f"{found.motion.duration_s / found.took_s:.0f} × real time")
    print(f"memory: {before / 1024:.0f} MB before, {most / 1024:.0f} MB at most (bar: 600)")


if __name__ == "__main__":
    main()

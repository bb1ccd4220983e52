"""Path length of a talker's head: ours against storytellers', filmed with a Kinect and labelled by hand.

    python -m benchmarks.realizer.head_and_gaze.head_paths [--lines N] [--seed N] [--gestures]

The people are those of ../shared/data/motion/gesture-phases/ (a1, a2, a3, b3; b1 was at rest half the time with no
measured movement at all). Their x and y have no unit: metres follow from the height of the head over the spine's
middle, `HEAD_OVER_SPINE_M` in ours, where it is more than a metre in theirs. Paths are smoothed at 2 Hz, 30 frames a
second. Ours are the first N texts of ../shared/data/functions/dev.jsonl, one after another, with made-up times.
"""

import argparse
import csv
import json
from dataclasses import replace
from itertools import accumulate

import numpy as np
from scipy.signal import butter, filtfilt

from benchmarks.bml.schedule import TEXTS, Stages, outcome
from understudy.files import resource_folder
from understudy.model import FloatArray, Schedule
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.gestures.library import Library
from understudy.realizer.head_and_gaze.gaze import apply_gaze
from understudy.realizer.head_and_gaze.head import apply_head_movements
from understudy.realizer.scheduling.gesture_controller import apply_gestures
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.torso.idle import idle_motion

PEOPLE = TEXTS.parents[1] / "motion" / "gesture-phases"
RATE_HZ = 30
HEAD_OVER_SPINE_M = 0.5


def speeds_m_s(path_m: FloatArray) -> FloatArray:
    """Of a path (T, 3), smoothed."""
    smooth = filtfilt(*butter(3, 2.0 / (RATE_HZ / 2)), path_m, axis=0)
    return np.asarray(np.linalg.norm(np.diff(smooth, axis=0), axis=1) * RATE_HZ)


def filmed_m(name: str) -> FloatArray:
    """The path of a storyteller's head (T, 3)."""
    with (PEOPLE / f"{name}_raw.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    times_s = np.array([float(row["timestamp"]) for row in rows]) / 1000
    head_at, spine = (np.array([[float(row[p + axis]) for axis in "xyz"] for row in rows]) for p in "hs")
    height = float(np.abs(np.median(head_at[:, 1] - spine[:, 1])))
    head_at[:, :2] *= HEAD_OVER_SPINE_M / height if height > 1 else 1.0
    frames_s = np.arange(times_s[0], times_s[-1], 1 / RATE_HZ)
    return np.stack([np.interp(frames_s, times_s, head_at[:, axis]) for axis in range(3)], axis=1)


def ours_m(lines: int, seed: int, *, gestures: bool) -> FloatArray:
    """The path between our eyes (T, 3)."""
    stages, skeleton = Stages.load("default"), Skeleton.standing()
    texts = [json.loads(line)["text"] for line in TEXTS.read_text(encoding="utf-8").splitlines()[:lines]]
    outcomes = [outcome(stages, text, seed) for text in texts]
    starts_s = accumulate((each.duration_s for each in outcomes), initial=0.0)
    behaviors = tuple(
        replace(behavior, id=f"{behavior.id}.{start_s:.3f}", sync=behavior.sync.shifted(start_s))
        for each, start_s in zip(outcomes, starts_s, strict=False)
        for behavior in each.behaviors
        if behavior.kept
    )
    schedule = Schedule(behaviors, sum(each.duration_s for each in outcomes))
    body = idle_motion(skeleton, np.arange(int(schedule.duration_s * RATE_HZ)) / RATE_HZ, schedule, seed=seed)
    if gestures:
        library = Library.load(resource_folder("lexicon") / "gestures")
        body = apply_gestures(skeleton, body, plan_gestures(library, schedule, seed=seed), seed=seed)
    body = apply_head_movements(skeleton, apply_gaze(skeleton, body, schedule, seed=seed)[0], schedule, seed=seed)
    places_m, _turned = forward(skeleton, body.rotations, body.hips_m)
    return np.asarray(places_m[:, skeleton.chain("leftEye", "rightEye")].mean(axis=1))


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--lines", type=int, default=14)
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--gestures", action="store_true")
    options = arguments.parse_args()
    paths = {"ours": ours_m(options.lines, options.seed, gestures=options.gestures)}
    paths |= {name: filmed_m(name) for name in ("a1", "a2", "a3", "b3")}
    print("m/s     mean   p50    p95")
    for name, path_m in paths.items():
        speed = speeds_m_s(path_m)
        print(f"{name:6}  {speed.mean():.3f}  {np.median(speed):.3f}  {np.percentile(speed, 95):.3f}")


if __name__ == "__main__":
    main()

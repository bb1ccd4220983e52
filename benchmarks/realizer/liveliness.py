"""Liveliness of our bodies compared with people's: both hands, bob and sway, the head over the trunk; and validity.

    python -m benchmarks.realizer.liveliness [--character NAME] [--seed N] [--recordings-only]

Ours are the directing dev lines with audio (../shared/directing/audio) and the six recordings of
../shared/data/speech/lines, performed and realized at 60 frames a second; people the five storytellers of
`benchmarks.realizer.storytellers`. Both go through the same code at 30 frames a second; figures are medians over lines,
and over storytellers (least to most).

Conventions: wrists in the space of the world, low-passed at 6 Hz (`wrist_measures`); a wrist moves above `MOVING_M_S`;
speed peaks are local maxima above `PEAK_M_S` of the busier wrist. Trunk is the joint `spine`, the Kinect's; standard
deviations are in windows of `WINDOW_S` that overlap by half, of shorter lines in one; sideways, up, forward in cm.
Two-handed strokes are those in which either wrist moves on average; their correlation is of the two speeds.
"""

import argparse
import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from benchmarks.realizer.motion import Realized, realized_once, report_soundness, report_wrists, wrists_of
from benchmarks.realizer.storytellers import RATE_HZ, Take, storytellers
from benchmarks.realizer.wrist_measures import measured, together
from understudy.model import Channel, FloatArray, Interval, Line
from understudy.models import Understudy, load_realizer
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import Realizer, schedule_of
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import angle_between
from understudy.settings import Settings

SHARED = Path(__file__).resolve().parents[3] / "shared"
DIRECTING, RECORDINGS = SHARED / "directing", SHARED / "data" / "speech" / "lines"
FRAME_RATE_HZ = 60
MOVING_M_S, PEAK_M_S = 0.1, 0.35
WINDOW_S = 7.0
SHORTEST_STROKE_S = 0.2

MEASURES = (
    ("both wrists of the moving time moving", ".50-.70"),
    ("faster wrist p90, m/s", ".9-1.3"),
    ("faster wrist p99, m/s", "1.4-2.0"),
    ("speed peaks > .35 m/s a minute, busier wrist", "75-150"),
    ("trunk, sd in 7 s windows, cm: sideways", ">= .65"),
    ("trunk: up", ">= .25"),
    ("trunk: forward", ">= .45"),
    ("head over trunk: sideways", ">= .7"),
    ("head over trunk: up", ">= .25"),
    ("head over trunk: forward", ">= 1.0"),
)


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--recordings-only", action="store_true")
    options = arguments.parse_args()
    lines = recorded_lines(recordings_only=options.recordings_only)
    realizer = load_realizer()
    realized = list(realized_lines(realizer, lines, options.character, options.seed))
    report(realized, realizer.performer(options.character).skeleton)


def recorded_lines(*, recordings_only: bool = False) -> dict[str, Line]:
    """The dev lines of directing that have audio, and the recordings, by name."""
    found = {
        path.stem: Line(path.read_bytes(), path.with_suffix(".txt").read_text())
        for path in sorted(RECORDINGS.glob("*.flac"))
    }
    if recordings_only:
        return found
    for row in map(json.loads, (DIRECTING / "dev-lines.jsonl").read_text().splitlines()):
        audio = DIRECTING / "audio" / f"{row['id']}.flac"
        if audio.is_file():
            found[row["id"]] = Line(audio.read_bytes(), " ".join(word.split(":", 1)[1] for word in row["words"]))
    return found


def realized_lines(realizer: Realizer, lines: Mapping[str, Line], character: str, seed: int) -> Iterator[Realized]:
    with Understudy.load(Settings()) as understudy:
        for line in lines.values():
            performance = perform(understudy, line, Options(character=character, seed=seed))
            yield realized_once(realizer, schedule_of(performance), FRAME_RATE_HZ)


def report(realized: Sequence[Realized], skeleton: Skeleton) -> None:
    takes = [take_of(each, skeleton) for each in realized]
    ours = np.array([measures([take]) for take in takes])
    people = storytellers()
    theirs = np.array([measures(each) for each in people.values()])
    print(f"{len(realized)} lines, {sum(each.motion.duration_s for each in realized) / 60:.1f} minutes")
    for column, (name, floor) in enumerate(MEASURES):
        median = np.nanmedian(ours[:, column])
        print(f"{name:46} ours {median:6.2f}  floor {floor:8} people {spread(theirs[:, column])}")
    report_correlations("ours", correlations(takes))
    report_correlations("people", [one for each in people.values() for one in correlations(each)])
    print(f"head speed in any frame: {max(head_speed_deg_s(each, skeleton) for each in realized):.0f} deg/s (<= 250)")
    report_wrists(together([measure for each in realized for measure in wrists_of(each.motion, skeleton)]))
    report_soundness(realized, skeleton)


def report_correlations(whose: str, values: Sequence[float]) -> None:
    told = ", ".join(f"p{share} {np.percentile(values, share):.2f}" for share in (10, 50, 90)) if values else "none"
    print(f"left/right speed correlation in {len(values)} two-handed strokes, {whose}: {told}")


def spread(values: FloatArray) -> str:
    return f"{np.median(values):.2f} ({values.min():.2f}-{values.max():.2f})" if len(values) else "-"


def take_of(realized: Realized, skeleton: Skeleton) -> Take:
    """Our motion as the storytellers' is."""
    body, motion = realized.motion.body, realized.motion
    step = FRAME_RATE_HZ // RATE_HZ
    at_m, _turned = forward(skeleton, body.rotations[::step], body.hips_m[::step])
    strokes = (
        motion.realized[each.id]
        for each in realized.schedule.behaviors
        if each.kind is Channel.GESTURE and each.id in motion.realized
    )
    known = tuple(
        Interval(sync.stroke_start, sync.stroke_end)
        for sync in strokes
        if sync.stroke_start is not None and sync.stroke_end is not None
    )
    left, right, head, trunk = (at_m[:, skeleton.index[name]] for name in ("leftHand", "rightHand", "head", "spine"))
    return Take(left, right, head, trunk, known)


def measures(takes: Sequence[Take]) -> list[float]:
    """One person's, or one line's, in the order of `MEASURES`."""
    left, right = (
        np.concatenate([measured(path_m, RATE_HZ).speed_m_s for path_m in paths])
        for paths in ([take.left_m for take in takes], [take.right_m for take in takes])
    )
    faster, slower = np.maximum(left, right), np.minimum(left, right)
    moving = faster > MOVING_M_S
    both = float(np.mean(slower[moving] > MOVING_M_S)) if moving.any() else float("nan")
    minutes = len(left) / RATE_HZ / 60
    peaks = max(peak_count(left), peak_count(right)) / minutes
    trunk = [sd for take in takes for sd in windowed_sd_cm(take.trunk_m)]
    head = [sd for take in takes for sd in windowed_sd_cm(take.head_m - take.trunk_m)]
    return [both, *np.percentile(faster, (90, 99)), peaks, *np.median(trunk, axis=0), *np.median(head, axis=0)]


def peak_count(speed_m_s: FloatArray) -> int:
    before, at, after = speed_m_s[:-2], speed_m_s[1:-1], speed_m_s[2:]
    return int(np.sum((at > PEAK_M_S) & (at >= before) & (at > after)))


def windowed_sd_cm(path_m: FloatArray) -> Iterator[FloatArray]:
    """The standard deviation (3,) in each window."""
    width = round(WINDOW_S * RATE_HZ)
    for first in range(0, max(1, len(path_m) - width + 1), width // 2):
        yield 100 * path_m[first : first + width].std(axis=0)


def correlations(takes: Sequence[Take]) -> list[float]:
    """Of the speeds of left and right wrist, in each two-handed stroke."""
    found = []
    for take in takes:
        speeds = [measured(path_m, RATE_HZ, edge_s=0).speed_m_s for path_m in (take.left_m, take.right_m)]
        for stroke in take.strokes:
            within = slice(round(stroke.start_s * RATE_HZ), round(stroke.end_s * RATE_HZ) + 1)
            left, right = (speed[within] for speed in speeds)
            if len(left) >= SHORTEST_STROKE_S * RATE_HZ and min(left.mean(), right.mean()) > MOVING_M_S:
                found.append(float(np.corrcoef(left, right)[0, 1]))
    return found


def head_speed_deg_s(realized: Realized, skeleton: Skeleton) -> float:
    """The fastest turn of the head in the space of the world, between two frames."""
    body = realized.motion.body
    _at_m, turned = forward(skeleton, body.rotations, body.hips_m)
    head = turned[:, skeleton.index["head"]]
    return float(np.degrees(angle_between(head[:-1], head[1:]).max()) * realized.motion.frame_rate_hz)


if __name__ == "__main__":
    main()

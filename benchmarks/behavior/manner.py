"""Whether movements are as big and as fast as directors would have them, by how the same words are said.

    python -m benchmarks.behavior.manner [--directing FOLDER] [--every N] [--output OUT]

Performs the recorded deliveries of the folder `deliveries` and realizes them. Of each delivery: the mean over its
strokes of the path length of the hand that leads, metres, and of its peak speed, metres a second, both of the wrist
against the hips. Printed is Kendall's tau of both with the directors' mean `size` and `speed`, and of the factors by
themselves, as the voice gives them. OUT takes ID.manner.json for the directors' own script.
"""

import argparse
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from scipy.stats import kendalltau

from benchmarks.behavior.deliveries import READERS
from benchmarks.figures import add_record_option, record
from benchmarks.realizer.motion import WRISTS
from understudy.model import Channel, Line, Performance
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import PreparedSchedule, realize_prepared
from understudy.realizer.body.skeleton import forward
from understudy.realizer.realizing import Realizer
from understudy.settings import Settings

SHARED = Path(__file__).resolve().parents[3] / "shared"
FRAME_RATE_HZ = 60
KINDS = {"amplitude": "size", "speed": "speed"}
"""What directors call each."""

RECORDED = {
    "amplitude": "manner: tau of the size, as the hands play it",
    "speed": "manner: tau of the speed, as the hands play it",
}
"""The names of the recorded figures."""


def strokes(performance: Performance, realizer: Realizer) -> Iterator[tuple[float, float]]:
    """Path length and peak speed of each stroke that is played; of two hands the one that goes farther."""
    realized = realize_prepared(realizer, PreparedSchedule.of(performance), frame_rate_hz=FRAME_RATE_HZ)
    motion, skeleton = realized.motion, realizer.skeleton
    positions_m, _turns = forward(skeleton, motion.body.rotations, motion.body.hips_m)
    ways = [positions_m[:, skeleton.index[wrist]] - motion.body.hips_m for wrist in WRISTS]
    for gesture in performance.behaviors:
        sync = motion.realized.get(gesture.id)
        if gesture.kind is not Channel.GESTURE or sync is None or sync.stroke_start is None or sync.stroke_end is None:
            continue
        begin_s = float(motion.body.times_s[0])
        first, last = (round((time_s - begin_s) * FRAME_RATE_HZ) for time_s in (sync.stroke_start, sync.stroke_end))
        steps = [np.linalg.norm(np.diff(way[max(first, 0) : last + 1], axis=0), axis=1) for way in ways]
        path = max(steps, key=lambda each: float(each.sum()))
        if len(path):
            yield float(path.sum()), float(path.max()) * FRAME_RATE_HZ


def of_delivery(understudy: Understudy, folder: Path, line: Mapping[str, Any]) -> dict[str, float]:
    """What the voice gives and what the hands do, each the mean over the strokes; without strokes the voice's alone."""
    text = " ".join(word.split(":", 1)[1] for word in line["words"])
    audio = (folder / "audio" / f"{line['id']}.flac").read_bytes()
    performance = perform(understudy, Line(audio, text), Options())
    manners = performance.utterance.manners
    figures = {
        "voice's amplitude": float(np.mean([manner.amplitude for manner in manners])),
        "voice's speed": float(np.mean([manner.speed for manner in manners])),
    }
    played = list(strokes(performance, understudy.realizer))
    if played:
        path_m, peak_m_s = np.mean(played, axis=0).tolist()
        figures |= {"amplitude": path_m, "speed": peak_m_s}
    return figures


def main() -> None:
    """Performs, realizes, prints."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--directing", type=Path, default=SHARED / "directing")
    parser.add_argument("--every", type=int, default=1, help="only every Nth delivery")
    parser.add_argument("--output", type=Path, help="folder that takes ID.manner.json")
    add_record_option(parser)
    options = parser.parse_args()
    folder = options.directing / "deliveries"
    lines = [json.loads(row) for row in (folder / "lines.jsonl").read_text(encoding="utf-8").splitlines()]
    with Understudy.load(Settings()) as understudy:
        told = {line["id"]: of_delivery(understudy, folder, line) for line in lines[:: options.every]}
    for name, manner in told.items() if options.output else ():
        (options.output / f"{name}.manner.json").write_text(json.dumps(manner), encoding="utf-8")
    readers = [_asked(folder / name) for name in READERS]
    for measure, kind in (*((name, name) for name in KINDS), *((f"voice's {name}", name) for name in KINDS)):
        names = [name for name in told if measure in told[name]]
        asked = [np.mean([reader[name].get(KINDS[kind], 0) for reader in readers]) for name in names]
        tau = kendalltau([told[name][measure] for name in names], asked)[0]
        print(f"{measure}: tau {tau:.3f} with the directors' {KINDS[kind]}, {len(names)} deliveries")
        if options.record and measure in RECORDED:
            record("choice", RECORDED[measure], tau, bar="≥ 0.35", aim="≥ 0.5")


def _asked(path: Path) -> dict[str, dict[str, float]]:
    """What a director asked of each delivery."""
    rows = map(json.loads, path.read_text(encoding="utf-8").splitlines())
    return {row["id"]: row.get("manner", {}) for row in rows}


if __name__ == "__main__":
    main()

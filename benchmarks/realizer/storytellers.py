"""The motion capture of five storytellers (../shared/data/motion/gesture-phases), in metres, 30 frames a second.

A Kinect filmed them: x and y have no unit, z is in metres. Metres across and up follow from the height of head over
spine, taken to be `HEAD_OVER_SPINE_M`, that of our `head` over our `spine`; one recording (b3), whose heights are below
a metre, is in metres already. Recordings are cut where the camera paused.
"""

import csv
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from understudy.model import FloatArray, Interval

FOLDER = Path(__file__).resolve().parents[3] / "shared" / "data" / "motion" / "gesture-phases"
RATE_HZ = 30
HEAD_OVER_SPINE_M = 0.5
PAUSE_S = 0.5
SHORTEST_S = 2.0
POINTS = ("lw", "rw", "h", "s")


@dataclass(frozen=True, slots=True, eq=False)
class Take:
    """A stretch of one person's motion, `RATE_HZ` frames a second: positions (T, 3) in metres, and the strokes in it
    in seconds from its first frame."""

    left_m: FloatArray
    right_m: FloatArray
    head_m: FloatArray
    trunk_m: FloatArray
    strokes: tuple[Interval, ...]


def storytellers() -> dict[str, list[Take]]:
    """The takes of each storyteller, by the name of the recording; empty without ../shared."""
    return {path.stem.removesuffix("_raw"): list(_takes(path)) for path in sorted(FOLDER.glob("*_raw.csv"))}


def _takes(path: Path) -> Iterator[Take]:
    with path.open(encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file))
    times_s = np.array([int(row["timestamp"]) for row in rows]) / 1000
    tracks = {name: np.array([[float(row[name + axis]) for axis in "xyz"] for row in rows]) for name in POINTS}
    height = float(np.median(np.abs(tracks["h"][:, 1] - tracks["s"][:, 1])))
    metre = HEAD_OVER_SPINE_M / height if height > 1 else 1.0
    in_stroke = np.array([row["phase"] == "Stroke" for row in rows])
    for part in np.split(np.arange(len(rows)), np.flatnonzero(np.diff(times_s) > PAUSE_S) + 1):
        even_s = np.arange(times_s[part[0]], times_s[part[-1]], 1 / RATE_HZ)
        if len(even_s) >= SHORTEST_S * RATE_HZ:
            scaled = {name: track[part] * [metre, metre, 1.0] for name, track in tracks.items()}
            at_m = {name: _evenly(even_s, times_s[part], track) for name, track in scaled.items()}
            strokes = tuple(_runs(times_s[part] - even_s[0], in_stroke[part]))
            yield Take(at_m["lw"], at_m["rw"], at_m["h"], at_m["s"], strokes)


def _evenly(even_s: FloatArray, times_s: FloatArray, track: FloatArray) -> FloatArray:
    return np.stack([np.interp(even_s, times_s, track[:, axis]) for axis in range(3)], axis=-1)


def _runs(times_s: FloatArray, inside: NDArray[np.bool_]) -> Iterator[Interval]:
    padded = np.concatenate([[False], inside, [False]])
    for first, past in np.flatnonzero(padded[1:] != padded[:-1]).reshape(-1, 2):
        yield Interval(float(times_s[first]), float(times_s[past - 1]))

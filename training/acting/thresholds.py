"""Sets the probabilities from which head movements and faces are made.

    python -m training.acting.thresholds READINGS.npz … [--weights models/acting/weights.json]

READINGS are those of `training.acting.encoder read`, of lines that were held out. Movements are to be made rather than
missed, and those that say something of their own, a shake, a smile or a frown, must be right often enough: a wrong one
says the contrary of what is meant, a wrong tilt hardly anything. Prints, for each kind, how many stretches of lines
have it and how many of them get it, and how many of those that get it have it; and writes the thresholds among the
weights.
"""

import argparse
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from understudy.behavior.reading.decoding import stretch_level, stretches_of
from understudy.model import FloatArray, SingleArray

from .directed import FACE, FAMILIES, HEAD, DirectedLine, read_lines, targets_of

READ_AS = {"squint": "frown"}
"""What an audience reads in a face, where that is not what it is called."""

LEAST_LIKELY = {"head": 0.15, "face": 0.11}
"""No movement is made that is less likely wanted: it would be one among many that mean nothing."""

BETA = 2.0
"""How much more it matters that a movement is made than that every director wants it."""

TONED_PRECISION = {
    "shake": 0.66,
    "still": 0.5,
    **dict.fromkeys(("smile", "frown", "squint"), 0.45),
    **dict.fromkeys(("sad", "disgust"), 0.35),
}
"""How often movements that say something of their own must be what the one director wanted; of three, another one wants
most of the others. A wrong shake denies what is said."""


@dataclass(frozen=True, slots=True, eq=False)
class Stretches:
    """Of all stretches of the lines (N), how likely each kind is (N, K) and whether it was asked for (N, K)."""

    kinds: tuple[str, ...]
    level: SingleArray
    asked: SingleArray


def stretches(lines: Sequence[DirectedLine], readings: Mapping[str, SingleArray], channel: str) -> Stretches:
    """The stretches of lines, on the channel `head` or `face`."""
    kinds, first = (HEAD, 0) if channel == "head" else (FACE, len(HEAD))
    first += 2 * len(FAMILIES) + 1
    levels, asked = [], []
    for line in lines:
        likely = readings[line.name][:, first : first + len(kinds)]
        wanted = targets_of(line).head if channel == "head" else targets_of(line).face
        for begin, end in stretches_of(line.words):
            levels.append(stretch_level(likely[begin : end + 1]))
            asked.append(wanted[begin : end + 1].max(axis=0))
    read_as = [kinds.index(READ_AS.get(kind, kind)) for kind in kinds]
    return Stretches(kinds, np.stack(levels), np.stack(asked)[:, read_as])


def thresholds(lines: Sequence[DirectedLine], readings: Mapping[str, SingleArray], channel: str) -> dict[str, float]:
    """The thresholds of all kinds of a channel."""
    found = stretches(lines, readings, channel)
    return {
        kind: _threshold(kind, LEAST_LIKELY[channel], found.level[:, place], found.asked[:, place])
        for place, kind in enumerate(found.kinds)
    }


def read_readings(path: Path) -> dict[str, SingleArray]:
    """What `training.acting.encoder read` has written."""
    with np.load(path) as stored:
        return {name: stored[name].astype(np.float32) for name in stored.files}


def _threshold(kind: str, least: float, likely: FloatArray, wanted: FloatArray) -> float:
    """The level (N,) of a stretch from which a movement is made: with F_beta on stretches at its best, for a toned one
    where it is right often enough."""
    best = (0.0, 0.9)
    for threshold in np.arange(least, 0.9, 0.02):
        made = likely >= threshold
        right = float((made * wanted).sum())
        if kind in TONED_PRECISION and right >= TONED_PRECISION[kind] * made.sum() and made.any():
            return round(float(threshold), 2)
        score = (1 + BETA**2) * right / max(BETA**2 * wanted.sum() + made.sum(), 1e-9)
        if kind not in TONED_PRECISION:
            best = max(best, (score, float(threshold)))
    return round(best[1], 2)


def _tell(found: Stretches, chosen: Mapping[str, float]) -> None:
    for place, kind in enumerate(found.kinds):
        made, asked = found.level[:, place] >= chosen[kind], found.asked[:, place] > 0
        done, right = (made & asked).sum() / max(asked.sum(), 1), (made & asked).sum() / max(made.sum(), 1)
        print(f"{kind:12} from {chosen[kind]:.2f}: {asked.sum():4} asked, done {done:.2f}, right {right:.2f}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("readings", nargs="+", type=Path)
    parser.add_argument("--weights", type=Path, default=Path("models/acting/weights.json"))
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    arguments = parser.parse_args()
    readings = {name: row for path in arguments.readings for name, row in read_readings(path).items()}
    lines = [line for line in read_lines(arguments.directing) if line.name in readings]
    written = json.loads(arguments.weights.read_text(encoding="utf-8"))
    for channel in ("head", "face"):
        written[channel] = thresholds(lines, readings, channel)
        _tell(stretches(lines, readings, channel), written[channel])
    arguments.weights.write_text(json.dumps(written, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

"""Sets the probabilities from which head movements and faces are made.

    python -m training.acting.thresholds CASES.pkl [--weights models/acting/weights.json]

CASES are those of `training/acting/held_out.py`: lines that the reader was not trained on, by their words alone and as
they were heard. What is wanted three readers of the head alone and three of the face alone say (`lines/heads/`,
`lines/faces/`), who name as few as the directors of ../shared/directing. As in score.py, what two of them name is asked
for, and what any names is right. Movements are to be made rather than missed. Those that say something of their own, a
shake, a smile or a frown, say the contrary of what is meant where they are wrong: they are made where an F that weighs
what is missed is best, if they are right often enough and, of most faces, no more are made than any reader has. Prints,
for each kind and way of giving a line, how many stretches of lines have it and how many of them get it, and how many of
those that get it have it; and writes the thresholds among the weights.
"""

import argparse
import json
import pickle
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from understudy.behavior.reading.decoding import stretch_levels, stretches_of
from understudy.behavior.reading.encoder import Delivery, Encoder
from understudy.model import SingleArray

from .cases import Case
from .channel_readings import KINDS, as_moments, channel_readings
from .directed import CHANNELS, DirectedLine, targets_of
from .second_readings import readings_by_three

Readings: TypeAlias = Sequence[DirectedLine]
"""A line as several directors read it."""

READ_AS = {"squint": "frown"}
"""What an audience reads in a face, where that is not what it is called."""

LEAST_LIKELY = 0.1
"""No movement is made that is less likely wanted: it would be one among many that mean nothing."""

NO_MORE_THAN_NAMED = frozenset(("frown", "squint", "sad", "disgust"))
"""Faces of which no more are made than any reader names."""

NEVER = 0.5
"""A face that is never made by the reading alone needs this; an author's weight of some 6 to 8 reaches it."""

FEWEST = 20
"""On fewer stretches than this nothing can be told."""

BETA = 3.0
"""How much more it matters that a movement is made than that a director wants it."""

OWN_BETA = {"shake": 2.0, "still": 1.0}
"""The same of head movements that say something of their own."""

LEAST_RIGHT = {
    "shake": 0.85,
    **dict.fromkeys(("still", "wide_eyes", "smile", "frown", "squint", "sad", "disgust"), 0.5),
    "lips_pressed": 0.35,
}
"""How often movements that say something of their own must be what some director or reader wanted, and faces that are
easily too many. A wrong shake denies what is said."""


@dataclass(frozen=True, slots=True, eq=False)
class Stretches:
    """Of all stretches of the lines (N), how likely each kind is (N, K), whether two directors ask for it (N, K), and
    whether any does (N, K)."""

    kinds: tuple[str, ...]
    level: SingleArray
    asked: SingleArray
    named: SingleArray


def stretches(read: Sequence[Readings], readings: Mapping[str, SingleArray], channel: str) -> Stretches:
    """The stretches of lines with several readings, on the channel `head` or `face`."""
    kinds = KINDS[channel]
    levels, asked, named = [], [], []
    for lines in read:
        likely = readings[lines[0].name][:, CHANNELS[channel]]
        wanted = np.stack([getattr(targets_of(line), channel) for line in lines])
        found = stretches_of(lines[0].words)
        levels.append(stretch_levels(kinds, likely, found))
        for begin, end in found:
            *_fewer, second, most = np.sort(wanted[:, begin : end + 1].max(axis=1), axis=0)
            asked.append(second)
            named.append(most)
    read_as = [kinds.index(READ_AS.get(kind, kind)) for kind in kinds]
    return Stretches(kinds, np.concatenate(levels), np.stack(asked)[:, read_as], np.stack(named)[:, read_as])


def thresholds(read: Sequence[Readings], readings: Mapping[str, SingleArray], channel: str) -> dict[str, float]:
    """The thresholds of all kinds of a channel."""
    found = stretches(read, readings, channel)
    return {kind: _threshold(found, place) for place, kind in enumerate(found.kinds)}


def read_readings(path: Path) -> dict[str, SingleArray]:
    """What `training.acting.encoder read` has written."""
    with np.load(path) as stored:
        return {name: stored[name].astype(np.float32) for name in stored.files}


def _threshold(found: Stretches, place: int) -> float:
    """The level of a stretch, `LEAST_LIKELY` or more, from which a movement is made: F_beta on stretches is best there,
    and it is right often enough; never where it is not."""
    kind, asked, named = found.kinds[place], found.asked[:, place], found.named[:, place]
    beta = OWN_BETA.get(kind, BETA)
    best = (0.0, NEVER)
    for threshold in np.arange(LEAST_LIKELY, NEVER, 0.02):
        made = found.level[:, place] >= threshold
        right, done = (
            float((made * named).sum()) / max(made.sum(), 1),
            float((made * asked).sum()) / max(asked.sum(), 1),
        )
        if right < LEAST_RIGHT.get(kind, 0.0) or made.sum() < FEWEST:
            continue
        if kind in NO_MORE_THAN_NAMED and made.sum() > named.sum():
            continue
        score = (1 + beta**2) * right * done / max(beta**2 * right + done, 1e-9)
        best = max(best, (score, float(threshold)))
    return round(best[1], 2)


def readings_of(cases: Sequence[Case], encoder: Encoder) -> dict[str, SingleArray]:
    """What is read of each case (W, outputs), by its own name."""
    readings: dict[str, SingleArray] = {}
    for case in cases:
        utterance = case.analysis.utterance
        read = encoder.read([word.text for word in utterance.words], Delivery.of(utterance))
        parts = (read.at_word, read.nearby, read.stroke[:, None], read.head, read.face, read.gaze)
        readings[_name_of(case)] = np.concatenate(parts, axis=1)
    return readings


def read_by(directors: Mapping[str, Sequence[dict[str, Any]]], cases: Sequence[Case]) -> Sequence[Readings]:
    """Each case as several directors read its line."""
    return [
        [replace(case.line, name=_name_of(case), reading=each) for each in directors[case.line.name]] for case in cases
    ]


def _name_of(case: Case) -> str:
    return f"{case.line.name}, {case.way}"


def _tell(found: Stretches, chosen: Mapping[str, float], way: str) -> None:
    for place, kind in enumerate(found.kinds):
        made, asked = found.level[:, place] >= chosen[kind], found.asked[:, place]
        done = (made * asked).sum() / max(asked.sum(), 1)
        right = (made * found.named[:, place]).sum() / max(made.sum(), 1)
        print(
            f"{way}, {kind:12} from {chosen[kind]:.2f}: {asked.sum():4.0f} asked, done {done:.2f}; "
            f"{made.sum():4} made, right {right:.2f}"
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", type=Path)
    parser.add_argument("--weights", type=Path, default=Path("models/acting/weights.json"))
    arguments = parser.parse_args()
    alone = {channel: channel_readings(channel) for channel in KINDS}
    by_three = {name for name in readings_by_three() if all(name in readings for readings in alone.values())}
    cases = [case for case in pickle.loads(arguments.cases.read_bytes()) if case.line.name in by_three]
    readings = readings_of(cases, Encoder.load(arguments.weights.parent / "encoder.onnx"))
    written = json.loads(arguments.weights.read_text(encoding="utf-8"))
    for channel, directors in alone.items():
        as_directed = {name: [as_moments(each, channel) for each in directors[name]] for name in by_three}
        read = read_by(as_directed, cases)
        written[channel] = thresholds(read, readings, channel)
        for way in dict.fromkeys(case.way for case in cases):
            own = [lines for lines, case in zip(read, cases, strict=True) if case.way == way]
            _tell(stretches(own, readings, channel), written[channel], way)
    arguments.weights.write_text(json.dumps(written, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

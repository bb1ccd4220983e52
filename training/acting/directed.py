"""Reads directed lines: words, what directors would have the body do with them, and what they would forbid.

The format is that of ../shared/directing/README.md; our own lines have their text in the record itself. Lines of one
dialogue share a group, so that held-out lines come from dialogues that are held out as a whole.
"""

import json
import random
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from understudy.model import SingleArray

OWN = Path(__file__).parent / "lines"

CHOICE_WORTH = (1.0, 0.5, 0.25)
"""What a director's first, second and third choice are worth (../shared/directing/score.py)."""

SAME = {"point_here": "point", "point_there": "point", "point_up": "point"}
"""Pointings are one family: where a thing is, the scene tells."""

# fmt: off
FAMILIES = (
    "present", "addressee", "point", "emblem_other", "question", "negation", "self", "stop_refuse", "list_item",
    "heart", "contrast_sides", "shrug", "dismiss", "all_sweep", "count", "accept", "weigh", "offer_give", "shape",
    "precision", "group", "away", "approach", "down", "cycle", "word_search", "up", "join", "size_big", "think",
    "chop", "fist", "quote", "forward", "past", "size_small", "beat", "apologise", "end_cut", "please", "greet",
    "out", "none_empty", "contain_in", "through_path", "compare_levels", "turn_over_change", "back", "separate",
    "future", "thanks", "begin", "farewell", "now", "left", "right",
)
# fmt: on
HEAD = ("nod", "tilt", "shake", "lean_in", "toss", "turn", "lean_back")
FACE = ("brows_up", "smile", "frown", "lips_pressed", "wide_eyes", "squint", "sad", "disgust")

IMPORTANCE = {1: 0.7, 2: 1.0, 3: 1.3}
NEAR = 2
"""Words within which a stroke goes with a director's."""


@dataclass(frozen=True, slots=True)
class DirectedLine:
    """A line and one reading of it, as the JSON has it."""

    name: str
    words: tuple[str, ...]
    reading: dict[str, Any]

    @property
    def source(self) -> str:
        return self.name.split("-")[0]

    @property
    def group(self) -> str:
        """The dialogue it comes from; where names are numbered through, a run of twenty."""
        base, number = re.fullmatch(r"(.*?)-?([\d.]+)", self.name).groups()  # type: ignore[union-attr]
        numbered = base in ("pirates", "grail", "swb-t") or self.source == "own"
        return f"{base}/{int(float(number)) // 20}" if numbered else base


@dataclass(frozen=True, slots=True, eq=False)
class Targets:
    """What a line is trained towards, by word: worths of families with the stroke there and within `NEAR` words (W, F),
    strokes and their importance (W,), head (W, H) and face (W, K)."""

    at_word: SingleArray
    nearby: SingleArray
    stroke: SingleArray
    importance: SingleArray
    head: SingleArray
    face: SingleArray


def read_lines(directing: Path, *, own: bool = True) -> list[DirectedLine]:
    """The single readings in the folder `directing`, and our own lines."""
    words = {record["id"]: _words(record) for record in _records(directing / "directed-lines.jsonl")}
    lines = [DirectedLine(each["id"], words[each["id"]], each) for each in _records(directing / "directed.jsonl")]
    if own:
        for path in sorted(OWN.glob("*.jsonl")):
            lines += [DirectedLine(each["id"], tuple(each["text"].split()), each) for each in _records(path)]
    return lines


def targets_of(line: DirectedLine) -> Targets:
    """What a reading asks for, in numbers."""
    count = len(line.words)
    targets = Targets(
        at_word=np.zeros((count, len(FAMILIES)), np.float32),
        nearby=np.zeros((count, len(FAMILIES)), np.float32),
        stroke=np.zeros(count, np.float32),
        importance=np.ones(count, np.float32),
        head=np.zeros((count, len(HEAD)), np.float32),
        face=np.zeros((count, len(FACE)), np.float32),
    )
    for moment in line.reading["moments"]:
        _add_gesture(targets, moment)
        span = slice(moment["first"], moment["last"] + 1)
        for kinds, names, key in ((targets.head, HEAD, "head"), (targets.face, FACE, "face")):
            for kind in moment.get(key) or ():
                if kind in names:
                    kinds[span, names.index(kind)] = 1
    return targets


def folds_of(lines: Sequence[DirectedLine], count: int = 5, seed: int = 0) -> dict[str, int]:
    """The fold of each line by name; groups are whole, folds of about the same size."""
    groups = sorted({line.group for line in lines})
    random.Random(seed).shuffle(groups)
    sizes, fold = [0] * count, {}
    for group in groups:
        smallest = min(range(count), key=lambda each: sizes[each])
        fold[group] = smallest
        sizes[smallest] += sum(line.group == group for line in lines)
    return {line.name: fold[line.group] for line in lines}


def gesture_choices(moment: dict[str, Any]) -> list[str]:
    """The families of a moment, best first, pointings as one."""
    families = [SAME.get(family, family) for family in moment.get("gesture") or () if family != "still"]
    return list(dict.fromkeys(families))


def _add_gesture(targets: Targets, moment: dict[str, Any]) -> None:
    choices, stroke = gesture_choices(moment), moment["stroke"]
    if not choices or stroke >= len(targets.stroke):
        return
    targets.stroke[stroke] = 1
    targets.importance[stroke] = IMPORTANCE.get(moment["importance"], 1.0)
    near = slice(max(0, stroke - NEAR), stroke + NEAR + 1)
    for worth, family in zip(CHOICE_WORTH, choices, strict=False):
        column = FAMILIES.index(family)
        targets.at_word[stroke, column] = max(targets.at_word[stroke, column], worth)
        targets.nearby[near, column] = np.maximum(targets.nearby[near, column], worth)


def _records(path: Path) -> Iterator[dict[str, Any]]:
    return (json.loads(line) for line in path.read_text(encoding="utf-8").splitlines() if line.strip())


def _words(record: dict[str, Any]) -> tuple[str, ...]:
    return tuple(word.split(":", 1)[1] for word in record["words"])

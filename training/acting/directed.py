"""Reads directed lines: words, what directors would have the body do with them, and what they would forbid.

The format is that of ../shared/directing/README.md; our own lines have their text in the record itself. A delivery is a
line with how it is said: focus, tone and loudness. Lines of one dialogue, and the deliveries of one line, share a
group, so that what is held out is held out as a whole.
"""

import json
import random
import re
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from understudy.model import SingleArray

OWN = Path(__file__).parent / "lines"
SECOND, CAREFUL, FACES, HEADS = (OWN / folder for folder in ("second", "careful", "faces", "heads"))
"""Second readings, readings that were made with more care, and readings of faces and of heads alone, of lines that are
elsewhere; they are no further lines."""

ALIKE = OWN / "alike"
"""Lines that sound alike and are felt differently, of which the face alone was read."""

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
HEAD = ("nod", "tilt", "shake", "lean_in", "toss", "turn", "lean_back", "still")
FACE = ("brows_up", "smile", "frown", "lips_pressed", "wide_eyes", "squint", "sad", "disgust")
GAZE = ("listener", "away", "up", "down", "target")
MANNER = ("size", "speed")
HANDS = 2 * len(FAMILIES) + 1
"""The outputs of the hands, which come first."""

CHANNELS = {"head": slice(HANDS, HANDS + len(HEAD)), "face": slice(HANDS + len(HEAD), HANDS + len(HEAD) + len(FACE))}
"""Where head movements and faces are among the outputs."""

OUTPUTS = HANDS + len(HEAD) + len(FACE) + len(GAZE) + len(MANNER)

IMPORTANCE = {1: 0.7, 2: 1.0, 3: 1.3}
HELD_OUT_EVERY = 8

NEAR = 2
"""Words within which a stroke goes with a director's."""


FIRST_OWN = ("comedy_and_drama", "ensemble_and_monologue", "everyday_talk", "film_and_games")
"""Our first files, whose readers wrote heads and faces down only where they mattered most."""


@dataclass(frozen=True, slots=True)
class DirectedLine:
    """A line and one reading of it, as the JSON has it; `careful` if heads and faces were directed as carefully as
    hands."""

    name: str
    words: tuple[str, ...]
    reading: dict[str, Any]
    careful: bool = False

    @property
    def source(self) -> str:
        """The kind of line, or the corpus it is from."""
        return str(self.reading.get("source") or self.reading.get("kind") or self.name.split("-")[0])

    @property
    def is_delivery(self) -> bool:
        return "tone" in self.reading

    @property
    def group(self) -> str:
        """The line that is delivered, or the dialogue it comes from; where names are numbered through, a run of
        twenty."""
        if self.careful:
            return f"{self.source}/{self.reading.get('base', ' '.join(self.words))}"
        base, number = re.fullmatch(r"(.*?)-?([\d.]+)", self.name).groups()  # type: ignore[union-attr]
        numbered = base in ("pirates", "grail", "swb-t") or self.source == "own"
        return f"{base}/{int(float(number)) // 20}" if numbered else base


@dataclass(frozen=True, slots=True, eq=False)
class Targets:
    """What a line is trained towards, by word: worths of families with the stroke there and within `NEAR` words (W, F),
    strokes and their importance (W,), head (W, H), face (W, K) and gaze (W, G); and the size and speed (2,) of its
    movements, -1 to 1, or None."""

    at_word: SingleArray
    nearby: SingleArray
    stroke: SingleArray
    importance: SingleArray
    head: SingleArray
    face: SingleArray
    gaze: SingleArray
    manner: SingleArray | None


def read_lines(directing: Path) -> list[DirectedLine]:
    """The single readings of the folder `directing`, and our own, without the second readings."""
    words = {record["id"]: _words(record) for record in _records(directing / "directed-lines.jsonl")}
    lines = [DirectedLine(each["id"], words[each["id"]], each) for each in _records(directing / "directed.jsonl")]
    again = {path for folder in (SECOND, CAREFUL, FACES, HEADS, ALIKE) for path in folder.rglob("*.jsonl")}
    for path in sorted(set(OWN.glob("**/*.jsonl")) - again):
        lines += read_file(path, careful=path.stem not in FIRST_OWN)
    for path in sorted((directing / "more").glob("*.jsonl")):
        lines += read_file(path, careful=True)
    return lines


def read_alike() -> list[DirectedLine]:
    """The lines whose faces alone are known, without any reading of the whole body."""
    rows = (row for path in sorted(ALIKE.glob("*.jsonl")) for row in _records(path))
    return [DirectedLine(row["id"], tuple(row["text"].split()), {"moments": []}, careful=True) for row in rows]


def read_file(path: Path, *, careful: bool) -> list[DirectedLine]:
    """The lines of one file, with their text or their numbered words."""
    return [
        DirectedLine(each["id"], tuple(each["text"].split()) if "text" in each else _words(each), each, careful)
        for each in _records(path)
    ]


def targets_of(line: DirectedLine) -> Targets:
    """What a reading asks for, in numbers."""
    count, manner = len(line.words), line.reading.get("manner")
    targets = Targets(
        at_word=np.zeros((count, len(FAMILIES)), np.float32),
        nearby=np.zeros((count, len(FAMILIES)), np.float32),
        stroke=np.zeros(count, np.float32),
        importance=np.ones(count, np.float32),
        head=np.zeros((count, len(HEAD)), np.float32),
        face=np.zeros((count, len(FACE)), np.float32),
        gaze=np.zeros((count, len(GAZE)), np.float32),
        manner=np.array([manner[key] for key in MANNER], np.float32) if manner else None,
    )
    for moment in line.reading["moments"]:
        _add_gesture(targets, moment)
        span = slice(moment["first"], moment["last"] + 1)
        channels = (targets.head, HEAD, "head"), (targets.face, FACE, "face"), (targets.gaze, GAZE, "gaze")
        for kinds, names, key in channels:
            for kind in moment.get(key) or ():
                if kind in names:
                    kinds[span, names.index(kind)] = 1
    return targets


def avoided(line: DirectedLine) -> "np.ndarray[tuple[int, int], np.dtype[np.bool_]]":
    """The outputs of each word (W, outputs) that stand for what its director forbids there."""
    found = np.zeros((len(line.words), OUTPUTS), bool)
    for each in line.reading.get("avoid") or ():
        kinds = {SAME.get(kind, kind) for kind in each["what"]}
        for first, names in ((0, FAMILIES), (CHANNELS["head"].start, HEAD), (CHANNELS["face"].start, FACE)):
            columns = [first + place for place, name in enumerate(names) if name in kinds]
            found[each["first"] : each["last"] + 1, columns] = True
    return found


def is_held_out(line: DirectedLine, without: str = "") -> bool:
    """Whether a line is for checking alone: an eighth of the careful ones by group, and all of the kind `without`."""
    return line.careful and (zlib.crc32(line.group.encode()) % HELD_OUT_EVERY == 0 or line.source == without)


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

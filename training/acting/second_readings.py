"""Second readings of our own directed lines: the words to read, and how far two readings agree.

    python -m training.acting.second_readings words --each 73
    python -m training.acting.second_readings agree --score ../shared/directing/score.py

`words` draws lines of every kind that has them and prints their names and numbered words, and nothing of the first
reading. `agree` runs the scorer of directors on the lines that were read twice, all of them and kind by kind.
"""

import argparse
import json
import random
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import chain
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from training.acting.directed import CAREFUL, OWN, SECOND, read_file

KINDS = (
    "npc", "previs", "lecture", "quarrel", "tender", "monologue", "instruction", "banter", "interview", "rhetoric",
    "smalltalk",
)  # fmt: skip

DIRECTORS = 3
WRITTEN_WITH_CARE = "*_8.jsonl"
"""The files of lines that were directed with care when they were written (`lines/README.md`)."""


def words_to_read(kind: str, count: int) -> Iterator[str]:
    """`count` lines of a kind, drawn by chance but always the same ones: the name, then each word with its number."""
    lines = [line for path in _files_of(kind) for line in read_file(path, careful=True)]
    random.Random(kind).shuffle(lines)
    for line in sorted(lines[:count], key=lambda each: each.name):
        yield " ".join([line.name, *(f"{number}:{word}" for number, word in enumerate(line.words))])


def pairs_of(kind: str) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """The first and the second reading of each line of a kind that has both."""
    firsts = {line.name: line.reading for path in _files_of(kind) for line in read_file(path, careful=True)}
    path = SECOND / f"{kind}.jsonl"
    seconds = [line.reading for line in read_file(path, careful=True)] if path.exists() else []
    return [(firsts[each["id"]], each) for each in seconds]


def second_readings() -> dict[str, dict[str, Any]]:
    """All second readings by the name of their line, also those of lines of the folder `directing`, which are without
    their words."""
    return {record["id"]: record for record in _records(SECOND)}


def careful_readings() -> dict[str, list[dict[str, Any]]]:
    """The readings made with care, up to three a line, by the name of their line; of further lines without the words,
    and those of the lines that were directed with care when they were written."""
    found: dict[str, list[dict[str, Any]]] = defaultdict(list)
    for record in chain(_records(CAREFUL), _records(OWN, WRITTEN_WITH_CARE)):
        found[record["id"]].append(record)
    return found


def readings_by_three() -> dict[str, list[dict[str, Any]]]:
    """The careful readings of the lines that three directors read."""
    return {name: readings for name, readings in careful_readings().items() if len(readings) == DIRECTORS}


def _records(folder: Path, names: str = "*.jsonl") -> Iterator[dict[str, Any]]:
    for path in sorted(folder.rglob(names)):
        yield from (json.loads(line) for line in path.read_text(encoding="utf-8").splitlines())


def _files_of(kind: str) -> list[Path]:
    return sorted(OWN.glob(f"{kind}_[12].jsonl"))


def agreement(read: Sequence[Sequence[dict[str, Any]]], score: Path) -> str:
    """What the scorer says of the readings of each line, each judged by the others."""
    with TemporaryDirectory() as folder:
        paths = [Path(folder) / f"{number}.jsonl" for number, _ in enumerate(read[0], 1)]
        for path, readings in zip(paths, zip(*read, strict=True), strict=True):
            path.write_text("".join(f"{json.dumps(each)}\n" for each in readings), encoding="utf-8")
        command = [sys.executable, str(score), "agree", *map(str, paths)]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def _agree(score: Path) -> None:
    pairs = {kind: found for kind in KINDS if (found := pairs_of(kind))}
    print(agreement([pair for found in pairs.values() for pair in found], score))
    for kind, found in pairs.items():
        print(f"{kind}, {len(found)} lines: {agreement(found, score).splitlines()[-1]}")


def main() -> None:
    """Prints words or agreement."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    verbs = parser.add_subparsers(dest="verb", required=True)
    verbs.add_parser("words").add_argument("--each", type=int, default=73)
    verbs.add_parser("agree").add_argument("--score", type=Path, required=True)
    chosen = parser.parse_args()
    if chosen.verb == "agree":
        _agree(chosen.score)
        return
    for kind in KINDS:
        print(*words_to_read(kind, chosen.each), sep="\n")


if __name__ == "__main__":
    main()

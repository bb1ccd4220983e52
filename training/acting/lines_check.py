"""Checks our own directed lines and deliveries, and writes them from the notation (`notation.py`).

    python -m training.acting.lines_check check [--beside ../shared/directing]
    python -m training.acting.lines_check write NOTATION... --writer 2

`check` looks at every record in `lines/` and `lines/deliveries/`: words in range, families, names of heads, faces and
gazes, strokes a moment apart, names and texts that come twice, texts that nearly do; and at `lines/second/`,
`lines/careful/`, `lines/faces/` and `lines/heads/`, whose lines must be among those or in `lines/alike/`, or with
`--beside` among those of that folder. `write` makes one file a kind.
"""

import argparse
import json
import re
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import chain
from pathlib import Path
from typing import Any

from training.acting import channel_readings
from training.acting.directed import ALIKE, CAREFUL, OWN, SECOND
from training.acting.notation import AVOIDABLE, CHANNELS, FAMILIES, TONES, NotationError, records_of

DELIVERIES = OWN / "deliveries"
ALL_HANDS = {"hands", "any"}
"""What score.py reads as every gesture."""
NEAR_DOUBLE = 0.5
"""The share of the shorter line's runs of three words that makes two lines near-doubles."""
LEAST_SHARED = 4
"""Fewer common runs than this are a turn of phrase."""


def problems_of(record: dict[str, Any]) -> list[str]:
    """What is wrong with one record, said in words; empty where it is sound."""
    count = len(record["text"].split())
    found = [f"{moment} out of range" for moment in record["moments"] if not _in_range(moment, count)]
    found += [f"{each} out of range" for each in record["avoid"] if not 0 <= each["first"] <= each["last"] < count]
    for moment in record["moments"]:
        found += [f"no family {each}" for each in set(moment["gesture"]) - FAMILIES]
        for channel, names in CHANNELS.items():
            found += [f"no {channel} {each}" for each in set(moment.get(channel) or ()) - set(names.values())]
    for avoided in record["avoid"]:
        found += [f"nothing called {each} to avoid" for each in set(avoided["what"]) - AVOIDABLE - ALL_HANDS]
    strokes = [moment["stroke"] for moment in record["moments"] if moment["gesture"] not in ([], ["still"])]
    found += [f"strokes {strokes} not in order"] if strokes != sorted(set(strokes)) else []
    return found + (_problems_of_delivery(record, count) if "base" in record else [])


def doubles_in(texts: dict[str, str], known: dict[str, str]) -> Iterator[str]:
    """Texts (by name) that are the same as another, there or in `known`, or share half of their runs of three words."""
    seen = _Seen()
    for name, text in (known | texts).items():
        words = tuple(re.findall(r"[a-z0-9']+", text.casefold()))
        if name in texts:
            yield from (f"{name} is {other} again, or nearly" for other in seen.like(words))
        seen.add(name, words)


def strangers_in(again: Iterable[dict[str, Any]], records: Iterable[dict[str, Any]]) -> Iterator[str]:
    """Second readings of lines that are not among `records`, or have other words there."""
    texts = {each["id"]: _text(each) for each in records}
    for each in again:
        if texts.get(each["id"]) != each["text"]:
            yield f"second reading {each['id']} is of no line here"


@dataclass(slots=True)
class _Seen:
    """Lines by their runs of three words."""

    by_run: dict[tuple[str, ...], list[str]] = field(default_factory=dict)
    sizes: dict[str, int] = field(default_factory=dict)
    whole: dict[tuple[str, ...], str] = field(default_factory=dict)

    def like(self, words: tuple[str, ...]) -> Iterator[str]:
        """The lines that are as good as this one."""
        if words in self.whole:
            yield self.whole[words]
            return
        own = _runs(words)
        shared = Counter(name for run in own for name in self.by_run.get(run, ()))
        for name, count in shared.items():
            if count >= max(LEAST_SHARED, NEAR_DOUBLE * min(len(own), self.sizes[name])):
                yield name

    def add(self, name: str, words: tuple[str, ...]) -> None:
        self.whole.setdefault(words, name)
        self.sizes[name] = len(_runs(words))
        for run in _runs(words):
            self.by_run.setdefault(run, []).append(name)


def _runs(words: tuple[str, ...]) -> set[tuple[str, ...]]:
    return set(zip(words, words[1:], words[2:], strict=False))


def _in_range(moment: dict[str, Any], count: int) -> bool:
    return bool(0 <= moment["first"] <= moment["stroke"] <= moment["last"] < count) and moment["importance"] in (
        1,
        2,
        3,
    )


def _problems_of_delivery(record: dict[str, Any], count: int) -> list[str]:
    found = [] if record["tone"] in TONES.values() else [f"no tone {record['tone']}"]
    found += [] if record["focus"] and all(0 <= each < count for each in record["focus"]) else ["focus out of range"]
    levels = (record["loudness"], record["manner"]["size"], record["manner"]["speed"])
    return found + ([] if all(each in (-1, 0, 1) for each in levels) else [f"levels {levels}"])


def _records(folder: Path) -> Iterator[dict[str, Any]]:
    for path in sorted(folder.glob("*.jsonl")):
        yield from _records_in(path)


def _records_in(path: Path) -> Iterator[dict[str, Any]]:
    return (json.loads(line) for line in path.read_text(encoding="utf-8").splitlines() if line.strip())


def _texts(records: Iterable[dict[str, Any]]) -> dict[str, str]:
    """Texts by the name of the line, deliveries of one line being one."""
    return {each.get("base", each["id"]): _text(each) for each in records if "text" in each or "words" in each}


def _text(record: dict[str, Any]) -> str:
    return record["text"] if "text" in record else " ".join(word.split(":", 1)[1] for word in record["words"])


def _of_further(records: list[dict[str, Any]], further: list[dict[str, Any]], folder: Path) -> list[dict[str, Any]]:
    """The readings in a folder that are without words, with these; without the lines of `further`, those of our own
    lines alone."""
    texts = {each["id"]: _text(each) for each in [*records, *further]}
    again = _records(folder)
    return [{**each, "text": texts.get(each["id"], "")} for each in again if further or each["id"] in texts]


def _check(beside: Path | None) -> int:
    records, alike = [*_records(OWN), *_records(DELIVERIES)], list(_records(ALIKE))
    further = [*_records(beside / "more"), *_records_in(beside / "directed-lines.jsonl")] if beside else []
    again = [*_records(SECOND), *_records(SECOND / "deliveries"), *_of_further(records, further, SECOND / "more")]
    careful = _of_further(records, further, CAREFUL)
    alone = {
        channel: _of_further([*records, *alike], further, folder)
        for channel, folder in channel_readings.FOLDERS.items()
    }
    complaints = [f"{each['id']}: {problem}" for each in [*records, *again, *careful] for problem in problems_of(each)]
    for channel, readings in alone.items():
        for each in readings:
            problems = channel_readings.problems_of(each, channel, len(each["text"].split()))
            complaints += [f"{each['id']}: {problem}" for problem in problems]
    for some in (records, alike, again):
        names = Counter(each["id"] for each in some)
        complaints += [f"{name} comes {count} times" for name, count in names.items() if count > 1]
    complaints += strangers_in(chain(again, careful, *alone.values()), [*records, *alike, *further])
    known: dict[str, str] = {}
    for folder in (beside, beside / "more", beside / "deliveries") if beside else ():
        known |= _texts(_records(folder))
    complaints += doubles_in(_texts([*records, *alike]), known)
    further_ones = f"{len(again)} second, {len(careful)} careful ones, {sum(map(len, alone.values()))} of head or face"
    told = f"{len(records)} readings, {len(alike)} lines of which the face alone was read, {further_ones}"
    print(*complaints, f"{told}, {len(complaints)} complaints", sep="\n")
    return 1 if complaints else 0


def _write(notations: list[Path], writer: str) -> int:
    counts: dict[str, int] = {}
    records: list[dict[str, Any]] = []
    wrong = []
    for path in notations:
        try:
            records += records_of(path, writer, counts)
        except NotationError as error:
            wrong.append(str(error))
    if wrong:
        print(*wrong, sep="\n", file=sys.stderr)
        return 1
    files: dict[Path, list[str]] = {}
    for record in records:
        folder = DELIVERIES if "base" in record else OWN
        line = json.dumps(record, ensure_ascii=False)
        files.setdefault(folder / f"{record['source']}_{writer}.jsonl", []).append(line)
    for path, lines in files.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"{len(records)} readings written to {len(files)} files")
    return 0


def main() -> int:
    """Checks or writes."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    verbs = parser.add_subparsers(dest="verb", required=True)
    verbs.add_parser("check").add_argument("--beside", type=Path)
    write = verbs.add_parser("write")
    write.add_argument("notations", type=Path, nargs="+")
    write.add_argument("--writer", required=True)
    chosen = parser.parse_args()
    if chosen.verb == "check":
        return _check(chosen.beside)
    return _write(chosen.notations, chosen.writer)


if __name__ == "__main__":
    sys.exit(main())

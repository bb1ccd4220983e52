"""What the analysis measures in recordings of deliveries: `python -m training.acting.recordings INDEX.jsonl … OUT.json`

An index is one of `training.focus.speaking`: an object a recording with the delivery's `id`, the `path` beside the
index and the times of its `words`. OUT has, by the delivery's name, a `Delivery` for each recording;
`training.acting.encoder` learns from them. Recordings in which a word is not spoken are left out.
"""

import argparse
import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from understudy.behavior.reading.encoder import Delivery
from understudy.model import Affect, Line, LineAffect, PhraseAffect, Timings
from understudy.models import Understudy
from understudy.performance import analyze
from understudy.settings import Settings

from .directed import read_lines


def measured(understudy: Understudy, index: Path, words: Mapping[str, Sequence[str]]) -> Iterator[tuple[str, Delivery]]:
    """The names of an index' deliveries, and how each recording is said."""
    for row in map(json.loads, index.read_text(encoding="utf-8").splitlines()):
        if row["id"] not in words or None in row["words"]:
            continue
        own = words[row["id"]]
        timed = [
            {"text": text, "start_s": start_s, "end_s": end_s}
            for text, (start_s, end_s) in zip(own, row["words"], strict=True)
        ]
        timings = Timings(json.dumps({"words": timed}).encode(), "json")
        line = Line((index.parent / row["path"]).read_bytes(), " ".join(own), timings)
        yield row["id"], Delivery.of(analyze(understudy, line).utterance)


def read_measured(path: Path) -> dict[str, Sequence[Delivery]]:
    """The deliveries that were measured, by name."""
    stored = json.loads(path.read_text(encoding="utf-8"))
    return {name: [_delivery(each) for each in deliveries] for name, deliveries in stored.items()}


def _delivery(stored: dict[str, Any]) -> Delivery:
    affect = stored["affect"]
    return Delivery(
        focus=tuple(stored["focus"]) if stored["focus"] is not None else None,
        affect=LineAffect(
            _affect(affect["line"]),
            tuple(PhraseAffect(each["first"], each["last"], _affect(each["affect"])) for each in affect["phrases"]),
        )
        if affect
        else None,
        loudness=stored["loudness"],
    )


def _affect(stored: dict[str, Any]) -> Affect:
    return Affect(stored["activation"], stored["valence"], stored["dominance"], tuple(stored["tones"]))


def write_measured(found: Iterable[tuple[str, Delivery]], path: Path) -> None:
    """Writes what `read_measured` reads."""
    by_name: dict[str, list[dict[str, Any]]] = {}
    for name, delivery in found:
        by_name.setdefault(name, []).append(asdict(delivery))
    path.write_text(json.dumps(by_name), encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("indexes", nargs="+", type=Path)
    parser.add_argument("output", type=Path)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    arguments = parser.parse_args()
    words = {line.name: line.words for line in read_lines(arguments.directing) if line.is_delivery}
    with Understudy.load(Settings()) as understudy:
        found = (each for index in arguments.indexes for each in measured(understudy, index, words))
        write_measured(found, arguments.output)


if __name__ == "__main__":
    main()

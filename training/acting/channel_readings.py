"""Readings of the face alone and of the head alone, by readers who name little: what an audience would miss if it were
not there.

    python -m training.acting.channel_readings --score ../shared/directing/score.py

Who directs hands, head, face and eyes with care names something of each in nearly every moment (3.5 faces a line); the
directors of ../shared/directing name about half as much. `lines/faces/` and `lines/heads/` have, for lines of all
sources and without their words, what the speaker feels or does and the movements of its phrases; of lines that three
directors read with care there are three such readings. In numbers they are (W, K): 1 on the words of a phrase that has
a kind, in the order of `directed.FACE` or `directed.HEAD`. The command prints how far the three agree.
"""

import argparse
import json
from collections import defaultdict
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np

from understudy.model import SingleArray

from .directed import FACE, FACES, HEAD, HEADS
from .second_readings import DIRECTORS, agreement

ChannelReading: TypeAlias = Mapping[str, Any]
"""`id`, `idea`, and `spans` with `first`, `last` and their `kinds`."""

KINDS = MappingProxyType({"head": HEAD, "face": FACE})
FOLDERS = MappingProxyType({"head": HEADS, "face": FACES})


def channel_readings(channel: str) -> dict[str, list[ChannelReading]]:
    """All readings of `head` or `face` alone, up to three a line, by the name of their line."""
    found: dict[str, list[ChannelReading]] = defaultdict(list)
    for path in sorted(FOLDERS[channel].glob("*.jsonl")):
        for row in path.read_text(encoding="utf-8").splitlines():
            record = json.loads(row)
            found[record["id"]].append(record)
    return found


def asked_by(readings: Sequence[ChannelReading], channel: str, words: int) -> SingleArray:
    """The share of readings that ask for each kind on each word (W, K)."""
    asked = np.zeros((len(readings), words, len(KINDS[channel])), np.float32)
    for own, reading in zip(asked, readings, strict=True):
        for span in reading["spans"]:
            for kind in span["kinds"]:
                own[span["first"] : span["last"] + 1, KINDS[channel].index(kind)] = 1
    return np.asarray(asked.mean(axis=0), np.float32)


def as_moments(reading: ChannelReading, channel: str) -> dict[str, Any]:
    """A reading in the form of one of the whole body, which does nothing else."""
    return {
        "id": reading["id"],
        "moments": [
            {"first": each["first"], "last": each["last"], "stroke": each["first"], channel: each["kinds"]}
            for each in reading["spans"]
        ],
    }


def problems_of(reading: ChannelReading, channel: str, words: int) -> list[str]:
    """What is wrong with a reading of a line of so many words; empty where it is sound."""
    unknown = {kind for each in reading["spans"] for kind in each["kinds"]} - set(KINDS[channel])
    apart = [each for each in reading["spans"] if not 0 <= each["first"] <= each["last"] < words]
    return [f"no {channel} {kind}" for kind in sorted(unknown)] + [f"{each} out of range" for each in apart]


def main() -> None:
    """Prints how far three readers of the same lines agree."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--score", type=Path, required=True)
    score = parser.parse_args().score
    for channel in KINDS:
        by_three = [readings for readings in channel_readings(channel).values() if len(readings) == DIRECTORS]
        print(f"{channel}, {len(by_three)} lines")
        told = agreement([[as_moments(each, channel) for each in readings] for readings in by_three], score)
        for reader, row in enumerate(told.splitlines()[:DIRECTORS], 1):
            print(
                f"reader {reader} beside the others:",
                next(part for part in row.split("; ") if part.startswith(channel)),
            )


if __name__ == "__main__":
    main()

"""How long the encoder takes to read a line of 15 words.

    python -m benchmarks.behavior.reading [MODEL.onnx …] [--record]

Reads lines of our own (`training/acting/lines`) with the shipped model and with others, in turns, since machines are
noisy: the median over lines and rounds, in milliseconds of one processor, and how long the others take beside the
shipped one.
"""

import argparse
import time
from collections.abc import Sequence
from itertools import islice
from pathlib import Path
from statistics import median

from benchmarks.figures import add_record_option, record
from training.acting.directed import OWN, read_file
from understudy.behavior.reading.encoder import Encoder
from understudy.files import resource_folder

WORDS, LINES, ROUNDS = 15, 40, 20


def lines() -> list[tuple[str, ...]]:
    """Lines of `WORDS` words."""
    read = (line for path in sorted(OWN.glob("*.jsonl")) for line in read_file(path, careful=True))
    return list(islice((line.words for line in read if len(line.words) == WORDS), LINES))


def times_ms(encoders: Sequence[Encoder]) -> list[float]:
    """The median time of each encoder, which take turns with every line."""
    spent_ms: list[list[float]] = [[] for _ in encoders]
    for line in lines() * ROUNDS:
        for encoder, own in zip(encoders, spent_ms, strict=True):
            began_s = time.process_time()
            encoder.read(line)
            own.append(1000 * (time.process_time() - began_s))
    return [median(own) for own in spent_ms]


def main() -> None:
    """Prints a line for each model."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("others", nargs="*", type=Path)
    add_record_option(parser)
    arguments = parser.parse_args()
    paths = [resource_folder("models") / "acting" / "encoder.onnx", *arguments.others]
    shipped_ms, *others_ms = times_ms([Encoder.load(path) for path in paths])
    print(f"{paths[0]}: {shipped_ms:.2f} ms for {WORDS} words")
    for path, each_ms in zip(arguments.others, others_ms, strict=True):
        print(f"{path}: {each_ms:.2f} ms, {each_ms / shipped_ms:.2f} times as long")
    if arguments.record:
        record("choice", "the encoder reads 15 words", shipped_ms, unit="ms", bar="≤ 5")


if __name__ == "__main__":
    main()

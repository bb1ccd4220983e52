"""Utterances per second of `understudy functions`: a corpus in, JSON lines out, on one core.

    python -m benchmarks.rules.corpus_rate [--treebanks FOLDER] [--utterances N]

The utterances are sentences of the treebanks spoken-* and gum-*, shuffled, about 15 words each; the treebanks are read
again from the start when N is more than they have. The command runs as anybody runs it, on one core, and all lines wait
to be read. Timing begins with the first answer, so that loading is left out. `processor` is the time the command itself
ran, which other work on the machine does not lengthen.
"""

import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from itertools import cycle, islice
from pathlib import Path

from training.parser.treebank import Sentence, read_treebank

TREEBANKS = Path(__file__).resolve().parents[3] / "shared" / "data" / "treebanks"


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--treebanks", type=Path, default=TREEBANKS)
    arguments.add_argument("--utterances", type=int, default=10_000)
    options = arguments.parse_args()
    texts = list(utterances(options.treebanks, options.utterances))
    words = sum(len(text.split()) for text in texts) / len(texts)
    print(f"{len(texts)} utterances of {words:.1f} words on average")
    wall_s, processor_s = measure(texts)
    print(f"wall {wall_s:.1f} s, {len(texts) / wall_s:.0f} utterances a second")
    print(f"processor {processor_s:.1f} s, {len(texts) / processor_s:.0f} utterances a second")


def utterances(treebanks: Path, count: int) -> Iterator[str]:
    paths = [path for path in sorted(treebanks.glob("*.conllu")) if path.name.startswith(("spoken-", "gum-"))]
    sentences = [_text(sentence) for path in paths for sentence in read_treebank(path)]
    random.Random(0).shuffle(sentences)
    return islice(cycle(sentences), count)


def measure(texts: list[str]) -> tuple[float, float]:
    """Seconds of the clock and of the processor from the first answer to the last."""
    with tempfile.TemporaryFile() as lines:
        lines.writelines(json.dumps({"id": number, "text": text}).encode() + b"\n" for number, text in enumerate(texts))
        lines.seek(0)
        command = [sys.executable, "-m", "understudy.cli", "functions"]
        environment = os.environ | {"OMP_NUM_THREADS": "1"}
        with subprocess.Popen(command, stdin=lines, stdout=subprocess.PIPE, env=environment) as process:
            os.sched_setaffinity(process.pid, {min(os.sched_getaffinity(0))})
            assert process.stdout is not None
            process.stdout.readline()
            begun_s, begun_processor_s = time.perf_counter(), _processor_s(process.pid)
            for _ in range(len(texts) - 2):
                process.stdout.readline()
            processor_s = _processor_s(process.pid) - begun_processor_s
            assert json.loads(process.stdout.readline())["id"] == len(texts) - 1
            return time.perf_counter() - begun_s, processor_s


def _processor_s(pid: int) -> float:
    """User and system time of a process (proc(5))."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _text(sentence: Sentence) -> str:
    return "".join(row.form + (" " if row.space_after else "") for row in sentence).strip()


if __name__ == "__main__":
    main()

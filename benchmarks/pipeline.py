"""Wall time of every stage on recorded lines, as multiples of the audio's length, and resident memory.

    python -m benchmarks.pipeline [--lines FOLDER] [--repeats N]

FOLDER holds pairs NAME.flac and NAME.txt (default: ../shared/data/speech/lines). Every line is performed once to warm
up, then N times; a stage's figure is the sum over the lines of its median time. One core: set OMP_NUM_THREADS=1.
"""

import argparse
import os
import statistics
import time
from collections import defaultdict
from pathlib import Path

from benchmarks.figures import add_record_option, record
from understudy.bml.writing.writer import write_bml
from understudy.model import Line
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.settings import Settings

LINES = Path(__file__).resolve().parents[2] / "shared" / "data" / "speech" / "lines"
TEXT_STAGES = ("parse", "functions", "mapping", "schedule", "write")


class Stopwatch:
    """Adds up the time between the stage names it is told."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)
        self._stage: str | None = None
        self._since = 0.0

    def __call__(self, stage: str | None) -> None:
        now = time.perf_counter()
        if self._stage:
            self.seconds[self._stage] += now - self._since
        self._stage, self._since = stage, now


def time_line(understudy: Understudy, line: Line) -> tuple[dict[str, float], float]:
    """Seconds by stage, and the audio's length in seconds."""
    watch = Stopwatch()
    performance = perform(understudy, line, Options(), watch)
    watch("write")
    write_bml(performance)
    watch(None)
    return watch.seconds, performance.utterance.duration_s or 0.0


def resident_megabytes() -> float:
    """Resident memory of this process and its children."""
    pids = [os.getpid(), *map(int, Path(f"/proc/self/task/{os.getpid()}/children").read_text().split())]
    return sum(int(Path(f"/proc/{pid}/statm").read_text().split()[1]) for pid in pids) * 4096 / 1e6


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--lines", type=Path, default=LINES)
    arguments.add_argument("--repeats", type=int, default=5)
    add_record_option(arguments)
    options = arguments.parse_args()
    lines = [
        Line(path.read_bytes(), path.with_suffix(".txt").read_text()) for path in sorted(options.lines.glob("*.flac"))
    ]
    audio_s, totals = 0.0, defaultdict[str, float](float)
    with Understudy.load(Settings()) as understudy:
        for line in lines:
            time_line(understudy, line)
            runs = [time_line(understudy, line) for _ in range(options.repeats)]
            audio_s += runs[0][1]
            for stage in runs[0][0]:
                totals[stage] += statistics.median(seconds[stage] for seconds, _ in runs)
        megabytes = resident_megabytes()
    print(f"{len(lines)} lines, {audio_s:.1f} s of audio, median of {options.repeats}")
    for stage, seconds in totals.items():
        a_line = f"{1000 * seconds / len(lines):8.2f} ms a line" if stage in TEXT_STAGES else ""
        print(f"{stage:12s} {seconds / audio_s:8.4f} × real time {a_line}")
    print(f"{'all':12s} {sum(totals.values()) / audio_s:8.4f} × real time")
    rules_ms = 1000 * (totals["functions"] + totals["mapping"]) / len(lines)
    print(f"function and mapping rules {rules_ms:.2f} ms a line")
    print(f"resident memory {megabytes:.0f} MB, the aligner's process included")
    if options.record:
        whole = sum(totals.values()) / audio_s
        record("speed", "whole performance, one core", whole, "× real time", bar="≤ 0.029", aim="≤ 0.020")
        record("speed", "function and mapping rules of a line", rules_ms, "ms")
        record("speed", "memory of a performance", megabytes, "MB", bar="≤ 350", aim="≤ 280")


if __name__ == "__main__":
    main()

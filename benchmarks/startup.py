"""Processor time and memory of each command from a cold process: how long a user waits who runs it once.

    python -m benchmarks.startup [--runs N] [--librosa]

Every command runs N times in a process of its own, its children counted: with what is kept between processes
(`UNDERSTUDY_CACHE`), after one run that is not counted, and without (`off`). Printed are the medians of user and system
time and of the largest resident memory; beside them the bar of issue 12, which was set on a machine on which
`perform` took 6.5 s, `functions` 4.7 and `rules check` 4.4 before, and what this machine took for the same (`--before`
runs a checkout from before on this machine, so that the shares can be compared). `--librosa` also tells what it costs
to import librosa alone. Files are in the system's cache; bytecode is compiled and kept, as Python does by default, even
where the environment forbids it (`PYTHONDONTWRITEBYTECODE`): compiling our modules anew takes a quarter of a second.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.figures import add_record_option, record

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
LINE = (str(EXAMPLES / "example.flac"), "--text-file", str(EXAMPLES / "example.txt"))


@dataclass(frozen=True, slots=True)
class Command:
    """What is run, and the seconds that issue 12 allows and found before (None: it says nothing)."""

    arguments: tuple[str, ...]
    bar_s: float | None = None
    before_s: float | None = None

    @property
    def name(self) -> str:
        return " ".join(each for each in self.arguments if not each.startswith(str(EXAMPLES)))


COMMANDS = (
    Command(("--help",), 0.3),
    Command(("functions", "--text", "No, I have never seen those."), 2.2, 4.7),
    Command(("rules", "check"), 2.5, 4.4),
    Command(("perform", *LINE), 3.5, 6.5),
    Command(("perform", *LINE, "--realize", "line.glb")),
    Command(("analyze", *LINE)),
    Command(("gestures", "list")),
    Command(("characters", "list")),
)
RECORDED = {
    COMMANDS[0].name: ("--help", "≤ 0.3", "≤ 0.2"),
    COMMANDS[1].name: ("functions", "≤ 1.0", "≤ 0.6"),
    COMMANDS[3].name: ("perform", "≤ 2.0", "≤ 1.2"),
}
"""The figures that are kept, with what they must reach and what we aim for."""
LIBROSA = {
    "numpy and scipy.fft": "import numpy, scipy.fft",
    "and librosa.filters": "import numpy, scipy.fft; from librosa.filters import mel",
    "and librosa.feature": "import numpy, scipy.fft; from librosa.filters import mel; from librosa.feature import mfcc",
}


@dataclass(frozen=True, slots=True)
class Cost:
    """Processor seconds, user and system, and megabytes of the larger of process and child."""

    processor_s: float
    memory_mb: float


def cost_of(command: Sequence[str], environment: Mapping[str, str], folder: str) -> Cost:
    """What one run costs; raises CalledProcessError when it fails."""
    process = subprocess.Popen(
        command, env=environment, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    )
    assert process.stderr is not None
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    process.stderr.close()
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, command, stderr=errors)
    return Cost(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)


def median_cost(command: Sequence[str], runs: int, environment: Mapping[str, str], folder: str) -> Cost:
    """The medians of some runs."""
    costs = [cost_of(command, environment, folder) for _ in range(runs)]
    return Cost(statistics.median(c.processor_s for c in costs), statistics.median(c.memory_mb for c in costs))


def tell_commands(runs: int, before: Path | None) -> dict[str, Cost]:
    """Prints a line for each command; returns what each costs, by its name, with the cache kept."""
    costs = {}
    print(f"{'command':44s} {'kept':>7s} {'MB':>5s} {'off':>7s} {'MB':>5s} {'before':>7s} {'share':>6s}   bar (share)")
    with tempfile.TemporaryDirectory() as folder:
        usual = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        kept = usual | {"UNDERSTUDY_CACHE": str(Path(folder) / "cache")}
        off = usual | {"UNDERSTUDY_CACHE": "off"}
        for command in COMMANDS:
            called = (sys.executable, "-m", "understudy.cli", *command.arguments)
            cost_of(called, kept, folder)
            with_it, without = (median_cost(called, runs, each, folder) for each in (kept, off))
            costs[command.name] = with_it
            line = f"{command.name:44s} {with_it.processor_s:5.2f} s {with_it.memory_mb:5.0f} "
            line += f"{without.processor_s:5.2f} s {without.memory_mb:5.0f} "
            if before is not None:
                there = usual | {"PYTHONPATH": str(before / "src")}
                cost_of(called, there, folder)
                earlier = median_cost(called, runs, there, folder)
                line += f"{earlier.processor_s:5.2f} s {with_it.processor_s / earlier.processor_s:6.2f} "
            else:
                line += " " * 15
            print(line + _bar(command))
    return costs


def _bar(command: Command) -> str:
    if command.bar_s is None:
        return ""
    share = f" ({command.bar_s / command.before_s:.2f})" if command.before_s else ""
    return f"  {command.bar_s:.1f} s{share}"


def tell_librosa(runs: int) -> None:
    """What importing librosa costs."""
    with tempfile.TemporaryDirectory() as folder:
        for name, code in LIBROSA.items():
            cost = median_cost((sys.executable, "-c", code), runs, os.environ, folder)
            print(f"{name:44s} {cost.processor_s:5.2f} s {cost.memory_mb:5.0f} MB")


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--runs", type=int, default=5)
    arguments.add_argument("--before", type=Path, metavar="CHECKOUT", help="an earlier checkout to compare with")
    arguments.add_argument("--librosa", action="store_true", help="tell what importing librosa costs as well")
    add_record_option(arguments)
    options = arguments.parse_args()
    costs = tell_commands(options.runs, options.before)
    if options.record:
        for name, (figure, bar, aim) in RECORDED.items():
            record("speed", f"{figure}, cold, processor time", costs[name].processor_s, "s", bar=bar, aim=aim)
    if options.librosa:
        tell_librosa(options.runs)


if __name__ == "__main__":
    main()

"""Costs of motion: processor time, memory, a pose of a picture, and the start of `understudy realize`.

    python -m benchmarks.realizer.costs [--sentences N] [--minutes M] [--runs N]

All on one core: set OMP_NUM_THREADS=1. Processor time is lengthened by what else runs on the machine, by its caches and
shared cores, so the best of several runs is told beside their median. Schedules are those of the recorded lines of
../shared and of N sentences of GUM; the long one has M minutes of them and is realized in a process of its own, in
which nothing else was loaded. A pose of a contact sheet is seen from the front, from three quarters and in close-up.
Bars: 400 × real time at 60 frames a second, 300 MB for ten minutes, .1 s a pose.
"""

import argparse
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from itertools import islice
from multiprocessing import get_context
from pathlib import Path

from benchmarks.startup import cost_of
from understudy.files import resource_folder
from understudy.model import Schedule
from understudy.realization import RealizedSchedule, Realizer, realize, schedule_of
from understudy.realizer.exporting.glb import to_glb
from understudy.realizer.pictures.contact_sheet import draw_sheet, moments_of

BML = """<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b" characterId="default">
<gesture id="g" lexeme="BEAT" mode="RIGHT_HAND" start="0.2" stroke="1.0" relax="1.4"/></bml>"""
RATE_HZ = 60


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--sentences", type=int, default=60)
    arguments.add_argument("--minutes", type=float, default=10.0)
    arguments.add_argument("--runs", type=int, default=9)
    options = arguments.parse_args()
    from benchmarks.realizer.motion import LINES, long_schedule, of_lines, of_sentences  # not in the measured process

    lines = [schedule_of(each) for each in of_lines(LINES, "default")]
    sentences = [schedule_of(each) for each in islice(of_sentences("default"), options.sentences)]
    realizer = Realizer.load(resource_folder("lexicon"))
    for name, schedules in (("recorded lines", lines), ("sentences", sentences)):
        report_speed(name, realizer, schedules, options.runs)
    report_sheet(realizer, lines[0], options.runs)
    report_long(long_schedule("default", options.sentences, options.minutes))
    report_start(options.runs)


def seconds(work: Callable[[], object], runs: int) -> tuple[float, float]:
    """The least and the median processor time of some runs, after one that is not counted."""
    work()
    found = []
    for _ in range(runs):
        begun_s = time.process_time()
        work()
        found.append(time.process_time() - begun_s)
    return min(found), statistics.median(found)


def report_speed(name: str, realizer: Realizer, schedules: Sequence[Schedule], runs: int) -> None:
    duration_s = sum(schedule.duration_s for schedule in schedules)
    best_s, median_s = seconds(lambda: [realize(realizer, each, frame_rate_hz=RATE_HZ) for each in schedules], runs)
    rates = f"{duration_s / best_s:.0f} × real time at best, median {duration_s / median_s:.0f} ×"
    print(f"{len(schedules)} {name}, {duration_s:.0f} s at {RATE_HZ} frames a second: {rates}")


def report_sheet(realizer: Realizer, schedule: Schedule, runs: int) -> None:
    realized = RealizedSchedule(schedule, realize(realizer, schedule))
    moments = moments_of(realized.motion, schedule)
    best_s, median_s = seconds(lambda: draw_sheet(realized.motion, realizer.skeleton, moments), runs)
    print(f"contact sheet: {best_s / len(moments):.3f} s a pose at best, median {median_s / len(moments):.3f} s")


def report_long(schedule: Schedule) -> None:
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as elsewhere:
        before_mb, realized_mb, written_mb, took_s = elsewhere.submit(_long, schedule).result()
    rate = f"{schedule.duration_s / 60:.1f} minutes: {schedule.duration_s / took_s:.0f} × real time"
    print(f"{rate}, {before_mb:.0f} MB before, {realized_mb:.0f} MB at most, {written_mb:.0f} MB with the GLB written")


def _long(schedule: Schedule) -> tuple[float, float, float, float]:
    realizer = Realizer.load(resource_folder("lexicon"))
    before_mb, begun_s = _most_mb(), time.process_time()
    motion = realize(realizer, schedule, frame_rate_hz=RATE_HZ)
    took_s, realized_mb = time.process_time() - begun_s, _most_mb()
    to_glb(motion, realizer.skeleton)
    return before_mb, realized_mb, _most_mb(), took_s


def _most_mb() -> float:
    """The most memory of this process. `getrusage` would count that of the process that started it as well."""
    status = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in status if line.startswith("VmHWM")) / 1024


def report_start(runs: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        bml = Path(folder) / "line.bml"
        bml.write_text(BML)
        command = (sys.executable, "-m", "understudy.cli", "realize", str(bml), "-o", "line.bvh")
        environment = {"UNDERSTUDY_CACHE": str(Path(folder) / "cache"), "PYTHONPATH": ":".join(sys.path)}
        cost_of(command, environment, folder)
        processor_s = [cost_of(command, environment, folder).processor_s for _ in range(runs)]
    times = f"{min(processor_s):.2f} s at best, median {statistics.median(processor_s):.2f} s"
    print(f"understudy realize of BML alone: {times}")


if __name__ == "__main__":
    main()

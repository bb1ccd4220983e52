"""What a line costs the processor by itself, with a listener, and in each format, for the estimate of a dry run.

    python -m benchmarks.batch.costs RECORDING TEXT_FILE

prints processor seconds per second of speech (`app/batch/reports/dry_run.py` has them).
"""

import sys
from dataclasses import replace
from pathlib import Path
from time import process_time

from understudy.batch.audio import AudioSource
from understudy.batch.work.formats import FORMATS, OutputFormat, extension_of
from understudy.batch.work.jobs import LineJob, OutputTarget, ReferenceJob
from understudy.batch.work.performing import perform_job
from understudy.batch.work.worker import learn_reference
from understudy.model.formats import MotionFormat
from understudy.models import Understudy
from understudy.options import Options
from understudy.settings import Settings

TIMES = 2
LEFT_OUT = frozenset({MotionFormat.FBX})
"""Blender writes it, in a process of its own."""


def main() -> None:
    audio, text = Path(sys.argv[1]), Path(sys.argv[2]).read_text(encoding="utf-8")
    with Understudy.load(Settings()) as models:
        plain = LineJob("line", text, AudioSource(audio), Options(), ())
        outcome = perform_job(plain, models)
        assert outcome.measures is not None, outcome.failure
        length_s = outcome.measures.duration_s
        bare_s = _seconds(plain, models)
        costs = {"performed": bare_s, "with a listener": _seconds(_heard(plain), models) - bare_s}
        motion_s = _seconds(_in(plain, MotionFormat.CSV), models) - bare_s
        costs["motion and csv"] = motion_s
        costs["motion and csv of a listener"] = (
            _seconds(_in(_heard(plain), MotionFormat.CSV), models) - bare_s - motion_s
        )
        for form in FORMATS:
            if form not in LEFT_OUT:
                before_s = motion_s if isinstance(form, MotionFormat) else 0.0
                costs[extension_of(form)] = _seconds(_in(plain, form), models) - bare_s - before_s
        start_s = process_time()
        learn_reference(ReferenceJob("nobody", (AudioSource(audio),)), models.acoustic)
        costs["learning a voice"] = process_time() - start_s
    for name, seconds in costs.items():
        print(f"{name:32s} {seconds / length_s:7.4f} s/s {seconds:7.3f} s")


def _in(job: LineJob, form: OutputFormat) -> LineJob:
    return replace(job, targets=(OutputTarget(form, f"line.{extension_of(form)}"),))


def _heard(job: LineJob) -> LineJob:
    return replace(job, options=replace(job.options, listeners=("Ben",)))


def _seconds(job: LineJob, models: Understudy) -> float:
    """The least of a few, since other work disturbs."""
    return min(_once(job, models) for _ in range(TIMES))


def _once(job: LineJob, models: Understudy) -> float:
    start_s = process_time()
    outcome = perform_job(job, models)
    if outcome.failure is not None:
        print(job.targets, outcome.failure.message)
    return process_time() - start_s


if __name__ == "__main__":
    main()

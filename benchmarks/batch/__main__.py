"""Cost of `understudy batch`, and whether it loses anything.

    python -m benchmarks.batch [rate] [memory] [resume] [kills] [--lines N] [--finished N] [--killed-lines N] …

rate: lines an hour with one worker and with two, on the clock (all of it, and from the first line to the last) and by
processor time, which other work on the machine does not change; bars 1.8 × and 6,000 an hour with two workers. memory:
the most that a worker with its aligner had; bar 450 MB. resume: the same command on a manifest of finished lines; bar
5 s for 10,000. kills: the command is killed at random times, then run to its end: every byte but the manifest's must be
that of an undisturbed run. Without a name all are measured.
"""

import argparse
import hashlib
import random
import tempfile
from concurrent.futures import Future
from pathlib import Path

from understudy.batch.planning import BatchRequest
from understudy.batch.whole_run import Nobody, run_batch
from understudy.batch.work.files import write_files
from understudy.batch.work.formats import LineFormat
from understudy.batch.work.jobs import LineJob, LineOutcome, Measures, OutputFile, ReferenceJob
from understudy.model import Notice
from understudy.model.voice.signal import SpeakerReference
from understudy.settings import read_settings

from .corpus import SPEECH, write_script
from .running import Run, command, run, run_and_kill

MEASURES = ("rate", "memory", "resume", "kills")
BML_BYTES = 6_000
SOME_FAILED = (0, 1)
"""Exit codes of a batch that came to its end: a recording that another sentence was meant for may fail."""


def tell_rate(folder: Path, lines: int) -> None:
    """Lines an hour, and memory, with one worker and two."""
    script = write_script(folder / "rate", lines)
    runs = {workers: _finished(run(command(script, folder / f"out{workers}", workers))) for workers in (1, 2)}
    print(f"{lines} lines, BML      all, s   lines/h   steady lines/h   CPU s a line   CPU lines/h   worker MB")
    for workers, each in runs.items():
        all_rate, steady = 3600 * each.lines / each.seconds, 3600 * (each.lines - 1) / each.steady_s
        each_s = each.processor_s / each.lines
        print(
            f"  {workers} worker(s)      {each.seconds:8.1f} {all_rate:9.0f} {steady:16.0f} {each_s:14.3f} "
            f"{workers * 3600 / each_s:13.0f} {each.worker_mb:11.0f}"
        )
    ratio = (runs[2].lines - 1) / runs[2].steady_s / ((runs[1].lines - 1) / runs[1].steady_s)
    print(f"  two workers are {ratio:.2f} × one, from the first line to the last")


def tell_memory(folder: Path, lines: int) -> None:
    """The most that a worker had, without motion and with."""
    script = write_script(folder / "memory", lines)
    for form in ("bml", "glb"):
        each = _finished(run(command(script, folder / f"memory-{form}", 1, "--format", form)))
        print(f"memory, {lines} lines as {form}: {each.worker_mb:.0f} MB a worker with its aligner")


def tell_resume(folder: Path, lines: int) -> None:
    """Seconds until the same command has seen that all is done."""
    script = write_script(folder / "resume", lines)
    out = folder / "resume-out"
    request = BatchRequest(script, script.parent / "audio", out, learns_voices=False)
    run_batch(request, read_settings(), Finished, Nobody())
    each = _finished(run(command(script, out, 2, "--voices", "none")))
    taken = f"{each.seconds:.2f} s, CPU {each.processor_s:.2f} s"
    print(f"resume: {lines} finished lines, {each.lines} performed again: {taken}")


def tell_kills(folder: Path, lines: int, kills: int, seed: int) -> None:
    """Whether killing the command changes a byte of what comes out."""
    script = write_script(folder / "kills", lines)
    undisturbed = _finished(run(command(script, folder / "undisturbed", 2)))
    chance = random.Random(seed)
    longest_s = undisturbed.first_s + 1.5 * undisturbed.steady_s / kills  # so that lines are left for every kill
    called = command(script, folder / "killed", 2)
    killed = [run_and_kill(called, chance.uniform(0.5, longest_s)) for _ in range(kills)]
    last = _finished(run(called))
    expected, found = _content(folder / "undisturbed"), _content(folder / "killed")
    same = sum(expected.get(name) == content for name, content in found.items())
    print(
        f"kills: {lines} lines, killed {sum(killed)} times of {kills}, {last.lines} lines left to the last run; "
        f"{same} of {len(expected)} files have the same bytes, {len(found.keys() - expected.keys())} are left over"
    )


class Finished:
    """An engine that writes a file of usual size for each line at once, to make a manifest of finished lines."""

    places = 1

    def submit(self, job: LineJob) -> "Future[LineOutcome]":
        done: Future[LineOutcome] = Future()
        content = hashlib.shake_128(job.id.encode()).digest(BML_BYTES)
        files = [OutputFile(LineFormat.BML, target.path, len(content), "", content) for target in job.targets]
        assert job.folder is not None
        measures = Measures(3.0, 9, "medium", {"negation": 1, "emphasis": 2, "deixis": 1}, 3, 1, 12, 2, 2.5)
        notices = (Notice("pronunciation_guessed", "the pronunciation of 'zyx' was guessed"),)
        done.set_result(LineOutcome(job.id, 0.2, write_files(job.folder, files), notices, measures))
        return done

    def learn(self, job: ReferenceJob) -> "Future[SpeakerReference | None]":
        raise NotImplementedError(job.speaker)

    def close(self) -> None:
        pass


def _finished(each: Run) -> Run:
    if each.code not in SOME_FAILED:
        raise SystemExit(f"the command ended with {each.code}")
    return each


def _content(out: Path) -> dict[str, str]:
    """Every file but the manifest, which has the seconds that lines took, as a hash."""
    files = [path for path in out.rglob("*") if path.is_file() and not path.name.startswith(("manifest.", ".lock"))]
    return {path.relative_to(out).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("measures", nargs="*", metavar="MEASURE", help=", ".join(MEASURES))
    parser.add_argument("--lines", type=int, default=1000)
    parser.add_argument("--memory-lines", type=int, default=100)
    parser.add_argument("--finished", type=int, default=10_000)
    parser.add_argument("--killed-lines", type=int, default=100)
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if not SPEECH.is_dir():
        raise SystemExit(f"{SPEECH} is missing")
    wanted = options.measures or MEASURES
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if "rate" in wanted:
            tell_rate(folder, options.lines)
        if "memory" in wanted:
            tell_memory(folder, options.memory_lines)
        if "resume" in wanted:
            tell_resume(folder, options.finished)
        if "kills" in wanted:
            tell_kills(folder, options.killed_lines, options.kills, options.seed)


if __name__ == "__main__":
    main()

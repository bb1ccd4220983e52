"""Cost of analysing long audio, and whether its word times agree with those of the short lines it consists of.

    python -m benchmarks.acoustic.long_audio [--minutes 30] [--lines FOLDER]

Joins the lines of FOLDER (pairs NAME.flac and NAME.txt) over and over, a third of a second of silence between them, to
the length asked, and hears that: the whole acoustic stage, from the bytes of a WAV file to stress. Prints the time of
each part and all processor time, the most memory resident at once (ours, and that of the decoder's process), and how
far each word's start and end lie from where they lie when its line is aligned alone. One core: set OMP_NUM_THREADS=1.
"""

import argparse
import io
import os
from itertools import cycle, takewhile
from pathlib import Path

import numpy as np
import soundfile
import soxr

from benchmarks.acoustic.alignment import processor_s
from benchmarks.pipeline import Stopwatch
from understudy.acoustic.models import AcousticModels
from understudy.acoustic.stage import align_words, analyze_signal
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray, Word
from understudy.settings import Settings
from understudy.text.transcript import read_transcript

ROOT = Path(__file__).resolve().parents[2]
LINES = ROOT.parent / "shared" / "data" / "speech" / "lines"
PAUSE_S = 1 / 3
ANY_LENGTH = Settings(max_audio_s=1e6, part_bytes=f"audio={2**40}")


def main() -> None:
    """Prints the figures."""
    options = _options()
    lines = [_read(path) for path in sorted(options.lines.glob("*.flac"))]
    order = _order([len(samples) / SAMPLE_RATE_HZ for samples, _ in lines], options.minutes * 60)
    content = _joined([lines[number][0] for number in order])
    transcript = _words(" ".join(lines[number][1] for number in order))
    with AcousticModels.load(ANY_LENGTH) as acoustic:
        alone = [acoustic.aligner.align(Audio(samples), _words(text))[0] for samples, text in lines]
        acoustic.close()
        began_s, watch = processor_s(), Stopwatch()
        heard = analyze_signal(acoustic, content, watch)
        watch("align")
        found = align_words(acoustic, heard.audio, transcript)
        watch(None)
        peaks = [_peak_mb(pid) for pid in (os.getpid(), *_children())]
    spent_s = processor_s() - began_s
    duration_s, seconds = heard.audio.duration_s, sum(watch.seconds.values())
    parts = ", ".join(f"{stage} {spent:.0f}" for stage, spent in watch.seconds.items())
    print(f"{duration_s / 60:.1f} minutes, {len(found.words)} words: {seconds:.0f} s ({parts})")
    print(f"{spent_s:.0f} s of processor; {seconds / duration_s:.3f} × real time")
    print("at most " + " + ".join(f"{peak:.0f}" for peak in peaks) + " MB resident, here and in the decoder's process")
    print("notices:", ", ".join(f"{each.code} ({each.message[:80]})" for each in found.notices) or "none")
    print(f"fillers heard: {len(found.fillers)}")
    print_differences(found.words, _expected_s([alone[number] for number in order], [len(lines[n][0]) for n in order]))


def print_differences(words: tuple[Word, ...], expected_s: list[float]) -> None:
    """How far the words lie from where they should."""
    found_s = [time_s for word in words if word.interval for time_s in (word.interval.start_s, word.interval.end_s)]
    differences_ms = np.abs(np.array(found_s) - expected_s) * 1000
    shares = ", ".join(f"within {limit} ms {np.mean(differences_ms <= limit):.2%}" for limit in (5, 20, 100))
    print(f"against the lines alone: {shares}, mean {differences_ms.mean():.1f} ms, most {differences_ms.max():.0f} ms")


def _order(durations_s: list[float], total_s: float) -> list[int]:
    """The numbers of the lines in their order, as many as fit in the time."""
    ends_s = np.cumsum([durations_s[number % len(durations_s)] + PAUSE_S for number in range(int(total_s))])
    count = sum(1 for _ in takewhile(lambda end_s: end_s <= total_s, ends_s))
    return [number for number, _ in zip(cycle(range(len(durations_s))), range(max(count, 1)), strict=False)]


def _expected_s(alone: list[tuple[Word, ...]], lengths: list[int]) -> list[float]:
    """Start and end of every word in the joined audio, as the lines alone have them."""
    expected_s = []
    offset_s = 0.0
    for words, length in zip(alone, lengths, strict=True):
        intervals = [word.interval for word in words if word.interval]
        expected_s += [offset_s + time_s for each in intervals for time_s in (each.start_s, each.end_s)]
        offset_s += length / SAMPLE_RATE_HZ + PAUSE_S
    return expected_s


def _read(path: Path) -> tuple[FloatArray, str]:
    samples, rate_hz = soundfile.read(path, always_2d=True)
    mono: FloatArray = soxr.resample(samples[:, 0], rate_hz, SAMPLE_RATE_HZ)
    return mono, path.with_suffix(".txt").read_text(encoding="utf-8")


def _words(text: str) -> tuple[Word, ...]:
    return read_transcript(text, max_characters=1_000_000)


def _joined(parts: list[FloatArray]) -> bytes:
    """A WAV file of all parts, a pause after each."""
    pause = np.zeros(round(PAUSE_S * SAMPLE_RATE_HZ))
    content = io.BytesIO()
    with soundfile.SoundFile(content, "w", SAMPLE_RATE_HZ, 1, "PCM_16", format="WAV") as file:
        for part in parts:
            file.write(part)
            file.write(pause)
    return content.getvalue()


def _children() -> list[int]:
    return [int(pid) for pid in Path(f"/proc/self/task/{os.getpid()}/children").read_text().split()]


def _peak_mb(pid: int) -> float:
    """The most memory that was ever resident; what `getrusage` says of a child counts what its parent had before."""
    status = dict(line.split(":", 1) for line in Path(f"/proc/{pid}/status").read_text().splitlines())
    return int(status["VmHWM"].split()[0]) / 1000


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=30.0)
    parser.add_argument("--lines", type=Path, default=LINES)
    return parser.parse_args()


if __name__ == "__main__":
    main()

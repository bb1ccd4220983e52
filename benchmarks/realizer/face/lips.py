"""Agreement of lips and sound: closures, openings and speed on recorded lines with phones of our own aligner.

    python -m benchmarks.realizer.face.lips [--lines FOLDER …] [--rate HZ]

FOLDER holds pairs NAME.flac and NAME.txt (default: examples/ and ../shared/data/speech/lines). A closure is the time
for which the mouth is shut (`understudy.realizer.face.lip_closure`) about a P, B, M, F or V. Closing is reckoned from
the phone's start and parting from its end, before which is negative, where the mouth comes from or goes to a vowel;
"apart" is the time between phone and closure, 0 where they overlap. The phones have errors of their own
(docs/measurements/bodies.md). A vowel's peak is the widest opening between the middles of its neighbours, for vowels
that are clearly more open than both.

The opening is then held against the sound's energy, with which lips of talkers go (Chandrasekaran et al. 2009):
Pearson's r within each line, in dB within 30 dB of the loudest, for the face as it is, without coarticulation (steps),
and for the paper's diphones done simply (straight lines from the middle of a phone to the middle of the next).
"""

import argparse
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from benchmarks.realizer.face.lip_closure import Closure, lip_closures, lip_opening
from understudy.acoustic.stage import align_words, analyze_signal
from understudy.behavior.speech import visemes
from understudy.files import resource_folder
from understudy.model import FRAME_SHIFT_S, FloatArray, Line, Schedule, Viseme, Word
from understudy.models import Understudy
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.face.blendshapes import face_weights
from understudy.realizer.face.face_tables import FaceTables
from understudy.realizer.geometry.rotations import IDENTITY
from understudy.settings import Settings
from understudy.text.transcript import read_transcript

SHARED_LINES = Path(__file__).resolve().parents[4] / "shared" / "data" / "speech" / "lines"
VOWELS = frozenset({"aa", "E", "I", "O", "U"})
BARS_S = (0.020, 0.040)
MORE_OPEN = 0.1
"""Of the jaw's way: a vowel that is hardly more open than its neighbours has no peak to be looked for."""

REPEATS = 5


@dataclass(frozen=True, slots=True, eq=False)
class Spoken:
    """A line: what its mouth is to do, and how loud it is in each frame of the analysis."""

    words: tuple[Word, ...]
    visemes: tuple[Viseme, ...]
    duration_s: float
    energy_db: FloatArray


def hear_lines(folders: Sequence[Path]) -> Iterator[Spoken]:
    settings = Settings()
    with Understudy.load(settings) as understudy:
        for path in sorted(each for folder in folders for each in folder.glob("*.flac")):
            sound = path.read_bytes()
            line = Line(sound, path.with_suffix(".txt").read_text())
            heard = analyze_signal(understudy.acoustic, sound)
            transcript = read_transcript(line.text)
            alignment = align_words(understudy.acoustic, heard.audio, transcript)
            shapes, _ = visemes(alignment.words, heard.audio.duration_s)
            yield Spoken(alignment.words, shapes, heard.audio.duration_s, heard.contours.energy_db)


def still_body(duration_s: float, rate_hz: int) -> tuple[BodyMotion, Skeleton]:
    skeleton = Skeleton.standing()
    times_s = np.arange(0, duration_s, 1 / rate_hz)
    rotations = np.tile(IDENTITY, (len(times_s), len(skeleton.names), 1))
    return BodyMotion(times_s, rotations, np.zeros((len(times_s), 3))), skeleton


def closing_and_parting_s(closures: Sequence[Closure], spoken: Sequence[Viseme]) -> tuple[list[float], list[float]]:
    """How late the mouth shuts and parts, where it comes from a vowel and where it goes to one."""
    before = {viseme.interval: last.label for last, viseme in pairwise(spoken)}
    behind = {viseme.interval: following.label for viseme, following in pairwise(spoken)}
    shut = [(each.viseme.interval, each.closed) for each in closures if each.closed]
    closing = [span.start_s - phone.start_s for phone, span in shut if before.get(phone) in VOWELS]
    return closing, [span.end_s - phone.end_s for phone, span in shut if behind.get(phone) in VOWELS]


def apart_s(closure: Closure) -> float:
    """From the phone to the nearest moment at which the mouth is shut."""
    if closure.closed is None:
        return float("inf")
    phone, shut = closure.viseme.interval, closure.closed
    return max(0.0, shut.start_s - phone.end_s, phone.start_s - shut.end_s)


def peaks_within(spoken: Sequence[Viseme], opening: FloatArray, times_s: FloatArray) -> list[bool]:
    """For each vowel that is clearly more open than its neighbours, whether its widest moment falls in its phone."""
    found = []
    for last, vowel, following in zip(spoken, spoken[1:], spoken[2:], strict=False):
        if vowel.label in VOWELS and vowel.opening > max(last.opening, following.opening) + MORE_OPEN:
            bounds_s = [(each.interval.start_s + each.interval.end_s) / 2 for each in (last, following)]
            first, behind = np.searchsorted(times_s, bounds_s)
            peak_s = times_s[first + np.argmax(opening[first : max(behind, first + 1)])]
            found.append(bool(vowel.interval.start_s <= peak_s <= vowel.interval.end_s))
    return found


def openings_by_method(spoken: Spoken, opening: FloatArray, times_s: FloatArray) -> dict[str, FloatArray]:
    """The opening as the face has it, in steps, and by straight diphones."""
    starts_s = [viseme.interval.start_s for viseme in spoken.visemes]
    wide = np.array([viseme.opening for viseme in spoken.visemes])
    middles_s = [(viseme.interval.start_s + viseme.interval.end_s) / 2 for viseme in spoken.visemes]
    return {
        "the face": opening,
        "steps": wide[np.maximum(np.searchsorted(starts_s, times_s, side="right") - 1, 0)],
        "diphones": np.interp(times_s, middles_s, wide),
    }


def loudness(spoken: Spoken, times_s: FloatArray) -> FloatArray:
    """The energy at the frames, no lower than 30 dB under the loudest."""
    frames_s = np.arange(len(spoken.energy_db)) * FRAME_SHIFT_S
    return np.asarray(np.interp(times_s, frames_s, np.maximum(spoken.energy_db, spoken.energy_db.max() - 30)))


@dataclass(frozen=True, slots=True, eq=False)
class Measured:
    """What is measured of a line; see the head of this file."""

    duration_s: float
    seconds: float
    closures: Sequence[Closure]
    closing_s: Sequence[float]
    parting_s: Sequence[float]
    peaks_within: Sequence[bool]
    correlations: Mapping[str, float]


def measure(tables: FaceTables, spoken: Spoken, rate_hz: int) -> Measured:
    body, skeleton = still_body(spoken.duration_s, rate_hz)
    schedule = Schedule((), spoken.duration_s, spoken.words, spoken.visemes)
    began = time.process_time()
    for _ in range(REPEATS):
        shapes = face_weights(tables, schedule, body, skeleton, seed=0)
    seconds = (time.process_time() - began) / REPEATS
    closures = lip_closures(spoken.visemes, shapes, body.times_s)
    closing_s, parting_s = closing_and_parting_s(closures, spoken.visemes)
    opening, loud = lip_opening(shapes), loudness(spoken, body.times_s)
    methods = openings_by_method(spoken, opening, body.times_s)
    correlations = {name: float(np.corrcoef(values, loud)[0, 1]) for name, values in methods.items()}
    peaks = peaks_within(spoken.visemes, opening, body.times_s)
    return Measured(spoken.duration_s, seconds, closures, closing_s, parting_s, peaks, correlations)


def tell(lines: Sequence[Measured], rate_hz: int) -> None:
    closures = [closure for line in lines for closure in line.closures]
    duration_s = sum(line.duration_s for line in lines)
    never = sum(closure.closed is None for closure in closures)
    print(f"{duration_s:.1f} s at {rate_hz} frames a second, {len(closures)} closures, of which never shut {never}")
    print(told("apart", [apart_s(closure) for closure in closures]))
    print(told("closing", [late_s for line in lines for late_s in line.closing_s]))
    print(told("parting", [late_s for line in lines for late_s in line.parting_s]))
    peaks = [within for line in lines for within in line.peaks_within]
    print(f"vowels  {len(peaks):4d}: {100 * np.mean(peaks):.1f} % open widest within their phone")
    for name in lines[0].correlations:
        r = [line.correlations[name] for line in lines]
        print(f"opening and energy, {name}: r = {np.mean(r):.3f} (lines: {min(r):.2f} to {max(r):.2f})")
    print(f"{1000 * sum(line.seconds for line in lines) / duration_s:.2f} ms of processor time a second of motion")


def told(name: str, errors_s: Sequence[float]) -> str:
    size = np.abs(errors_s)
    shares = ", ".join(f"{100 * np.mean(size <= bar_s):.1f} % within {1000 * bar_s:.0f} ms" for bar_s in BARS_S)
    finite = np.array(errors_s)[np.isfinite(errors_s)]
    return (
        f"{name:7s} {len(size):4d}: mean {1000 * finite.mean():+5.1f} ms, of sizes {1000 * np.abs(finite).mean():.1f}, "
        f"p95 {1000 * np.percentile(np.abs(finite), 95):.1f} ms; {shares}"
    )


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--lines", type=Path, nargs="+", default=[resource_folder("examples"), SHARED_LINES])
    arguments.add_argument("--rate", type=int, default=60)
    options = arguments.parse_args()
    tables = FaceTables.load(resource_folder("lexicon") / "face.yaml")
    tell([measure(tables, spoken, options.rate) for spoken in hear_lines(options.lines)], options.rate)


if __name__ == "__main__":
    main()

"""Accuracy of f0 and voicing against laryngograph references, and speed.

    python -m benchmarks.acoustic.pitch [--fda FOLDER] [--parity odd|even]

Data: the FDA evaluation database (one man, one woman, 50 sentences); `.f0ref` has f0 in Hz every 15 ms, 0 where
unvoiced, value k at k × 15 ms. Our frame nearest in time answers for it.

- Gross pitch error: of the frames that are voiced in both, the share whose f0 is more than 20 % off.
- Fine error: median of |log f0 ratio| of those frames, in cents, gross errors left out.
- Voicing decision error: the share of all frames that are voiced in one and not in the other.

Noise is added at a ratio of the powers over the whole file. Babble is all other sentences of the files at hand (24 or
25 of each half) at once, equally loud: the babble of NOISEX-92, with which SRH was published, has a hundred talkers.
"8 talkers" is harder, since single voices stand out of it; all are the two speakers themselves. "8 kHz" is the file
resampled to that rate and back.

`understudy.acoustic.pitch.tracking.TUNED` was chosen on the files of odd number, so the even ones are the test;
`PUBLISHED` switches its departures off. The speed is processor time over the audio's.
"""

import argparse
import math
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import soxr

from understudy.acoustic.pitch import tracking as pitch
from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Audio, FloatArray

FDA = Path(__file__).resolve().parents[3] / "shared" / "data" / "speech" / "fda"
REFERENCE_SHIFT_S = 0.015
GROSS = 0.20


@dataclass(frozen=True, slots=True)
class Recording:
    """A sentence and the f0 that a laryngograph measured on the speaker's throat."""

    audio: Audio
    reference_hz: FloatArray


@dataclass(frozen=True, slots=True)
class Errors:
    """Shares in [0, 1], the fine error in cents."""

    gross: float
    fine_cents: float
    voicing: float


def main() -> None:
    """Prints the table."""
    options = _options()
    paths = [path for path in sorted(options.fda.glob("*.flac")) if options.parity in ("all", _parity(path))]
    recordings = [read_recording(path) for path in paths]
    print(f"{len(recordings)} files, {sum(recording.audio.duration_s for recording in recordings):.0f} s")
    print(f"{'':16}{'gross %':>10}{'fine cents':>12}{'voicing %':>11}{'× real time':>13}")
    conditions = {"clean": recordings, "8 kHz": [narrowed(recording) for recording in recordings]}
    for ratio_db in (10, 0):
        conditions[f"white {ratio_db} dB"] = with_noise(recordings, white(recordings), ratio_db)
        conditions[f"babble {ratio_db} dB"] = with_noise(recordings, babble(recordings, len(recordings) - 1), ratio_db)
        conditions[f"8 talkers {ratio_db} dB"] = with_noise(recordings, babble(recordings, 8), ratio_db)
    for title, tuning in (("tuned", pitch.TUNED), ("as published", pitch.PUBLISHED)):
        print(title)
        for name, condition in conditions.items():
            print_row(name, condition, tuning)


def read_recording(path: Path) -> Recording:
    audio, _ = decode(path.read_bytes(), AudioLimits())
    return Recording(audio, np.loadtxt(path.with_suffix(".f0ref")))


def narrowed(recording: Recording) -> Recording:
    narrow = soxr.resample(recording.audio.samples, SAMPLE_RATE_HZ, 8_000)
    return Recording(Audio(soxr.resample(narrow, 8_000, SAMPLE_RATE_HZ)), recording.reference_hz)


def white(recordings: list[Recording]) -> list[FloatArray]:
    generator = np.random.default_rng(0)
    return [generator.normal(size=len(recording.audio.samples)) for recording in recordings]


def babble(recordings: list[Recording], talkers: int) -> list[FloatArray]:
    """For each recording, `talkers` others at once, begun anywhere and repeated as needed."""
    generator = np.random.default_rng(0)
    voices = [recording.audio.samples / np.std(recording.audio.samples) for recording in recordings]
    return [
        _chorus(voices[:index] + voices[index + 1 :], talkers, len(voices[index]), generator)
        for index in range(len(voices))
    ]


def _chorus(voices: list[FloatArray], talkers: int, length: int, generator: np.random.Generator) -> FloatArray:
    total = np.zeros(length)
    for chosen in generator.permutation(len(voices))[:talkers]:
        voice = voices[chosen]
        total += np.resize(np.roll(voice, generator.integers(len(voice))), length)
    return total


def with_noise(recordings: list[Recording], noises: list[FloatArray], ratio_db: float) -> list[Recording]:
    noisy = []
    for recording, noise in zip(recordings, noises, strict=True):
        samples = recording.audio.samples
        scale = math.sqrt(np.mean(samples**2) / np.mean(noise**2)) * 10 ** (-ratio_db / 20)
        noisy.append(Recording(Audio(samples + scale * noise), recording.reference_hz))
    return noisy


def print_row(name: str, recordings: list[Recording], tuning: pitch.Tuning) -> None:
    began = time.process_time()
    estimates = [pitch.track_f0(recording.audio, tuning) for recording in recordings]
    seconds = time.process_time() - began
    errors = measured(estimates, [recording.reference_hz for recording in recordings])
    speed = seconds / sum(recording.audio.duration_s for recording in recordings)
    print(f"{name:16}{100 * errors.gross:>10.2f}{errors.fine_cents:>12.0f}{100 * errors.voicing:>11.2f}{speed:>13.4f}")


def measured(estimates: list[FloatArray], references: list[FloatArray]) -> Errors:
    """The errors over all frames of all files."""
    reference = np.concatenate(references)
    estimate = np.concatenate(
        [at_references(one, len(other)) for one, other in zip(estimates, references, strict=True)]
    )
    both = (estimate > 0) & (reference > 0)
    ratios = estimate[both] / reference[both]
    gross = np.abs(ratios - 1) > GROSS
    return Errors(
        gross=float(np.mean(gross)),
        fine_cents=float(np.median(np.abs(1200 * np.log2(ratios[~gross])))),
        voicing=float(np.mean((estimate > 0) != (reference > 0))),
    )


def at_references(f0_hz: FloatArray, count: int) -> FloatArray:
    """Our frame nearest to each of `count` reference times; the earlier one of two as near."""
    nearest = np.ceil(np.arange(count) * REFERENCE_SHIFT_S / FRAME_SHIFT_S - 0.5).astype(int)
    nearest_hz: FloatArray = f0_hz[np.minimum(nearest, len(f0_hz) - 1)]
    return nearest_hz


def _parity(path: Path) -> str:
    return "odd" if int(path.stem[2:]) % 2 else "even"


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fda", type=Path, default=FDA, help="folder of .flac and .f0ref files")
    parser.add_argument("--parity", choices=("all", "odd", "even"), default="all", help="files by their number")
    return parser.parse_args()


if __name__ == "__main__":
    main()

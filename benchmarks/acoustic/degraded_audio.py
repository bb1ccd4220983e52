"""How much word and phone times change in degraded speech: music before it, noise, a room, a telephone, antiphase.

    python -m benchmarks.acoustic.degraded_audio [--sentences N] [--timit FOLDER]

Data: the half of TIMIT that the boundary model was not trained on (`training/alignment/timit.py`). Each recording is
degraded, written as a WAV file and read again as a caller's would be. Errors are against the hand labels, as in
`benchmarks/acoustic/alignment.py`; "moved" is the mean distance of a word's edge from where the clean recording has it.

- music: two seconds of a chord of harmonic tones that swells and stops, as loud as the speech, before it
- noise: pink, 15 dB below the speech
- room: an impulse response of exponentially decaying noise, 0.5 s to −60 dB, 6 dB of direct over reverberant sound
- telephone: 300 to 3,400 Hz, 8 kHz, 8-bit mu-law
- antiphase: two channels, one the other's opposite, which cancel when mixed
"""

import argparse
import io
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import soundfile
import soxr
from scipy.signal import butter, fftconvolve, sosfilt

from benchmarks.acoustic.alignment import FLAGS, ROOT, TIMIT, TOLERANCES_S
from training.alignment.timit import Sentence, read_sentences
from understudy.acoustic.alignment.aligner import Aligner
from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.errors import InputError
from understudy.model import SAMPLE_RATE_HZ, FloatArray, Interval, Word
from understudy.text.transcript import read_transcript

MUSIC_S = 2.0
CHORD_HZ = (220.0, 277.2, 329.6)
NOISE_DB = -15.0
DECAY_S = 0.5
DIRECT_OVER_REVERBERANT_DB = 6.0
TELEPHONE_HZ = 8_000
PEAK = 0.5

Degrade = Callable[[FloatArray, np.random.Generator], bytes]


def main() -> None:
    """Prints a row for each condition."""
    options = _options()
    sentences = read_sentences(options.timit)[0][1::2][: options.sentences]
    conditions: dict[str, tuple[Degrade, float]] = {
        "clean": (_clean, 0.0),
        "music before": (_after_music, MUSIC_S),
        "noise 15 dB": (_in_noise, 0.0),
        "room": (_in_a_room, 0.0),
        "telephone": (_by_telephone, 0.0),
        "antiphase": (_in_antiphase, 0.0),
    }
    with Aligner(ROOT / "models", ROOT / "lexicon" / "en") as aligner:
        clean: list[FloatArray] = []
        for name, (degrade, delay_s) in conditions.items():
            found = [_edges_s(aligner, each, degrade, delay_s) for each in sentences]
            clean = clean or [edges_s for edges_s, _ in found]
            _print(name, sentences, found, clean)


def _edges_s(aligner: Aligner, sentence: Sentence, degrade: Degrade, delay_s: float) -> tuple[FloatArray, str]:
    """Start and end of each word as in the sentence itself, NaN when the text is refused; and "refused", "warned" or
    "passed"."""
    content = degrade(PEAK * sentence.audio.samples / np.abs(sentence.audio.samples).max(), np.random.default_rng(1))
    audio, _ = decode(content, AudioLimits())
    try:
        words, notices = aligner.align(audio, read_transcript(sentence.text))
    except InputError:
        return np.full(2 * len(sentence.words), np.nan), "refused"
    edges_s = [time_s for word in words for time_s in _times_s(word)]
    warned = FLAGS & {notice.code for notice in notices}
    return np.array(edges_s) - delay_s, "warned" if warned else "passed"


def _times_s(word: Word) -> tuple[float, float]:
    interval = word.interval or Interval(np.nan, np.nan)
    return interval.start_s, interval.end_s


def _print(
    name: str, sentences: Sequence[Sentence], found: Sequence[tuple[FloatArray, str]], clean: Sequence[FloatArray]
) -> None:
    truth_s = np.array([time_s for each in sentences for word in each.words for time_s in (word.start_s, word.end_s)])
    edges_s = np.concatenate([edges for edges, _ in found])
    outcomes = [outcome for _, outcome in found]
    errors_s = np.abs(edges_s - truth_s)
    within = " / ".join(f"{np.mean(errors_s <= tolerance_s):.1%}" for tolerance_s in TOLERANCES_S)
    moved_ms = np.nanmean(np.abs(edges_s - np.concatenate(clean))) * 1e3
    refused, warned = (outcomes.count(outcome) / len(outcomes) for outcome in ("refused", "warned"))
    print(
        f"{name:14}words within 20 / 50 / 100 ms {within}, mean {np.nanmean(errors_s) * 1e3:.1f} ms, "
        f"moved {moved_ms:.1f} ms; refused {refused:.1%}, warned {warned:.1%} ({len(outcomes)})"
    )


def _wav(samples: FloatArray, rate_hz: int = SAMPLE_RATE_HZ, subtype: str = "PCM_16") -> bytes:
    content = io.BytesIO()
    soundfile.write(content, np.clip(samples, -1.0, 1.0), rate_hz, subtype, format="WAV")
    return content.getvalue()


def _clean(samples: FloatArray, _chance: np.random.Generator) -> bytes:
    return _wav(samples)


def _after_music(samples: FloatArray, _chance: np.random.Generator) -> bytes:
    times_s = np.arange(round(MUSIC_S * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ
    partials = [(hertz * number, 1 / number) for hertz in CHORD_HZ for number in range(1, 7)]
    chord = np.sum([amount * np.sin(2 * np.pi * hertz * times_s) for hertz, amount in partials], axis=0)
    chord *= np.sin(np.pi * times_s / MUSIC_S)
    return _wav(np.concatenate([chord * (_level(samples) / _level(chord)), samples]))


def _in_noise(samples: FloatArray, chance: np.random.Generator) -> bytes:
    spectrum = np.fft.rfft(chance.standard_normal(len(samples)))
    pink = np.fft.irfft(spectrum / np.sqrt(np.maximum(np.arange(len(spectrum)), 1)), len(samples))
    return _wav(samples + pink * (_level(samples) / _level(pink)) * 10 ** (NOISE_DB / 20))


def _in_a_room(samples: FloatArray, chance: np.random.Generator) -> bytes:
    times_s = np.arange(round(DECAY_S * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ
    tail = chance.standard_normal(len(times_s)) * 10 ** (-3 * times_s / DECAY_S)
    tail *= 10 ** (-DIRECT_OVER_REVERBERANT_DB / 20) / np.sqrt(np.sum(tail**2))
    return _wav(samples + fftconvolve(samples, tail)[: len(samples)])


def _by_telephone(samples: FloatArray, _chance: np.random.Generator) -> bytes:
    band = sosfilt(butter(4, (300, 3400), "bandpass", fs=SAMPLE_RATE_HZ, output="sos"), samples)
    return _wav(soxr.resample(band, SAMPLE_RATE_HZ, TELEPHONE_HZ), TELEPHONE_HZ, "ULAW")


def _in_antiphase(samples: FloatArray, _chance: np.random.Generator) -> bytes:
    return _wav(np.column_stack([samples, -samples]))


def _level(samples: FloatArray) -> float:
    return float(np.sqrt(np.mean(samples**2)))


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timit", type=Path, default=TIMIT)
    parser.add_argument("--sentences", type=int, default=None, help="only the first N")
    return parser.parse_args()


if __name__ == "__main__":
    main()

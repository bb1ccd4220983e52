"""Detects transcripts that do not match the audio, from the scores of the alignment.

With wide beams the aligner nearly always finds a path, so its scores must decide. The score of an alignment is the log
likelihood of its phones per frame: about −12 in read and −15 in acted speech for the correct text, −60 for a wrong one.
Noise lowers it by about one per decibel below 20 dB, telephone bandwidth by eight, and the thresholds are lowered
accordingly. A text is rejected only below the scores of all acted, shouted or whispered lines (−44 is the lowest of 150
from RAVDESS; at −36 one in forty would be rejected); in between there is a warning. `benchmarks/acoustic/alignment.py`
prints the detection rates for each kind of wrong text.
"""

from collections.abc import Iterator
from itertools import islice

import numpy as np

from ...errors import InputError
from ...model import SAMPLE_RATE_HZ, Audio, FloatArray, Notice, Word
from ..signal.loudness import FRAME_S, frame_power
from .decoder_process import DecodedPhone

MISMATCH_SCORE = -45.0
SUSPECT_SCORE = -33.0
POOR_PHONE_SCORE = -80.0
POOR_PHONE_PERCENTILE = 10
MOST_POWER_OUTSIDE = 0.10
LONGEST_PHONE_S = 0.6
CLEAN_SNR_DB = 20.0
NOISY_SNR_DB = 15.0
SCORE_PER_DB = 1.0
PHONE_SCORE_PER_DB = 2.0
TELEPHONE_HIGHEST_HZ = 4_300.0
TELEPHONE_ABOVE_DB = -60.0
TELEPHONE_DB = 8.0
"""Telephone bandwidth lowers the scores as much as this much noise."""

TELEPHONE_JUDGED_S = 60.0


def check_fit(audio: Audio, words: tuple[Word, ...], decoded: list[list[DecodedPhone]]) -> tuple[Notice, ...]:
    """A notice `transcript_suspect` if parts do not fit; raises InputError `transcript_mismatch` if nothing does.

    `decoded` has the phones of `words`, token by token. Below `NOISY_SNR_DB` nothing is rejected.
    """
    score = alignment_score(decoded)
    snr_db = signal_to_noise_db(audio)
    lacking_db = max(CLEAN_SNR_DB - snr_db, 0.0) + (TELEPHONE_DB if is_telephone(audio) else 0.0)
    if score < MISMATCH_SCORE and snr_db >= NOISY_SNR_DB:
        raise InputError(
            "transcript_mismatch",
            f"the text is not what is said in the audio (score {score:.0f}, at least {MISMATCH_SCORE:.0f} expected); "
            "send the words of this recording",
            field="text",
        )
    reasons = list(_suspicions(audio, words, decoded, lacking_db=lacking_db))
    if not reasons:
        return ()
    return (Notice("transcript_suspect", "the text may not be just what is said: " + "; ".join(reasons)),)


def alignment_score(decoded: list[list[DecodedPhone]]) -> float:
    """The sum of phone scores divided by the number of speech frames."""
    phones = [phone for word in decoded for phone in word]
    return sum(phone.score for phone in phones) / sum(phone.frames for phone in phones)


def power_outside(audio: Audio, words: tuple[Word, ...]) -> float:
    """The share of the signal's power, above the noise floor, that lies outside all words."""
    power = frame_power(audio)
    power = np.maximum(power - _floor(power), 0.0)
    times_s = (np.arange(len(power)) + 0.5) * FRAME_S
    inside = np.zeros(len(power), dtype=bool)
    for word in words:
        if word.interval is not None:
            inside |= (times_s >= word.interval.start_s) & (times_s < word.interval.end_s)
    return float(power[~inside].sum() / power.sum()) if power.any() else 0.0


def signal_to_noise_db(audio: Audio) -> float:
    """The level of loud frames relative to quiet ones, in dB."""
    power = frame_power(audio)
    return float(10 * np.log10(max(float(np.percentile(power, 90)), _SILENCE) / _floor(power)))


def is_telephone(audio: Audio) -> bool:
    """Whether there is no signal above telephone bandwidth, judged by the beginning of the recording."""
    samples = audio.samples[: round(TELEPHONE_JUDGED_S * SAMPLE_RATE_HZ)]
    power = np.abs(np.fft.rfft(samples)) ** 2
    above = power[round(TELEPHONE_HIGHEST_HZ / SAMPLE_RATE_HZ * len(samples)) :].sum()
    return bool(above < power.sum() * 10 ** (TELEPHONE_ABOVE_DB / 10))


def _suspicions(
    audio: Audio, words: tuple[Word, ...], decoded: list[list[DecodedPhone]], *, lacking_db: float
) -> Iterator[str]:
    """The reasons against the text, in words; `lacking_db` is the quality deficit relative to a clean recording."""
    score = alignment_score(decoded)
    scores = [phone.score / phone.frames for word in decoded for phone in word]
    if score < SUSPECT_SCORE - SCORE_PER_DB * lacking_db:
        yield f"it fits badly (score {score:.0f}), worst at {_names(words, _are_worst(scores))}"
    limit = POOR_PHONE_SCORE - PHONE_SCORE_PER_DB * lacking_db
    if np.percentile(scores, POOR_PHONE_PERCENTILE) < limit:
        yield f"least at {_names(words, [score < limit for score in scores])}"
    stretched = [phone.interval.duration_s > LONGEST_PHONE_S for word in words for phone in word.phones]
    if any(stretched):
        yield f"too long for what they say: {_names(words, stretched)}"
    outside = power_outside(audio, words)
    if outside > MOST_POWER_OUTSIDE:
        yield f"{outside:.0%} of the sound lies outside the words, most of it {_largest_gap(audio, words)}"


def _are_worst(scores: list[float]) -> list[bool]:
    """Whether each phone is among the tenth with the lowest scores."""
    limit = np.percentile(scores, POOR_PHONE_PERCENTILE)
    return [bool(score <= limit) for score in scores]


def _largest_gap(audio: Audio, words: tuple[Word, ...]) -> str:
    """The word next to which most signal outside words lies: "before word 3 (anything)"."""
    power = frame_power(audio)
    above = np.concatenate([[0.0], np.cumsum(np.maximum(power - _floor(power), 0.0))]) * FRAME_S
    timed = [word for word in words if word.interval is not None]
    starts_s = [word.interval.start_s for word in timed if word.interval]
    ends_s = [word.interval.end_s for word in timed if word.interval]
    edges_s = np.arange(len(above)) * FRAME_S
    gaps = np.interp([*starts_s, audio.duration_s], edges_s, above) - np.interp([0.0, *ends_s], edges_s, above)
    place = int(np.argmax(gaps))
    if place < len(timed):
        return f"before word {timed[place].index} ({timed[place].text})"
    return f"after word {timed[-1].index} ({timed[-1].text})"


def _names(words: tuple[Word, ...], phone_is_odd: list[bool]) -> str:
    """The words with an odd phone: "word 3 (anything), 4 (like)"; one flag for every phone of `words`, in order."""
    flags = iter(phone_is_odd)
    odd = [word for word in words if any(list(islice(flags, len(word.phones))))]
    return "word " + ", ".join(f"{word.index} ({word.text})" for word in odd)


_SILENCE = 1e-10


def _floor(power: FloatArray) -> float:
    return max(float(np.percentile(power, 10)), _SILENCE)

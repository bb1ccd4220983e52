"""Detects transcripts that do not match the audio.

The aligner finds a path for nearly any text, so the fit of the phones must decide. A wrong text fits badly nearly
everywhere, and its phones are squeezed and stretched; a correct one in a bad recording fits badly here and there. The
weights of `misfit` are those of a logistic regression on clean, acted, synthetic and noisy speech with correct and
wrong texts, and on recordings in which nothing is said (`python -m training.alignment.misfit --every 2 --plain
FOLDER`). Scores are log likelihoods per frame of .01 s, relative to those of the sounds that fit best.

Above `REFUSED` the text is refused, above `SUSPECT` there is a warning. In noise and over the telephone correct texts
fit worse too, and so they do where a voice is raised so high that the aligner's acoustic model, taught by people who
read aloud, has not heard its like: there nothing is refused. Missing words show in sound outside all words, and in
phones too long for speech. `python -m benchmarks.acoustic.transcripts` prints how often correct and wrong texts are
refused and warned about.
"""

from collections.abc import Iterator, Sequence
from itertools import islice
from math import log

import numpy as np

from ...errors import InputError
from ...model import SAMPLE_RATE_HZ, Audio, FloatArray, Notice, Word
from ..pitch.tracking import track_f0
from ..signal.spectrum import FRAME_S, frame_power
from .decoder_process import DecodedPhone

REFUSED = 0.5
SUSPECT = -1.5
"""Log-odds that the text is a wrong one. Of 199 recordings of people and of flite, none has more than -4.3 with its own
text; of 398 with another one, 3.0 % are below `REFUSED` and .3 % below `SUSPECT`. Of 150 sentences by five voices of
espeak-ng, whose sounds are nobody's, 1.3 % are refused (23 % before the weights were fitted to such voices too)."""

RAISED_HZ, RAISED_PERCENTILE = 250.0, 75
"""Of 960 recordings of actors, from calm to shouting and weeping, with their own text, 19 were above `REFUSED` with
weights that were not fitted to voices of espeak-ng, all with at least 312 Hz here; none below 290 Hz."""

WORST_PERCENTILE = 10
MOST_POWER_OUTSIDE = 0.10
LONGEST_PHONE_S = 0.6
CLEAN_SNR_DB = 20.0
NOISY_SNR_DB = 15.0
SUSPECT_PER_DB = 0.2
TELEPHONE_HIGHEST_HZ = 4_300.0
TELEPHONE_ABOVE_DB = -60.0
TELEPHONE_DB = 8.0
"""Telephone bandwidth lowers the scores as much as this much noise."""

TELEPHONE_JUDGED_S = 60.0

_SILENCE = 1e-10

FRAMES_PER_S = 100
POOR_SCORE = -40.0
"""Phones with lower scores fit poorly: one in eleven of a correct text, two in three of a wrong one."""

SHORTEST_FRAMES = 3
"""A phone of the acoustic model has three states of at least one frame each."""

EVIDENCE = (
    "mean score of frames",
    "score of the tenth of the phones that fits worst",
    "score of the quarter of the phones that fits worst",
    "share of phones that fit poorly",
    "log of phones a second",
    "share of phones as short as can be",
    "spread of the log of durations",
)
WEIGHTS = (-0.0961, 0.0081, -0.0372, 3.6723, -2.6620, 17.5864, 16.7890)
BIAS = -16.0433


def check_fit(audio: Audio, words: tuple[Word, ...], decoded: list[list[DecodedPhone]]) -> tuple[Notice, ...]:
    """A notice `transcript_suspect` if parts do not fit; raises InputError `transcript_mismatch` if nothing does.

    `decoded` has the phones of `words`, token by token. Nothing is rejected below `NOISY_SNR_DB`, nor of a raised
    voice.
    """
    phones = [phone for word in decoded for phone in word]
    reasons = []
    if _is_suspect(audio, misfit(phones)):
        reasons.append(f"it fits poorly, worst at {_names(words, _are_worst(phones))}")
    reasons += _missing(audio, words)
    if not reasons:
        return ()
    return (Notice("transcript_suspect", "the text may differ from what is said: " + "; ".join(reasons)),)


def _is_suspect(audio: Audio, log_odds: float) -> bool:
    """Whether a text may be a wrong one; raises InputError `transcript_mismatch` if it is. How noisy and narrow the
    recording is, which takes longer to find out than all else here, matters only above `SUSPECT`."""
    if log_odds <= SUSPECT:
        return False
    snr_db = signal_to_noise_db(audio)
    if log_odds > REFUSED and snr_db >= NOISY_SNR_DB and not is_raised(audio):
        raise _mismatch("most of its sounds do not fit")
    lacking_db = max(CLEAN_SNR_DB - snr_db, 0.0) + (TELEPHONE_DB if is_telephone(audio) else 0.0)
    return log_odds > min(SUSPECT + SUSPECT_PER_DB * lacking_db, REFUSED)


def check_found(audio: Audio) -> None:
    """Interprets that the aligner finds no path for a text: except in noise, the text is a wrong one.

    Raises InputError `transcript_mismatch`, but not below `NOISY_SNR_DB`. Of the 397 recordings with their own text,
    all had a path; of those with another text one in nine had none, and of those with eight words too many nearly all.
    """
    if signal_to_noise_db(audio) >= NOISY_SNR_DB:
        raise _mismatch("its words do not fit into the time")


def _mismatch(reason: str) -> InputError:
    message = f"the text is not what is said in the audio: {reason}; send the words of this recording"
    return InputError("transcript_mismatch", message, field="text")


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


def is_raised(audio: Audio) -> bool:
    """Whether a quarter of the voice is above `RAISED_HZ`: shouted, wailed, screamed, or a child's."""
    f0_hz = track_f0(audio)
    voiced_hz = f0_hz[f0_hz > 0]
    return bool(len(voiced_hz) and np.percentile(voiced_hz, RAISED_PERCENTILE) > RAISED_HZ)


def is_telephone(audio: Audio) -> bool:
    """Whether there is no signal above telephone bandwidth, judged by the beginning of the recording."""
    samples = audio.samples[: round(TELEPHONE_JUDGED_S * SAMPLE_RATE_HZ)]
    power = np.abs(np.fft.rfft(samples)) ** 2
    above = power[round(TELEPHONE_HIGHEST_HZ / SAMPLE_RATE_HZ * len(samples)) :].sum()
    return bool(above < power.sum() * 10 ** (TELEPHONE_ABOVE_DB / 10))


def _missing(audio: Audio, words: tuple[Word, ...]) -> Iterator[str]:
    """The reasons to think that words are missing from the text."""
    stretched = [phone.interval.duration_s > LONGEST_PHONE_S for word in words for phone in word.phones]
    if any(stretched):
        yield f"too long for the sounds in them: {_names(words, stretched)}"
    outside = power_outside(audio, words)
    if outside > MOST_POWER_OUTSIDE:
        yield f"{outside:.0%} of the sound lies outside the words, most of it {_largest_gap(audio, words)}"


def _are_worst(phones: Sequence[DecodedPhone]) -> list[bool]:
    """Whether each phone is among the tenth with the lowest scores."""
    scores = [phone.score / phone.frames for phone in phones]
    limit = np.percentile(scores, WORST_PERCENTILE)
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


def _floor(power: FloatArray) -> float:
    return max(float(np.percentile(power, 10)), _SILENCE)


def misfit(phones: Sequence[DecodedPhone]) -> float:
    """The log-odds that the text with these phones, at least one, differs from what is said."""
    return BIAS + float(np.dot(WEIGHTS, evidence(phones)))


def evidence(phones: Sequence[DecodedPhone]) -> tuple[float, ...]:
    """The measures named in `EVIDENCE`, in its order."""
    frames = np.array([phone.frames for phone in phones])
    scores = np.array([phone.score / phone.frames for phone in phones])
    return (
        float((scores * frames).sum() / frames.sum()),
        float(np.percentile(scores, 10)),
        float(np.percentile(scores, 25)),
        float((scores < POOR_SCORE).mean()),
        log(len(phones) / frames.sum() * FRAMES_PER_S),
        float((frames <= SHORTEST_FRAMES).mean()),
        float(np.log(frames).std()),
    )

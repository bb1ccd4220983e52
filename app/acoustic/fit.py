"""Does the text fit the audio? With wide beams the aligner nearly always finds a path, so its score must tell.

The score of an alignment is the log likelihood of its phones per frame: about −18 where the text is what was said,
−57 where it is another text (../shared/alignment.md; `benchmarks/alignment.py` prints both).
"""

import numpy as np

from app.acoustic.decoder_process import DecodedPhone
from app.acoustic.loudness import FRAME_S, frame_power
from app.errors import InputError
from app.model import Audio, FloatArray, Notice, Word

MISMATCH_SCORE = -36.0
POOR_PHONE_SCORE = -80.0
POOR_PHONE_PERCENTILE = 10
MOST_POWER_OUTSIDE = 0.25
NOISY_SNR_DB = 15.0


def check_fit(audio: Audio, words: tuple[Word, ...], decoded: list[list[DecodedPhone]]) -> tuple[Notice, ...]:
    """A notice `transcript_suspect` when parts do not fit; raises InputError `transcript_mismatch` when nothing does.

    In noise the score says less: under `NOISY_SNR_DB` a mismatch is a suspicion only.
    """
    score = alignment_score(decoded)
    if score < MISMATCH_SCORE and signal_to_noise_db(audio) >= NOISY_SNR_DB:
        raise InputError(
            "transcript_mismatch",
            f"the text is not what is said in the audio (score {score:.0f}, at least {MISMATCH_SCORE:.0f} expected); "
            "send the words of this recording",
            field="text",
        )
    poor = _poor_words(words, decoded)
    outside = power_outside(audio, words)
    reasons = []
    if score < MISMATCH_SCORE:
        reasons.append("the recording is noisy and the words fit it badly")
    if poor_phone_score(decoded) < POOR_PHONE_SCORE:
        reasons.append(f"badly fitting: word {', '.join(f'{word.index} ({word.text})' for word in poor)}")
    if outside > MOST_POWER_OUTSIDE:
        reasons.append(f"{outside:.0%} of the sound lies outside the words")
    if not reasons:
        return ()
    return (Notice("transcript_suspect", "the text may not be all that is said: " + "; ".join(reasons)),)


def alignment_score(decoded: list[list[DecodedPhone]]) -> float:
    """Summed phone scores over the frames of speech."""
    phones = [phone for word in decoded for phone in word]
    return sum(phone.score for phone in phones) / sum(phone.frames for phone in phones)


def poor_phone_score(decoded: list[list[DecodedPhone]]) -> float:
    """The score per frame that a tenth of the phones do not reach."""
    return float(np.percentile([_per_frame(phone) for word in decoded for phone in word], POOR_PHONE_PERCENTILE))


def power_outside(audio: Audio, words: tuple[Word, ...]) -> float:
    """Share of the sound's power, the noise floor taken off, that lies in no word."""
    power = frame_power(audio)
    power = np.maximum(power - _floor(power), 0.0)
    times_s = (np.arange(len(power)) + 0.5) * FRAME_S
    inside = np.zeros(len(power), dtype=bool)
    for word in words:
        if word.interval is not None:
            inside |= (times_s >= word.interval.start_s) & (times_s < word.interval.end_s)
    return float(power[~inside].sum() / power.sum()) if power.any() else 0.0


def signal_to_noise_db(audio: Audio) -> float:
    """Loud frames against quiet ones, dB."""
    power = frame_power(audio)
    return float(10 * np.log10(np.percentile(power, 90) / _floor(power)))


def _floor(power: FloatArray) -> float:
    return max(float(np.percentile(power, 10)), 1e-10)


def _poor_words(words: tuple[Word, ...], decoded: list[list[DecodedPhone]]) -> list[Word]:
    """The words that hold the phones under `POOR_PHONE_SCORE`."""
    scores = iter(_per_frame(phone) for word in decoded for phone in word)
    return [word for word in words if min([next(scores) for _ in word.phones], default=0.0) < POOR_PHONE_SCORE]


def _per_frame(phone: DecodedPhone) -> float:
    return phone.score / phone.frames

"""Tells sound from silence: the power of the signal every 10 ms, the signal-to-background ratio, and whether it
suffices to judge agitation.
"""

import numpy as np

from ...model import SAMPLE_RATE_HZ, Audio, FloatArray, Notice

LEAST_TRUSTED_DB = 12.0
"""The lowest ratio in the training data of the agitation models (`training/agitation/degradations.py`).

At 6 dB they lose .2 of balanced accuracy on RAVDESS. No quiet recording that they were trained on is below 16 dB.
"""

_FAINTEST_PERCENT = 5
_DEEPEST_DB = 60.0
"""Frames further below the loudest are digital silence, not background."""

FRAME_S = 0.010


def above_background_db(energy_db: FloatArray) -> float:
    """The mean power relative to that of the faintest frames, which are background in pauses and stop closures; dB.

    For steady noise and sentences of two seconds the error is .5 dB. Without pauses the background is overestimated.
    """
    heard_db = energy_db[energy_db >= energy_db.max() - _DEEPEST_DB]
    return float(10 * np.log10(np.mean(10 ** (heard_db / 10))) - np.percentile(heard_db, _FAINTEST_PERCENT))


def doubts(energy_db: FloatArray) -> tuple[Notice, ...]:
    """The notice `agitation_unsure` if the energy (frames,) indicates too much noise."""
    above_db = above_background_db(energy_db)
    if above_db >= LEAST_TRUSTED_DB:
        return ()
    message = (
        f"the voice is only {above_db:.0f} dB above the noise: its agitation may be heard wrongly; give it if known"
    )
    return (Notice("agitation_unsure", message),)


def frame_power(audio: Audio) -> FloatArray:
    """The mean square of successive intervals of `FRAME_S`; a shorter rest is left out, unless it is all there is."""
    length = round(FRAME_S * SAMPLE_RATE_HZ)
    samples = audio.samples if len(audio.samples) >= length else np.resize(audio.samples, length)
    frames = samples[: len(samples) // length * length].reshape(-1, length)
    power: FloatArray = np.einsum("ij,ij->i", frames, frames) / length  # without a copy of an hour's samples
    return power

"""How far speech stands out of what is heard behind it, and whether that is enough to tell agitation by."""

import numpy as np

from ...model import FloatArray, Notice

LEAST_TRUSTED_DB = 12.0
"""The agitation models have heard voices this far above noise, and none nearer (`training/agitation/degradations.py`).
At 6 dB they lose .2 of balanced accuracy on RAVDESS. Of the quiet recordings they know, none is told under 16 dB."""

_FAINTEST_PERCENT = 5
_DEEPEST_DB = 60.0
"""What is fainter than this under the loudest frame is no background but digital silence."""


def above_background_db(energy_db: FloatArray) -> float:
    """Mean power over that of the faintest frames, which pauses and stops leave to the background; dB.

    Steady noise is told to .5 dB in sentences of two seconds. Where nobody pauses, it counts as louder than it is.
    """
    heard_db = energy_db[energy_db >= energy_db.max() - _DEEPEST_DB]
    return float(10 * np.log10(np.mean(10 ** (heard_db / 10))) - np.percentile(heard_db, _FAINTEST_PERCENT))


def doubts(energy_db: FloatArray) -> tuple[Notice, ...]:
    """The notice `agitation_unsure` where the energy (frames,) tells of too much noise."""
    above_db = above_background_db(energy_db)
    if above_db >= LEAST_TRUSTED_DB:
        return ()
    message = (
        f"the voice is only {above_db:.0f} dB above the noise: its agitation may be heard wrongly; give it if known"
    )
    return (Notice("agitation_unsure", message),)

"""Under which conditions each recording is heard: as what it teaches, and as what it is tested.

A condition changes a recording in a way drawn with the generator given. As another voice it is resampled: pitch,
formants and tempo move together, as from a man to a woman or a child, while level and manner stay. Few speakers teach
us; copies in other voices tell what does not matter about a voice.
"""

from collections.abc import Callable, Mapping

import numpy as np
import soxr

from training.agitation.degradations import by_telephone, degraded, in_white_noise
from understudy.model import SAMPLE_RATE_HZ, Audio

Condition = Callable[[Audio, np.random.Generator], Audio]

DEEPER, HIGHER = 0.9, 1.12
"""By what frequencies are multiplied."""


def as_recorded(audio: Audio, _random: np.random.Generator) -> Audio:
    """The recording itself."""
    return audio


def deeper(audio: Audio, _random: np.random.Generator) -> Audio:
    """A larger speaker's voice, and slower."""
    return _resampled(audio, DEEPER)


def higher(audio: Audio, _random: np.random.Generator) -> Audio:
    """A smaller speaker's voice, and faster."""
    return _resampled(audio, HIGHER)


def _resampled(audio: Audio, factor: float) -> Audio:
    return Audio(soxr.resample(audio.samples, SAMPLE_RATE_HZ * factor, SAMPLE_RATE_HZ, quality="HQ"))


TRAINING_CONDITIONS: Mapping[str, Condition] = {
    "clean": as_recorded,
    "degraded": degraded,
    "deeper": deeper,
    "higher": higher,
}
"""As what each recording is trained on."""

TEST_CONDITIONS: Mapping[str, Condition] = {"white noise": in_white_noise, "telephone": by_telephone}
"""As what each recording is tested on besides."""

"""The conditions under which each recording is used, for training and for testing.

A condition changes a recording in a way drawn with the given generator. For another voice it is resampled: pitch,
formants and tempo change together, as from a man to a woman or a child, while level and manner stay. There are few
speakers in the training data; copies in other voices teach the model which properties of a voice do not matter.
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

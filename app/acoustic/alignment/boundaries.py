"""Refines phone boundaries to where the spectrum changes, as human labellers place them.

The decoder's hidden Markov models place boundaries with an error of about 10 ms, and word edges next to silence 30 ms
too far out. Kernel ridge regression predicts each boundary's correction from the features in `boundary_views`. Its
kernel is Gaussian without a bias, so that corrections vanish where the signal is unlike the training data.
`training/alignment` trains the model; `models/alignment/` documents its accuracy.

It replaces a second decoder pass at another frame rate (two-rate refinement that snapped to the greatest spectral
change: 72 % of words within 20 ms for twice the decoding time). It is more accurate (docs/measurements/hearing.md), at
a tenth of the time.
"""

import zipfile
from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np

from ...errors import ServiceError
from ...model import Audio, Word
from .boundary_views import BoundaryArrays, BoundaryView, Points, mel_levels
from .phone_boundaries import boundaries, spaced_times, with_boundaries

BOUNDARIES_AT_ONCE = 200
"""Batch size, to limit memory for long audio."""

FARTHEST_MOVE_S = 0.070


@dataclass(frozen=True, slots=True, eq=False)
class BoundaryModel:
    """The trained regression: a correction is the weighted sum of `exp(−|x − support|²)` over the supports;
    immutable."""

    view: BoundaryView
    supports: Points
    weights_s: Points

    @classmethod
    def load(cls, path: Path) -> Self:
        """Load the model. Raises ServiceError `model_unreadable`."""
        try:
            with np.load(path, allow_pickle=False) as arrays:
                names = ("mean", "basis", "supports", "weights_s")
                mean, basis, supports, weights_s = (arrays[name].astype(np.float32) for name in names)
                view = BoundaryView(mean, basis, float(arrays["kind_weight"]), float(arrays["gap_weight"]))
                return cls(view, supports, weights_s)
        except (OSError, KeyError, ValueError, zipfile.BadZipFile) as error:
            raise ServiceError("model_unreadable", f"{path} is no boundary model: {error}") from None

    def refine(self, audio: Audio, words: tuple[Word, ...]) -> tuple[Word, ...]:
        """The words, all timed and with phones, with every boundary corrected; order and silences are preserved."""
        levels, places = mel_levels(audio.samples), BoundaryArrays.of(boundaries(words))
        moved_s = places.times_s.copy()
        for first in range(0, len(moved_s), BOUNDARIES_AT_ONCE):
            block = places.part(first, first + BOUNDARIES_AT_ONCE)
            wanted_s = kernel(self.view.points(levels, block), self.supports) @ self.weights_s
            moved_s[first : first + BOUNDARIES_AT_ONCE] += np.clip(wanted_s, -FARTHEST_MOVE_S, FARTHEST_MOVE_S)
        return with_boundaries(words, spaced_times(moved_s, audio.duration_s))


def kernel(one: Points, other: Points) -> Points:
    """The Gaussian kernel exp(−|x − y|²) for every x of `one` and y of `other`."""
    similarity: Points = 2 * one @ other.T
    similarity -= np.sum(one**2, axis=1)[:, None]
    similarity -= np.sum(other**2, axis=1)
    return np.exp(np.minimum(similarity, 0.0, out=similarity), out=similarity)

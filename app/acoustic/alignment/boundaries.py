"""Puts the boundaries of phones where the spectrum changes: what a human labeller does and a decoder cannot.

The decoder's hidden Markov models place a boundary some 10 ms off, and a word's edge against silence 30 ms too far
out. A kernel ridge regression moves each boundary by what labellers would, from what `boundary_views` shows of it. Its
kernel is Gaussian without a bias, so that where the signal is like nothing it was trained on, the decoder's time
stands. `training/alignment` makes the model, `models/alignment/` tells how well it does.

It takes the place of a second pass of the decoder at another frame rate (two-rate refinement with a snap to where the
spectrum changes most, 72 % of words within 20 ms for twice the decoder's time): it brings them further, see
docs/measurements.md, at a tenth of the time.
"""

import zipfile
from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np

from ...errors import ServiceError
from ...model import Audio, Word
from .boundary_views import BoundaryView, Places, Points, mel_levels
from .phone_boundaries import boundaries, in_order, rebuilt

BOUNDARIES_AT_ONCE = 200
"""So few, lest an hour of speech take hundreds of megabytes."""

FARTHEST_MOVE_S = 0.070


@dataclass(frozen=True, slots=True, eq=False)
class BoundaryModel:
    """The trained regression: a move is the weighted sum of `exp(−|x − support|²)` over the supports; immutable."""

    view: BoundaryView
    supports: Points
    weights_s: Points

    @classmethod
    def load(cls, path: Path) -> Self:
        """Raises ServiceError `model_unreadable`."""
        try:
            with np.load(path, allow_pickle=False) as arrays:
                names = ("mean", "basis", "supports", "weights_s")
                mean, basis, supports, weights_s = (arrays[name].astype(np.float32) for name in names)
                view = BoundaryView(mean, basis, float(arrays["kind_weight"]), float(arrays["gap_weight"]))
                return cls(view, supports, weights_s)
        except (OSError, KeyError, ValueError, zipfile.BadZipFile) as error:
            raise ServiceError("model_unreadable", f"{path} is no boundary model: {error}") from None

    def refine(self, audio: Audio, words: tuple[Word, ...]) -> tuple[Word, ...]:
        """`words`, all of them in time and with phones, with every boundary moved; order and silences are kept."""
        levels, places = mel_levels(audio.samples), Places.of(boundaries(words))
        moved_s = places.times_s.copy()
        for first in range(0, len(moved_s), BOUNDARIES_AT_ONCE):
            block = places.part(first, first + BOUNDARIES_AT_ONCE)
            wanted_s = kernel(self.view.points(levels, block), self.supports) @ self.weights_s
            moved_s[first : first + BOUNDARIES_AT_ONCE] += np.clip(wanted_s, -FARTHEST_MOVE_S, FARTHEST_MOVE_S)
        return rebuilt(words, in_order(moved_s, audio.duration_s))


def kernel(one: Points, other: Points) -> Points:
    """exp(−|x − y|²) for every x of `one` and y of `other`."""
    similarity: Points = 2 * one @ other.T
    similarity -= np.sum(one**2, axis=1)[:, None]
    similarity -= np.sum(other**2, axis=1)
    return np.exp(np.minimum(similarity, 0.0, out=similarity), out=similarity)

"""How a line's narrow focus is shared among its words: how likely each is the one that is stressed against the others.

A small network (`training/focus`, models/focus/README.md) judges each word by its cues (`cues.py`), by those of words
on either side, and by how emphasised listeners would find them (`listeners.py`); a softmax over the line makes shares.
It was taught on deliveries of the same words with other foci, and on real speech. Where the recording itself is not at
hand, as in live streams, it judges by the cues alone.
"""

import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

import numpy as np

from ...errors import ServiceError
from ...model import Contours, FloatArray, Word
from .cues import CUES, cues

DECIMALS = 4
"""Shares are rounded, so that they are the same on every machine."""

INPUTS = len(CUES) + 1
"""The cues, and the listeners' judgement."""


@dataclass(frozen=True, slots=True, eq=False)
class FocusModel:
    """The network: several trained alike, of which the mean is taken. M networks, H hidden values, K words at a time:
    `first` (M, H, inputs, K), `second` (M, H, H, K), `last` (M, 1, H, 1), each with its bias (M, outputs). `usual_s`
    has the usual seconds of each phone."""

    usual_s: Mapping[str, float]
    first: FloatArray
    first_bias: FloatArray
    second: FloatArray
    second_bias: FloatArray
    last: FloatArray
    last_bias: FloatArray

    @classmethod
    def load(cls, path: Path) -> "FocusModel":
        """Raises ServiceError `model_unreadable` where the file is missing or not such a model."""
        try:
            with np.load(path, allow_pickle=False) as arrays:
                layers = {
                    name: arrays[name].astype(float) for name in arrays.files if name not in ("phones", "usual_s")
                }
                usual_s = dict(zip(arrays["phones"].tolist(), arrays["usual_s"].tolist(), strict=True))
            model = cls(MappingProxyType(usual_s), **layers)
        except (OSError, EOFError, KeyError, ValueError, TypeError, zipfile.BadZipFile) as error:
            raise ServiceError("model_unreadable", f"{path} is not a model of focus: {error}") from error
        if model.first.ndim != 4 or model.first.shape[2] != INPUTS:
            raise ServiceError("model_unreadable", f"{path} is not a model of focus: it does not take {INPUTS} inputs")
        return model

    def with_focus(
        self, words: tuple[Word, ...], contours: Contours, heard: Mapping[int, float] | None = None
    ) -> tuple[Word, ...]:
        """The words with their shares of the focus, 0 for those without an interval. `heard` has the listeners' log
        odds by the index of the word, where the recording was heard."""
        timed = tuple(word for word in words if word.interval)
        if not timed:
            return words
        shares = self.shares(inputs(timed, contours, self.usual_s, heard))
        by_index = {word.index: round(float(share), DECIMALS) for word, share in zip(timed, shares, strict=True)}
        return tuple(replace(word, focus=by_index.get(word.index, 0.0)) for word in words)

    def shares(self, given: FloatArray) -> FloatArray:
        """The shares (words,), which sum to 1, from the inputs (words × `INPUTS`)."""
        mean = np.mean([_log_shares(self._scores(network, given)) for network in range(len(self.first))], axis=0)
        likely = np.exp(mean - mean.max())
        shares: FloatArray = likely / likely.sum()
        return shares

    def _scores(self, network: int, given: FloatArray) -> FloatArray:
        heard = np.maximum(_convolved(given.T, self.first[network], self.first_bias[network]), 0)
        judged = np.maximum(_convolved(heard, self.second[network], self.second_bias[network]), 0)
        scores: FloatArray = _convolved(judged, self.last[network], self.last_bias[network])[0]
        return scores


def inputs(
    words: tuple[Word, ...], contours: Contours, usual_s: Mapping[str, float], heard: Mapping[int, float] | None
) -> FloatArray:
    """The network's inputs (words × `INPUTS`) for words that all have an interval."""
    listeners = np.array([heard[word.index] for word in words]) if heard else np.zeros(len(words))
    relative = listeners - np.median(listeners)
    given: FloatArray = np.column_stack([cues(words, contours, usual_s), relative])
    return given


def _convolved(values: FloatArray, weights: FloatArray, bias: FloatArray) -> FloatArray:
    """`values` (inputs, words) with weights (outputs, inputs, K) over K words around each; beyond the line is 0."""
    width, count = weights.shape[2], values.shape[1]
    padded = np.pad(values, ((0, 0), (width // 2, width // 2)))
    summed: FloatArray = bias[:, None] + np.zeros((len(bias), count))
    for place in range(width):
        summed = summed + weights[:, :, place] @ padded[:, place : place + count]
    return summed


def _log_shares(scores: FloatArray) -> FloatArray:
    relative = scores - scores.max()
    shares: FloatArray = relative - np.log(np.exp(relative).sum())
    return shares

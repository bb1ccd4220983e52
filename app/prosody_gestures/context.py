"""Adds temporal context to a frame's prosody: the recent past and `LOOKAHEAD_S` of the future.

A stroke ends on a stressed syllable, so most of the evidence for it comes after it has begun (the gain from the
look-ahead is measured in models/prosody_gestures/README.md). Live decoding is delayed by as much.
"""

from collections import deque
from math import log1p

import numpy as np

from ..model import FloatArray
from .prosody import FEATURES, VOICED
from .semi_markov import FRAME_S

LOOKAHEAD_S = 0.15
LOOKAHEAD_FRAMES = round(LOOKAHEAD_S / FRAME_S)
MEANS_OVER = (4, 8, 16, 32)
"""Frames over which energy, f0 and confidence are averaged."""

PAUSE_FRAMES = 8
"""A silence this long starts a new phrase."""

WIDTH = 2 * (len(FEATURES) + 3 * len(MEANS_OVER) + 2)


class ProsodyContext:
    """Adds the context to a stream of features."""

    def __init__(self) -> None:
        longest = max(MEANS_OVER)
        self._lately = deque[FloatArray](np.zeros((longest, 3)), maxlen=longest)
        self._since_pause = self._silent = 0
        self._waiting: deque[FloatArray] = deque()

    def push(self, features: FloatArray) -> FloatArray | None:
        """Takes one more frame's features; returns the row (`WIDTH`) of the frame `LOOKAHEAD_FRAMES` ago, if any."""
        self._waiting.append(self._past(features))
        return self._oldest() if len(self._waiting) > LOOKAHEAD_FRAMES else None

    def finish(self) -> list[FloatArray]:
        """The rows of the remaining frames, the last frame being repeated as their look-ahead."""
        rows = []
        while self._waiting:
            rows.append(self._oldest())
        return rows

    def _oldest(self) -> FloatArray:
        return np.concatenate([self._waiting.popleft(), self._waiting[-1] if self._waiting else self._last])

    def _past(self, features: FloatArray) -> FloatArray:
        self._lately.append(features[:3])
        lately = np.cumsum(np.array(self._lately)[::-1], axis=0)
        means = [lately[frames - 1] / frames for frames in MEANS_OVER]
        self._silent = 0 if features[2] > 2 * VOICED - 1 else self._silent + 1
        self._since_pause = 0 if self._silent >= PAUSE_FRAMES else self._since_pause + 1
        self._last = np.concatenate([features, *means, [log1p(self._since_pause), log1p(self._silent)]])
        return self._last


def in_context(features: FloatArray) -> FloatArray:
    """The rows with context (frames × `WIDTH`) of a recording's features (frames × `FEATURES`)."""
    context = ProsodyContext()
    rows = [row for frame in features if (row := context.push(frame)) is not None]
    return np.array([*rows, *context.finish()]).reshape(-1, WIDTH)

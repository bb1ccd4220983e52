"""What a frame's prosody is set in: how it has gone lately and how it goes on for `LOOKAHEAD_S` more.

A stroke ends on a stressed syllable, so most of what tells of it is heard after it has begun (what looking ahead brings
is measured in models/prosody_gestures/README.md). The live decode waits as long.
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
"""A silence as long begins a phrase anew."""

WIDTH = 2 * (len(FEATURES) + 3 * len(MEANS_OVER) + 2)


class ProsodyContext:
    """Sets features in their context as they come."""

    def __init__(self) -> None:
        longest = max(MEANS_OVER)
        self._lately = deque[FloatArray](np.zeros((longest, 3)), maxlen=longest)
        self._since_pause = self._silent = 0
        self._waiting: deque[FloatArray] = deque()

    def push(self, features: FloatArray) -> FloatArray | None:
        """The row (`WIDTH`) of the frame `LOOKAHEAD_FRAMES` ago, once there is one, after one more frame's features."""
        self._waiting.append(self._past(features))
        return self._oldest() if len(self._waiting) > LOOKAHEAD_FRAMES else None

    def finish(self) -> list[FloatArray]:
        """The rows of the last frames, as if the last one went on."""
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
    """The rows (frames × `WIDTH`) of a recording's features (frames × `FEATURES`)."""
    context = ProsodyContext()
    rows = [row for frame in features if (row := context.push(frame)) is not None]
    return np.array([*rows, *context.finish()]).reshape(-1, WIDTH)

"""What chance decides of a gesture: it depends on the seed and on the gesture alone, so that editing one leaves the
others as they were."""

from zlib import crc32

import numpy as np

from ..gestures.gesture_plan import PlacedGesture


def drawn(seed: int, gesture: PlacedGesture, what: int = 0) -> np.random.Generator:
    """The generator of a gesture; `what` is drawn, where more than one thing is."""
    asked = gesture.request
    named = f"{asked.behavior} {asked.category} {asked.stroke_s:.3f}"
    return np.random.default_rng((seed, crc32(named.encode()), what) if what else (seed, crc32(named.encode())))

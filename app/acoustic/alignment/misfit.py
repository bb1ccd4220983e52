"""The probability that a text differs from what is said, judged by its aligned phones.

The aligner finds a path for nearly any text, so the fit of the phones must decide. A wrong text fits badly nearly
everywhere, and its phones are squeezed and stretched; a correct one in a bad recording fits badly here and there. The
weights are those of a logistic regression on clean, acted, synthetic and noisy speech with correct and wrong texts
(`python -m training.alignment.misfit`). Scores are log likelihoods per frame of .01 s, relative to those of the sounds
that fit best.
"""

from collections.abc import Sequence
from math import log

import numpy as np

from .decoder_process import DecodedPhone

FRAMES_PER_S = 100
POOR_SCORE = -40.0
"""Phones with lower scores fit poorly: one in eleven of a correct text, two in three of a wrong one."""

SHORTEST_FRAMES = 3
"""A phone of the acoustic model has three states of at least one frame each."""

EVIDENCE = (
    "mean score of frames",
    "score of the tenth of the phones that fits worst",
    "score of the quarter of the phones that fits worst",
    "share of phones that fit poorly",
    "log of phones a second",
    "share of phones as short as can be",
    "spread of the log of durations",
)
WEIGHTS = (-0.1011, -0.0324, -0.0387, 6.0237, 0.4775, 5.1994, 12.3770)
BIAS = -20.7708


def misfit(phones: Sequence[DecodedPhone]) -> float:
    """The log-odds that the text with these phones, at least one, differs from what is said."""
    return BIAS + float(np.dot(WEIGHTS, evidence(phones)))


def evidence(phones: Sequence[DecodedPhone]) -> tuple[float, ...]:
    """The measures named in `EVIDENCE`, in its order."""
    frames = np.array([phone.frames for phone in phones])
    scores = np.array([phone.score / phone.frames for phone in phones])
    return (
        float((scores * frames).sum() / frames.sum()),
        float(np.percentile(scores, 10)),
        float(np.percentile(scores, 25)),
        float((scores < POOR_SCORE).mean()),
        log(len(phones) / frames.sum() * FRAMES_PER_S),
        float((frames <= SHORTEST_FRAMES).mean()),
        float(np.log(frames).std()),
    )

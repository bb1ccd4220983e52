"""Trains a part of the voice-driven gesture model: discriminants of the prosody, and a semi-Markov model over them.

Linear discriminant analysis (Fisher): the mixtures with diagonal covariance are fitted to its projections. AHG §3.4
uses the first two principal components, which ignore the states; discriminants separate the states and are uncorrelated
within them, as diagonal mixtures assume.
"""

from collections.abc import Sequence

import numpy as np

from understudy.model import FloatArray
from understudy.prosody_gestures.estimation import CountSmoothing, MixtureOptions, count, fit_mixtures
from understudy.prosody_gestures.semi_markov import IntArray, Segment, SemiMarkovModel, states_by_frame
from understudy.prosody_gestures.voice_model import LONGEST_FRAMES, Discriminants, PartModel

MIXTURES = MixtureOptions(components=3)

RIDGE = 1e-3
"""Added to the within-state variances of the standardised features."""


def learn_part(
    part: str, states: tuple[str, ...], examples: Sequence[tuple[FloatArray, Sequence[Segment]]]
) -> PartModel:
    """Trains a part on prosody with context (frames × `WIDTH`) and its labelled segments."""
    rows = np.concatenate([example for example, _ in examples])
    kinds = np.concatenate([states_by_frame(path) for _, path in examples])
    discriminants = fit_discriminants(rows, kinds)
    projected = discriminants.project(rows)
    emissions = fit_mixtures([projected[kinds == state] for state in range(len(states))], MIXTURES)
    counts = count([path for _, path in examples], len(states), LONGEST_FRAMES, CountSmoothing())
    model = SemiMarkovModel(states, counts.log_initial, counts.log_transition, counts.log_duration, emissions)
    return PartModel(part, discriminants, model)


def fit_discriminants(rows: FloatArray, states: IntArray) -> Discriminants:
    """Fits one direction fewer than there are states, the most discriminative first, to rows (frames × features)."""
    mean, scale = rows.mean(axis=0), rows.std(axis=0) + 1e-9
    standard = (rows - mean) / scale
    kinds = np.unique(states)
    within = RIDGE * np.eye(rows.shape[1])
    between = np.zeros_like(within)
    for kind in kinds:
        own = standard[states == kind]
        centred = own - own.mean(axis=0)
        within += centred.T @ centred / len(rows)
        between += len(own) / len(rows) * np.outer(own.mean(axis=0), own.mean(axis=0))
    sizes, axes = np.linalg.eigh(within)
    whitening = axes / np.sqrt(sizes)
    order = np.linalg.eigh(whitening.T @ between @ whitening)[1][:, ::-1]
    return Discriminants(mean, scale, whitening @ order[:, : max(1, len(kinds) - 1)])

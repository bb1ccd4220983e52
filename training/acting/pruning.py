"""Narrows the layers that head movements are read from.

    python -m training.acting.pruning MODEL.onnx OUT.npz [--width 512]

Of the hidden units of each of these layers those are removed whose loss the others can best make up for (the least
of w² / [H⁻¹], optimal brain surgeon, Hassibi & Stork 1993), an eighth at a time, over the states in lines of our own;
what the kept units then give is the nearest to what all gave (least squares). `annealing.py --from OUT.npz --own 2`
teaches the layers what is still missing.
"""

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from understudy.model import FloatArray, SingleArray

from .encoder import starting_weights
from .exporting import NAMED_OUTPUTS, samples
from .graph import TRUNK, graph_of, layer_of
from .quantization import Sample, states_of

WIDTH, LINES = 512, 2000
STEP = 8
"""The part of the units, one in so many, that is removed at once."""

RIDGE = 1e-6
"""Of the mean variance of a unit, so that units which do the same can be told apart."""


@dataclass(frozen=True, slots=True, eq=False)
class Units:
    """The hidden units of a layer in many states: their mean (U,), covariance (U, U), and that with the outputs of the
    layer (U, O)."""

    mean: FloatArray
    among: FloatArray
    with_outputs: FloatArray

    @classmethod
    def of(cls, states: SingleArray, matrix: SingleArray) -> "Units":
        """Of the units' states (N, U) and the matrix (O, U) that makes outputs of them."""
        mean = states.mean(axis=0, dtype=np.float64)
        centred = states - mean
        among = centred.T @ centred / len(states)
        among[np.diag_indices_from(among)] += RIDGE * np.trace(among) / len(among)
        return cls(mean, among, among @ matrix.T.astype(np.float64))

    def kept(self, width: int) -> NDArray[np.intp]:
        """The `width` units without which least is lost."""
        kept = np.arange(len(self.mean))
        while len(kept) > width:
            inverse = np.linalg.inv(self.among[np.ix_(kept, kept)])
            lost = ((inverse @ self.with_outputs[kept]) ** 2).sum(axis=1) / np.diag(inverse)
            count = min(len(kept) - width, len(kept) // STEP)
            kept = np.delete(kept, np.argsort(lost)[:count])
        return kept

    def matrix(self, kept: NDArray[np.intp]) -> FloatArray:
        """The matrix (K, O) with which the kept units give what is nearest to the outputs."""
        return np.asarray(np.linalg.solve(self.among[np.ix_(kept, kept)], self.with_outputs[kept]))


def narrowed(
    weights: Mapping[str, SingleArray], layer: int, width: int, lines: Sequence[Sample]
) -> dict[str, SingleArray]:
    """The weights with fewer hidden units in a layer."""
    wide, narrow = f"{layer}.wide", f"{layer}.narrow"
    states = [each for (each,) in states_of(graph_of(weights, NAMED_OUTPUTS), [narrow], lines)]
    units = Units.of(np.concatenate(states), weights[narrow])
    kept = units.kept(width)
    matrix = units.matrix(kept)
    moved = units.mean @ weights[narrow].T - units.mean[kept] @ matrix
    changed = {
        wide: weights[wide][kept],
        f"{wide}.bias": weights[f"{wide}.bias"][kept],
        narrow: np.asarray(matrix.T, np.float32),
        f"{narrow}.bias": np.asarray(weights[f"{narrow}.bias"] + moved, np.float32),
    }
    return {**weights, **changed}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", type=Path)
    parser.add_argument("output", type=Path)
    parser.add_argument("--width", type=int, default=WIDTH, help="the hidden units that a layer keeps")
    arguments = parser.parse_args()
    weights, vocabulary = starting_weights(arguments.model)
    lines = list(samples(vocabulary, LINES))
    for layer in sorted({layer_of(name) for name in weights if layer_of(name) >= TRUNK}):
        weights = narrowed(weights, layer, arguments.width, lines)
    np.savez(arguments.output, allow_pickle=False, **weights)


if __name__ == "__main__":
    main()

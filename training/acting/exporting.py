"""Writes trained readers as one ONNX file.

    python -m training.acting.exporting MODEL.npz … encoder.onnx
    python -m training.acting.exporting TRUNK.onnx --head OWN.npz … --own 2 encoder.onnx

Their weights are averaged. With `--head` head movements are read from the last layers, as many as `--own` says, of
other models, which `annealing.py` has trained on the first layers of the others (`--own` there). The vocabulary is that
of the shipped model: of MiniLM's pieces those that directed lines and treebanks use, single characters, and then the
commonest by their place in the vocabulary, 20,000 of 30,522; what is left out is spelt with smaller pieces. It needs
`pip install torch onnx onnx-ir` beside what the program needs.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from understudy.model import SingleArray

from .directed import FACE, FAMILIES, GAZE, HEAD, MANNER
from .encoder import SHIPPED, starting_weights
from .graph import graph_of, write_quantized
from .network import with_head_network


def mean_weights(paths: Sequence[Path]) -> dict[str, SingleArray]:
    """The mean of the weights of trained models."""
    models = [starting_weights(path)[0] for path in paths]
    return {name: np.mean([model[name] for model in models], axis=0, dtype=np.float32) for name in models[0]}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", nargs="+", type=Path, help="their weights are averaged")
    parser.add_argument("output", type=Path)
    parser.add_argument("--head", nargs="+", type=Path, help="models whose last layers head movements are read from")
    parser.add_argument("--own", type=int, default=2, help="how many layers these have of their own")
    arguments = parser.parse_args()
    weights = mean_weights(arguments.models)
    if arguments.head:
        weights = with_head_network(weights, mean_weights(arguments.head), arguments.own)
    pieces = list(starting_weights(SHIPPED)[1])
    named = {"pieces": pieces, "families": FAMILIES, "head": HEAD, "face": FACE, "gaze": GAZE, "manner": MANNER}
    write_quantized(graph_of(weights, named), arguments.output)
    print(f"{arguments.output}: {arguments.output.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()

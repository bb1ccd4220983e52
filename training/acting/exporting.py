"""Writes trained readers as one ONNX file.

    python -m training.acting.exporting MODEL.npz … encoder.onnx
    python -m training.acting.exporting TRUNK.onnx --head OWN.npz … --own 2 encoder.onnx

Their weights are averaged. With `--head` head movements are read from the last layers, as many as `--own` says, of
other models, which `annealing.py` has trained on the first layers of the others (`--own` there). The vocabulary is that
of the shipped model: of MiniLM's pieces those that directed lines and treebanks use, single characters, and then the
commonest by their place in the vocabulary, 20,000 of 30,522; what is left out is spelt with smaller pieces. How large
the states' channels are is seen in lines of our own (`quantization.py`). It needs `pip install torch onnx onnx-ir`
beside what the program needs.
"""

import argparse
import random
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

import numpy as np
import onnx

from understudy.model import SingleArray

from .directed import FACE, FAMILIES, GAZE, HEAD, MANNER, OWN, is_held_out, read_file
from .encoder import SHIPPED, encoded, inputs_of, starting_weights
from .graph import graph_of
from .listening import heard
from .network import with_head_network
from .quantization import Constant, Sample, constants_of, factors_of, integers_of, write_quantized

SAMPLES = 400

NAMED_OUTPUTS = MappingProxyType({"families": FAMILIES, "head": HEAD, "face": FACE, "gaze": GAZE, "manner": MANNER})
"""The kinds of outputs by their channels, as a model's metadata has them."""


def mean_weights(paths: Sequence[Path]) -> dict[str, SingleArray]:
    """The mean of the weights of trained models."""
    models = [starting_weights(path)[0] for path in paths]
    return {name: np.mean([model[name] for model in models], axis=0, dtype=np.float32) for name in models[0]}


def samples(vocabulary: Mapping[str, int], count: int = SAMPLES) -> Iterator[Sample]:
    """Some of our lines and deliveries that are not held out, as the graph is given them and as they may be heard."""
    chance = random.Random(0)
    paths = sorted(OWN.glob("*.jsonl")) + sorted(OWN.glob("deliveries/*.jsonl"))
    lines = [line for path in paths for line in read_file(path, careful=True) if not is_held_out(line)]
    for line in chance.sample(lines, count):
        each = encoded(line, vocabulary)
        if each:
            pieces, _, ends, said = inputs_of([each], [heard(line, {}, chance)])
            yield {"pieces": pieces[0].numpy(), "words": ends[0].numpy(), "heard": said[0].numpy()}


def _as_written(models: Sequence[Path], weights: Mapping[str, SingleArray]) -> Mapping[str, Constant]:
    """What a single written model has in integers of these weights."""
    written = len(models) == 1 and models[0].suffix == ".onnx"
    return integers_of(constants_of(onnx.load(models[0])), weights) if written else {}


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
    vocabulary = starting_weights(SHIPPED)[1]
    named = {"pieces": list(vocabulary), **NAMED_OUTPUTS}
    factors = factors_of(graph_of(weights, named), samples(vocabulary))
    write_quantized(graph_of(weights, named, factors), arguments.output, _as_written(arguments.models, weights))
    print(f"{arguments.output}: {arguments.output.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()

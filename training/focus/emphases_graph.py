"""Makes models/focus/emphases.onnx from the checkpoint inside the package emphases 0.0.2 (MIT; Morrison et al. 2024).

    python -m training.focus.emphases_graph PACKAGE_FOLDER [--output models/focus/emphases.onnx]

PACKAGE_FOLDER is the unpacked package: it needs much to be imported, none of which the network needs. Needs torch, to
read the checkpoint, and onnx.

The network hears, in log Mel bands of frames, seven convolutions; sums what it hears in each word; and judges the words
in seven more. Its weights are unchanged. Inputs: `levels` (1, bands, frames), and of each word the first frame and the
one after the last, `firsts` and `ends` (words,). Output: `log_odds` (words,) that a listener marks it as emphasised.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import onnx
import torch
from onnx import TensorProto, helper, numpy_helper

from understudy.model import SingleArray

CHECKPOINT = Path("emphases/assets/checkpoints/checkpoint.pt")
LAYERS = range(0, 12, 2)
OPSET = 17


def main() -> None:
    """Writes the file."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("package", type=Path)
    parser.add_argument("--output", type=Path, default=Path("models/focus/emphases.onnx"))
    options = parser.parse_args()
    read = torch.load(options.package / CHECKPOINT, map_location="cpu", weights_only=True)["model"]
    model = graph({name: weights.numpy().astype(np.float32) for name, weights in read.items()})
    onnx.checker.check_model(model)
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_bytes(model.SerializeToString())


def graph(weights: dict[str, SingleArray]) -> onnx.ModelProto:
    """The network with these weights, by the names that the package gives them."""
    bands = weights["input_layer.weight"].shape[1]
    nodes = [
        _convolution("levels", "input_layer", "heard"),
        *_layers("frame_encoder", "heard", "frames"),
        *_sums("frames", "summed"),
        *_layers("word_decoder", "summed", "judged"),
        _convolution("judged", "output_layer", "scores"),
        helper.make_node("Reshape", ["scores", "flat"], ["log_odds"]),
    ]
    return helper.make_model(
        helper.make_graph(
            nodes,
            "emphases",
            [
                helper.make_tensor_value_info("levels", TensorProto.FLOAT, [1, bands, "frames"]),
                helper.make_tensor_value_info("firsts", TensorProto.INT64, ["words"]),
                helper.make_tensor_value_info("ends", TensorProto.INT64, ["words"]),
            ],
            [helper.make_tensor_value_info("log_odds", TensorProto.FLOAT, ["words"])],
            [
                *(numpy_helper.from_array(array, name) for name, array in weights.items()),
                numpy_helper.from_array(np.array([-1], np.int64), "flat"),
                numpy_helper.from_array(np.array(2, np.int64), "time"),
                numpy_helper.from_array(np.array([0, 0, 1, 0, 0, 0], np.int64), "before"),
            ],
        ),
        opset_imports=[helper.make_opsetid("", OPSET)],
        ir_version=8,
        producer_name="emphases 0.0.2, MIT licence, Copyright (c) 2023 Interactive Audio Lab",
    )


def _sums(source: str, result: str) -> Iterator[onnx.NodeProto]:
    """The sums over each word's frames: differences of running sums, in double precision for long recordings."""
    yield helper.make_node("Cast", [source], ["exact"], to=TensorProto.DOUBLE)
    yield helper.make_node("CumSum", ["exact", "time"], ["running"])
    yield helper.make_node("Pad", ["running", "before"], ["begun"])
    yield helper.make_node("Gather", ["begun", "ends"], ["until_end"], axis=2)
    yield helper.make_node("Gather", ["begun", "firsts"], ["until_first"], axis=2)
    yield helper.make_node("Sub", ["until_end", "until_first"], ["between"])
    yield helper.make_node("Cast", ["between"], [result], to=TensorProto.FLOAT)


def _layers(name: str, source: str, result: str) -> Iterator[onnx.NodeProto]:
    """The convolutions of a part, each cut off at 0."""
    for layer in LAYERS:
        own = f"{name}.{layer}"
        yield _convolution(source, own, f"{own}.sum")
        source = result if layer == LAYERS[-1] else f"{own}.above"
        yield helper.make_node("Relu", [f"{own}.sum"], [source])


def _convolution(source: str, name: str, result: str) -> onnx.NodeProto:
    return helper.make_node("Conv", [source, f"{name}.weight", f"{name}.bias"], [result], pads=[1, 1])


if __name__ == "__main__":
    main()

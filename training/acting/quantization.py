"""Eight-bit integers for the matrices of the reader's graph, and back.

A product whose states all have one scale (`DynamicQuantizeMatMul` of ONNX Runtime) takes half the time of one with a
scale for every 128 of them (`MatMulNBits`), but a few channels of a transformer's states are far larger than the
others, which then have few of the 256 levels. So each channel is divided by a factor before the product, and the row of
the matrix that it meets is multiplied by it, which changes nothing but the rounding (SmoothQuant, Xiao et al. 2023).
The first layers keep their blocks: what is rounded there goes through all that follow.
"""

import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import onnx
from numpy.typing import NDArray
from onnx import helper, numpy_helper
from onnxruntime import InferenceSession
from onnxruntime.quantization import QuantType, quantize_dynamic
from onnxruntime.quantization.matmul_nbits_quantizer import DefaultWeightOnlyQuantConfig, MatMulNBitsQuantizer

from understudy.model import SingleArray

from .graph import FLOATING, INTEGERS, INVERSE, STEPS, layer_of

SMOOTHING = 0.8
"""How much of a channel's size its row of the matrix takes over, as a power (α of Xiao et al., eq. 4)."""

FIRST_SMOOTHED = 4
"""The first layer whose products have one scale for all states. The outputs have not: they may be asked for no words,
which only a product by blocks can answer."""

BITS, BLOCK = 8, 128
BLOCK_ZERO = 128
"""The level of a block that stands for 0."""

INTEGER_PRODUCTS = 4
"""What ONNX Runtime calls accuracy level 4: states are quantized too, by block."""

LEVELS, BLOCK_STEPS = "_Q8", "_scales"
TABLE = ("pieces.table_quantized", "pieces.table_zero_point", "pieces.table_scale")
"""What ONNX Runtime calls the integers of a matrix by block, the value of their steps, and the table of pieces."""

LEAST_SIZE = 1e-5

Constant: TypeAlias = NDArray[Any]
"""Of float32 or of integers."""

Sample: TypeAlias = Mapping[str, NDArray[Any]]
"""The inputs of the graph for one line."""


def states_of(model: Any, names: Sequence[str], samples: Iterable[Sample]) -> Iterator[list[SingleArray]]:  # noqa: ANN401
    """For each sample the states (P, C) that enter the products with the matrices `names` of a model in float32."""
    entering = {node.input[1]: node.input[0] for node in model.graph.node if node.op_type == "MatMul"}
    states = [entering[name] for name in names]
    probed = onnx.ModelProto()
    probed.CopyFrom(model)
    probed.graph.output.extend(
        helper.make_tensor_value_info(name, onnx.TensorProto.FLOAT, None) for name in dict.fromkeys(states)
    )
    session = InferenceSession(probed.SerializeToString(), providers=["CPUExecutionProvider"])
    for sample in samples:
        yield session.run(states, sample)


def factors_of(model: Any, samples: Iterable[Sample]) -> dict[str, SingleArray]:  # noqa: ANN401 - untyped
    """What the channels of the states that enter a product are divided by, by the matrix. `model` is in float32; how
    large its channels are is seen in `samples`."""
    matrices = constants_of(model)
    names = [name for name in matrices if layer_of(name) >= FIRST_SMOOTHED and matrices[name].ndim > 1]
    seen = [[np.abs(states).max(axis=0) for states in each] for each in states_of(model, names, samples)]
    peaks = (np.max(each, axis=0) for each in zip(*seen, strict=True))
    return {name: _factors(each, matrices[name]) for name, each in zip(names, peaks, strict=True)}


def _factors(peaks: SingleArray, matrix: SingleArray) -> SingleArray:
    """Around 1, the larger the larger a channel is beside its row."""
    states, rows = np.maximum(peaks, LEAST_SIZE), np.maximum(np.abs(matrix).max(axis=1), LEAST_SIZE)
    logarithms = SMOOTHING * np.log(states) - (1 - SMOOTHING) * np.log(rows)
    return np.asarray(np.exp(logarithms - logarithms.mean()), np.float32)


def write_quantized(model: Any, path: Path, kept: Mapping[str, Constant]) -> None:  # noqa: ANN401 - untyped
    """Writes the model with those matrices that are still in float32, the table of pieces too, as integers by block;
    constants that were `kept` (`integers_of`) are not rounded a second time."""
    with tempfile.TemporaryDirectory() as folder:
        whole, tabled = Path(folder) / "whole.onnx", Path(folder) / "tabled.onnx"
        onnx.save(model, whole)
        quantize_dynamic(whole, tabled, weight_type=QuantType.QInt8, op_types_to_quantize=["Gather"])
        configuration = DefaultWeightOnlyQuantConfig(
            block_size=BLOCK, is_symmetric=True, accuracy_level=INTEGER_PRODUCTS, bits=BITS
        )
        floating = [node.name for node in model.graph.node if set(node.input) & set(FLOATING)]
        quantizer = MatMulNBitsQuantizer(onnx.load(tabled), algo_config=configuration, nodes_to_exclude=floating)
        quantizer.process()
        for constant in quantizer.model.model.graph.initializer:
            if constant.name in kept:
                constant.CopyFrom(numpy_helper.from_array(kept[constant.name], constant.name))
        quantizer.model.save_model_to_file(str(path))


def constants_of(model: Any) -> dict[str, Constant]:  # noqa: ANN401 - untyped
    """The constants of a model by their names."""
    return {each.name: numpy_helper.to_array(each) for each in model.graph.initializer}


def matrices_of(constants: Mapping[str, Constant]) -> Iterator[tuple[str, SingleArray]]:
    """The matrices (out, in) of a written model and its table of pieces by their names."""
    for name, values in constants.items():
        if name.endswith(LEVELS):
            own = name.removesuffix(LEVELS)
            steps = constants[f"{own}{BLOCK_STEPS}"].reshape(len(values), -1, 1)
            levels = values.astype(np.float32) - BLOCK_ZERO
            yield own, np.asarray(levels * steps, np.float32).reshape(len(values), -1)
        elif name.endswith(INTEGERS):
            own = name.removesuffix(INTEGERS)
            levels = values.astype(np.float32) * constants[f"{own}{STEPS}"]
            yield own, np.ascontiguousarray((levels * constants[f"{own}{INVERSE}"][:, None]).T, np.float32)
    table, zero, step = (constants[name] for name in TABLE)
    yield "pieces.table", np.asarray((table.astype(np.float32) - zero) * step, np.float32)


def integers_of(constants: Mapping[str, Constant], weights: Mapping[str, SingleArray]) -> dict[str, Constant]:
    """The constants of a written model that stand for what is still in `weights`."""
    matrices = matrices_of(constants)
    same = {name for name, matrix in matrices if name in weights and np.array_equal(matrix, weights[name])}
    names = [f"{name}{suffix}" for name in same for suffix in (LEVELS, BLOCK_STEPS, INTEGERS, STEPS, INVERSE)]
    names += TABLE if "pieces.table" in same else ()
    return {name: constants[name] for name in names if name in constants}

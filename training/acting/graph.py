"""The trained reader as an ONNX graph.

`weights` are float32 matrices (out, in) and vectors by their names. Products for which there are `factors`
(`quantization.py`) are of eight-bit integers, with a step for each column of the matrix and one for all states.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import numpy as np
import onnx
from numpy.typing import NDArray
from onnx import TensorProto, helper, numpy_helper

from understudy.model import SingleArray

OPERATORS = 20
"""The version of ONNX' operators: the first with Gelu."""

FORMAT = 10
ATTENTION_HEADS = 12

TRUNK = 6
"""The layers that all but head movements are read from. Those beyond stand for as many of the last of them where head
movements are read."""

EPSILON = 1e-12

FLOATING = ("heard.matrix", "direct.matrix")
"""The matrices that stay in float32, because they are small and their input has values of very different size."""

INTEGERS, STEPS, INVERSE = ".integers", ".steps", ".inverse"
"""What follows the name of a matrix (in, out) of integers, of what one level of each column is worth, and of what the
states are multiplied by."""

TOP = 127
"""The highest level of a column; the lowest is its negative."""

CONTRIBUTED = "com.microsoft"
"""ONNX Runtime's own operators."""

NO_FACTORS: Mapping[str, SingleArray] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class _Graph:
    """Nodes and constants so far; every method adds some and returns the name of what they yield."""

    weights: Mapping[str, SingleArray]
    factors: Mapping[str, SingleArray]
    nodes: list[Any] = field(default_factory=list)
    constants: list[Any] = field(default_factory=list)

    def constant(self, name: str, values: NDArray[np.generic]) -> str:
        self.constants.append(numpy_helper.from_array(np.asarray(values, order="C"), name))
        return name

    def node(self, kind: str, inputs: Sequence[str], result: str = "", **attributes: Any) -> str:  # noqa: ANN401
        result = result or f"{kind}_{len(self.nodes)}"
        self.nodes.append(helper.make_node(kind, list(inputs), [result], name=result, **attributes))
        return result

    def linear(self, states: str, name: str) -> str:
        bias = self.constant(f"{name}.bias", self.weights[f"{name}.bias"])
        if name in self.factors:
            return self.in_integers(states, name, bias)
        product = self.node("MatMul", [states, self.constant(name, self.weights[name].T)])
        return self.node("Add", [product, bias])

    def in_integers(self, states: str, name: str, bias: str) -> str:
        factors = self.factors[name]
        matrix = self.weights[name].T * factors[:, None]
        steps = np.asarray(np.abs(matrix).max(axis=0) / TOP, np.float32)
        levels = np.rint(matrix / np.where(steps > 0, steps, 1)).astype(np.int8)
        divided = self.node("Mul", [states, self.constant(f"{name}{INVERSE}", np.float32(1) / factors)])
        constants = [
            self.constant(f"{name}{INTEGERS}", levels),
            self.constant(f"{name}{STEPS}", steps),
            self.constant(f"{name}.zero", np.zeros_like(steps, np.int8)),
        ]
        return self.node("DynamicQuantizeMatMul", [divided, *constants, bias], domain=CONTRIBUTED)

    def normalized(self, states: str, name: str) -> str:
        scale, shift = self.weights[name]
        parts = [self.constant(f"{name}.scale", scale), self.constant(f"{name}.shift", shift)]
        return self.node("LayerNormalization", [states, *parts], axis=-1, epsilon=EPSILON)

    def by_head(self, states: str, name: str, permutation: Sequence[int]) -> str:
        split = self.node("Reshape", [self.linear(states, name), "split"])
        return self.node("Transpose", [split], perm=list(permutation))

    def attended(self, states: str, layer: int) -> str:
        """Self-attention over the pieces."""
        query = self.by_head(states, f"{layer}.query", (1, 0, 2))
        key = self.by_head(states, f"{layer}.key", (1, 2, 0))
        value = self.by_head(states, f"{layer}.value", (1, 0, 2))
        scores = self.node("Mul", [self.node("MatMul", [query, key]), "scale"])
        mixed = self.node("MatMul", [self.node("Softmax", [scores], axis=-1), value])
        joined = self.node("Reshape", [self.node("Transpose", [mixed], perm=[1, 0, 2]), "joined"])
        return self.linear(joined, f"{layer}.attended")

    def layer(self, states: str, layer: int) -> str:
        attended = self.node("Add", [states, self.attended(states, layer)])
        states = self.normalized(attended, f"{layer}.attended.norm")
        widened = self.node("Gelu", [self.linear(states, f"{layer}.wide")])
        narrowed = self.node("Add", [states, self.linear(widened, f"{layer}.narrow")])
        return self.normalized(narrowed, f"{layer}.narrow.norm")

    def through(self, states: str, layers: Iterable[int]) -> str:
        for layer in layers:
            states = self.layer(states, layer)
        return states

    def words(self, states: str) -> str:
        """The states of the first and last piece of each word, side by side."""
        return self.node("Reshape", [self.node("Gather", [states, "words"]), "word"])

    def split(self, values: str, results: Sequence[str], *sizes: str, **attributes: Any) -> Sequence[str]:  # noqa: ANN401
        self.nodes.append(helper.make_node("Split", [values, *sizes], list(results), **attributes))
        return results


def graph_of(
    weights: Mapping[str, SingleArray],
    named: Mapping[str, Sequence[str]],
    factors: Mapping[str, SingleArray] = NO_FACTORS,
) -> Any:  # noqa: ANN401 - untyped
    """The model: `pieces` (P,), `words` (W, 2), the first and last piece of each word, and `heard` (P, H), how each
    piece is said, to `likely` (W, outputs), in [0, 1]. `named` are lists that go with it as metadata; products for
    whose matrices there are `factors` are in integers, the others in float32."""
    graph = _Graph(weights, factors)
    width = weights["positions"].shape[1]
    graph.constant("split", np.array([-1, ATTENTION_HEADS, width // ATTENTION_HEADS], np.int64))
    graph.constant("joined", np.array([-1, width], np.int64))
    graph.constant("word", np.array([-1, 2 * width], np.int64))
    graph.constant("scale", np.array((width // ATTENTION_HEADS) ** -0.5, np.float32))
    states = graph.normalized(_placed(graph), "start.norm")
    product = _outputs(graph, states, named)
    graph.node("Sigmoid", [graph.node("Add", [product, _direct(graph)])], "likely")
    model = helper.make_model(
        helper.make_graph(
            graph.nodes,
            "reader",
            [
                helper.make_tensor_value_info("pieces", TensorProto.INT64, ["P"]),
                helper.make_tensor_value_info("words", TensorProto.INT64, ["W", 2]),
                helper.make_tensor_value_info("heard", TensorProto.FLOAT, ["P", graph.weights["heard"].shape[1]]),
            ],
            [helper.make_tensor_value_info("likely", TensorProto.FLOAT, ["W", len(weights["out"])])],
            graph.constants,
        ),
        opset_imports=[helper.make_opsetid("", OPERATORS), helper.make_opsetid(CONTRIBUTED, 1)],
        ir_version=FORMAT,
    )
    helper.set_model_props(model, {name: "\n".join(values) for name, values in named.items()})
    onnx.checker.check_model(model)
    return model


def _outputs(graph: _Graph, states: str, named: Mapping[str, Sequence[str]]) -> str:
    """The outputs of the words, without what is heard, from the states of their pieces before the first layer."""
    layers = sum(name.endswith(".query") for name in graph.weights)
    branching = TRUNK - (layers - TRUNK)
    states = graph.through(states, range(branching))
    trunk = graph.words(graph.through(states, range(branching, TRUNK)))
    if branching == TRUNK:
        return graph.linear(trunk, "out")
    own = graph.words(graph.through(states, range(TRUNK, layers)))
    first, second = (graph.constant(f"at.{place}", np.array([place], np.int64)) for place in (0, 1))
    stacked = [graph.node("Unsqueeze", [words, first]) for words in (trunk, own)]
    both = graph.linear(graph.node("Concat", stacked, axis=0), "out")
    of_trunk, of_own = (
        graph.node("Squeeze", [graph.node("Gather", [both, place], axis=0), first]) for place in (first, second)
    )
    hands, head = 2 * len(named["families"]) + 1, len(named["head"])
    graph.constant("sizes", np.array([hands, head, len(graph.weights["out"]) - hands - head], np.int64))
    of_hands, _, others = graph.split(of_trunk, ("hands", "trunk.head", "others"), "sizes", axis=1)
    _, of_head, _ = graph.split(of_own, ("own.hands", "head", "own.others"), "sizes", axis=1)
    return graph.node("Concat", [of_hands, of_head, others], axis=1)


def _placed(graph: _Graph) -> str:
    """The table's row of each piece, that of its place, and how it is said."""
    table = graph.constant("pieces.table", graph.weights["pieces.table"])
    places = graph.constant("positions", graph.weights["positions"])
    start, step = graph.constant("start", np.array([0], np.int64)), graph.constant("step", np.array([1], np.int64))
    count = graph.node("Shape", ["pieces"])
    written = graph.node(
        "Add", [graph.node("Gather", [table, "pieces"]), graph.node("Slice", [places, start, count, start, step])]
    )
    return graph.node("Add", [written, _told(graph, "heard", "heard")])


def _direct(graph: _Graph) -> str:
    """What how a word is said, as its first piece has it, adds to the word's outputs."""
    first = graph.constant("first", np.array(0, np.int64))
    return _told(graph, graph.node("Gather", ["heard", graph.node("Gather", ["words", first], axis=1)]), "direct")


def _told(graph: _Graph, heard: str, name: str) -> str:
    return graph.node("MatMul", [heard, graph.constant(f"{name}.matrix", graph.weights[name].T)])


def layer_of(name: str) -> int:
    """The number of the layer that a weight is of; -1 for those that are of none."""
    number = name.split(".", maxsplit=1)[0]
    return int(number) if number.isdecimal() else -1

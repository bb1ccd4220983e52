"""The reader as a PyTorch network with the weights of `graph.py` by their names, and the weights of a shipped model.

The network is BERT's (Devlin et al. 2019) with an input of how the line is said
(`app/behavior/reading/encoder.py`): its features are added to the embeddings of a word's pieces ("heard"), and to
the word's outputs ("direct"). Head movements may be read from last layers of their own, which stand for as many of the
last of the `TRUNK` and are numbered after it.
"""

import math
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import onnx
import torch
from torch import Tensor, nn
from torch.nn.functional import gelu, layer_norm, scaled_dot_product_attention

from understudy.behavior.reading.encoder import FEATURES
from understudy.model import SingleArray

from .directed import CHANNELS
from .graph import ATTENTION_HEADS, EPSILON, TRUNK, layer_of
from .quantization import constants_of, matrices_of


class Reader(nn.Module):  # type: ignore[misc]
    """The encoder with its outputs; `frozen` layers, counted from the first, and the embeddings are not trained."""

    def __init__(self, weights: Mapping[str, SingleArray], *, frozen: int = 0, dropout: float = 0.1) -> None:
        super().__init__()
        self.weights = nn.ParameterDict(
            {name.replace(".", "/"): nn.Parameter(torch.from_numpy(np.array(value))) for name, value in weights.items()}
        )
        self.layers = sum(name.endswith(".query") for name in weights)
        self.dropout = nn.Dropout(dropout)
        for name, parameter in self.weights.items():
            place = name.split("/")[0]
            fixed = place in ("pieces", "positions") or (place.isdecimal() and int(place) < frozen)
            parameter.requires_grad_(not fixed)

    def forward(self, pieces: Tensor, mask: Tensor, ends: Tensor, heard: Tensor) -> Tensor:
        """Logits (lines, words, outputs) of pieces (lines, pieces), of `ends` (lines, words, 2), the words' outer
        pieces, and of `heard` (lines, pieces, features); `mask` (lines, pieces) is true for pieces."""
        table = self._weight("pieces.table")[pieces] + self._weight("positions")[: pieces.shape[1]]
        states = self._normalized(table + heard @ self._weight("heard").T, "start.norm")
        seen = mask[:, None, None, :]
        branching = TRUNK - (self.layers - TRUNK)
        for layer in range(branching):
            states = self._layer(self.dropout(states), layer, seen)
        told = heard.gather(1, ends[..., 0, None].expand(-1, -1, heard.shape[-1]))
        direct = told @ self._weight("direct").T
        logits = self._read(states, range(branching, TRUNK), seen, ends) + direct
        if branching < TRUNK:
            own = self._read(states, range(TRUNK, self.layers), seen, ends) + direct
            head = CHANNELS["head"]
            logits = torch.cat([logits[..., : head.start], own[..., head], logits[..., head.stop :]], dim=-1)
        return logits.float()

    def _read(self, states: Tensor, layers: Sequence[int], seen: Tensor, ends: Tensor) -> Tensor:
        """The outputs of the words after some further layers, without what is heard."""
        for layer in layers:
            states = self._layer(self.dropout(states), layer, seen)
        width = states.shape[-1]
        outer = [states.gather(1, ends[..., end, None].expand(-1, -1, width)) for end in (0, 1)]
        return self._linear(self.dropout(torch.cat(outer, dim=-1)), "out")

    def exported(self) -> dict[str, SingleArray]:
        """The weights by their names."""
        return {
            name.replace("/", "."): parameter.detach().float().numpy().copy()
            for name, parameter in self.weights.items()
        }

    def _weight(self, name: str) -> Tensor:
        return self.weights[name.replace(".", "/")]

    def _linear(self, states: Tensor, name: str) -> Tensor:
        return nn.functional.linear(states, self._weight(name), self._weight(f"{name}.bias"))

    def _normalized(self, states: Tensor, name: str) -> Tensor:
        scale, shift = self._weight(f"{name}")
        return layer_norm(states, states.shape[-1:], scale, shift, EPSILON)

    def _layer(self, states: Tensor, layer: int, seen: Tensor) -> Tensor:
        lines, count, width = states.shape
        parts = [
            self._linear(states, f"{layer}.{name}").view(lines, count, ATTENTION_HEADS, -1).transpose(1, 2)
            for name in ("query", "key", "value")
        ]
        mixed = scaled_dot_product_attention(*parts, attn_mask=seen).transpose(1, 2).reshape(lines, count, width)
        attended = self.dropout(self._linear(mixed, f"{layer}.attended"))
        states = self._normalized(states + attended, f"{layer}.attended.norm")
        narrowed = self._linear(gelu(self._linear(states, f"{layer}.wide")), f"{layer}.narrow")
        return self._normalized(states + self.dropout(narrowed), f"{layer}.narrow.norm")


def shipped_weights(path: Path) -> tuple[dict[str, SingleArray], dict[str, list[str]]]:
    """The weights of a shipped model in float32, and the lists of its metadata."""
    model = onnx.load(path)
    stored = constants_of(model)
    weights: dict[str, SingleArray] = dict(matrices_of(stored))
    for name, values in stored.items():
        if name.endswith(".scale"):
            own = name.removesuffix(".scale")
            weights[own] = np.stack([values, stored[f"{own}.shift"]])
        elif name.endswith(".matrix"):
            weights[name.removesuffix(".matrix")] = np.array(values.T)
        elif name.endswith(".bias") or name == "positions":
            weights[name] = np.array(values)
    return weights, {each.key: each.value.split("\n") for each in model.metadata_props}


def with_delivery(weights: Mapping[str, SingleArray], outputs: int, kept: Mapping[int, int]) -> dict[str, SingleArray]:
    """Weights with inputs for the delivery, at 0, and with `outputs` outputs; `kept` gives the old row of a new output,
    the others begin near a probability of .02."""
    width = weights["out"].shape[1]
    out = np.random.default_rng(0).normal(0, 0.01, (outputs, width)).astype(np.float32)
    bias = np.full(outputs, math.log(0.02 / 0.98), np.float32)
    for new, old in kept.items():
        out[new], bias[new] = weights["out"][old], weights["out.bias"][old]
    none = {
        "heard": np.zeros((weights["positions"].shape[1], FEATURES), np.float32),
        "direct": np.zeros((outputs, FEATURES), np.float32),
    }
    return {**none, **weights, "out": out, "out.bias": bias}


def head_network(weights: Mapping[str, SingleArray]) -> dict[str, SingleArray]:
    """The network that head movements are read from, as a trunk: its last layers are theirs."""
    layers = sum(name.endswith(".query") for name in weights)
    kept = {name: values for name, values in weights.items() if layer_of(name) < TRUNK}
    return kept | {_moved(name, TRUNK - layers): weights[name] for name in weights if layer_of(name) >= TRUNK}


def with_head_network(
    weights: Mapping[str, SingleArray], network: Mapping[str, SingleArray], own: int
) -> dict[str, SingleArray]:
    """The weights of a trunk, with the last `own` layers and the outputs of the head of another network, whose other
    layers are those of this one."""
    branched = {name: np.array(values) for name, values in weights.items() if layer_of(name) < TRUNK}
    for name in ("out", "out.bias", "direct"):
        branched[name][CHANNELS["head"]] = network[name][CHANNELS["head"]]
    lasts = {_moved(name, own): values for name, values in network.items() if layer_of(name) >= TRUNK - own}
    return branched | lasts


def _moved(name: str, layers: int) -> str:
    number, own = name.split(".", 1)
    return f"{int(number) + layers}.{own}"

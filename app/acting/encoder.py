"""Reads a line in context: what each gesture family, head movement and face would be worth at each word to a director.

A small transformer encoder (BERT architecture, Devlin et al. 2019), fine-tuned on directed lines (`training/acting`,
models/acting/README.md) and run with numpy alone. Matrices are stored as int8 with a scale for each row and made
float32 on loading. Shapes: W words, P pieces, D the width, F gesture families, H head movements, K faces.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from zipfile import BadZipFile

import numpy as np

from ..errors import ServiceError
from ..model import SingleArray
from .wordpieces import FIRST, LAST, pieces_of

MOST_PIECES = 126
"""Pieces between the two marks that frame them; words beyond are worth nothing."""

_EPSILON = np.float32(1e-12)


@dataclass(frozen=True, slots=True, eq=False)
class Reading:
    """What directors would want, in [0, 1]: the worth of a family with its stroke on a word (W, F) and within two words
    of it (W, F), how likely any stroke is (W,), and head movements (W, H) and faces (W, K) go with a word."""

    at_word: SingleArray
    nearby: SingleArray
    stroke: SingleArray
    head: SingleArray
    face: SingleArray


@dataclass(frozen=True, slots=True, eq=False)
class Encoder:
    """The trained network: its matrices by name in `weights`, and the names of its outputs.

    A line is too short for its products to be shared among processors: on two they took up to six times the processor
    time (`Understudy.load` keeps them on one).
    """

    pieces: Mapping[str, int]
    families: tuple[str, ...]
    head: tuple[str, ...]
    face: tuple[str, ...]
    attention_heads: int
    weights: Mapping[str, SingleArray]

    @classmethod
    def load(cls, path: Path) -> "Encoder":
        """Raises ServiceError `model_unreadable` where the file is missing or is none of ours."""
        try:
            with path.open("rb") as file, np.load(file, allow_pickle=False) as stored:
                return cls(
                    pieces=MappingProxyType({piece: number for number, piece in enumerate(_names(stored["pieces"]))}),
                    families=_names(stored["families"]),
                    head=_names(stored["heads"]),
                    face=_names(stored["faces"]),
                    attention_heads=int(stored["heads_each_layer"]),
                    weights=MappingProxyType(_with_joined_attention(dict(_matrices(stored)))),
                )
        except (OSError, EOFError, ValueError, KeyError, BadZipFile) as error:
            raise ServiceError("model_unreadable", f"{path} is no model for directing lines: {error}") from error

    @property
    def layers(self) -> int:
        return sum(name.endswith(".attention") for name in self.weights)

    def read(self, words: Sequence[str]) -> Reading:
        """The words as they are written, with their punctuation."""
        if not words:
            return self._outputs(np.zeros((0, len(self.weights["out.bias"])), np.float32))
        numbers, spans = self._numbered(words)
        states = self._encoded(np.array(numbers))
        ends = np.array([span or (0, 0) for span in spans])
        logits = np.concatenate([states[ends[:, 0]], states[ends[:, 1]]], axis=1) @ self.weights["out"]
        likely = _sigmoid(logits + self.weights["out.bias"])
        likely[[span is None for span in spans]] = 0.0
        return self._outputs(likely)

    def _numbered(self, words: Sequence[str]) -> tuple[list[int], list[tuple[int, int] | None]]:
        """The line's pieces between their marks, and each word's first and last; None where there is no more room."""
        numbers, spans = [self.pieces[FIRST]], list[tuple[int, int] | None]()
        for word in words:
            own = pieces_of(word, self.pieces)
            if len(numbers) + len(own) > MOST_PIECES + 1:
                spans.append(None)
                continue
            spans.append((len(numbers), len(numbers) + len(own) - 1))
            numbers += own
        return [*numbers, self.pieces[LAST]], spans

    def _encoded(self, numbers: "np.ndarray[tuple[int], np.dtype[np.int_]]") -> SingleArray:
        """The pieces in context (P, D)."""
        weights = self.weights
        states = weights["pieces.table"][numbers] + weights["positions"][: len(numbers)]
        states = _normalized(states, weights["start.norm"])
        for layer in range(self.layers):
            attended = self._attended(states, layer)
            states = _normalized(states + attended, weights[f"{layer}.attended.norm"])
            widened = _gelu(self._linear(states, f"{layer}.wide"))
            states = _normalized(states + self._linear(widened, f"{layer}.narrow"), weights[f"{layer}.narrow.norm"])
        return states

    def _attended(self, states: SingleArray, layer: int) -> SingleArray:
        """Self-attention over the pieces (P, D)."""
        count = len(states)
        joined = self._linear(states, f"{layer}.attention").reshape(count, 3, self.attention_heads, -1)
        query, key, value = joined.transpose(1, 2, 0, 3)
        scores = query @ key.transpose(0, 2, 1) / np.float32(np.sqrt(query.shape[-1]))
        weights = np.exp(scores - scores.max(axis=-1, keepdims=True))
        weights /= weights.sum(axis=-1, keepdims=True)
        return self._linear((weights @ value).transpose(1, 0, 2).reshape(count, -1), f"{layer}.attended")

    def _linear(self, states: SingleArray, name: str) -> SingleArray:
        return states @ self.weights[name] + self.weights[f"{name}.bias"]

    def _outputs(self, likely: SingleArray) -> Reading:
        families = len(self.families)
        heads_from = 2 * families + 1
        faces_from = heads_from + len(self.head)
        return Reading(
            at_word=likely[:, :families],
            nearby=likely[:, families : 2 * families],
            stroke=likely[:, 2 * families],
            head=likely[:, heads_from:faces_from],
            face=likely[:, faces_from:],
        )


def _names(stored: "np.ndarray[tuple[int], np.dtype[np.uint8]]") -> tuple[str, ...]:
    return tuple(bytes(stored).decode().split("\n"))


def _matrices(stored: "np.lib.npyio.NpzFile") -> "list[tuple[str, SingleArray]]":
    """Every array as float32; a matrix (out, in) with a scale a row is turned for products from the left."""
    matrices: list[tuple[str, SingleArray]] = []
    for name in stored.files:
        if f"{name}.scale" in stored.files:
            matrix = stored[name].astype(np.float32) * stored[f"{name}.scale"].astype(np.float32)[:, None]
            matrices.append((name, matrix if name == "pieces.table" else np.ascontiguousarray(matrix.T)))
        elif stored[name].dtype == np.float16 and not name.endswith(".scale"):
            matrices.append((name, stored[name].astype(np.float32)))
    return matrices


def _with_joined_attention(weights: dict[str, SingleArray]) -> dict[str, SingleArray]:
    """Query, key and value of each layer side by side: one product takes less time than three."""
    names = ("query", "key", "value")
    for layer in range(sum(name.endswith(".query") for name in weights)):
        for suffix in ("", ".bias"):
            parts = [weights.pop(f"{layer}.{name}{suffix}") for name in names]
            weights[f"{layer}.attention{suffix}"] = np.concatenate(parts, axis=-1)
    return weights


def _normalized(states: SingleArray, scale_and_shift: SingleArray) -> SingleArray:
    centred = states - states.mean(axis=-1, keepdims=True)
    spread = np.sqrt((centred * centred).mean(axis=-1, keepdims=True) + _EPSILON)
    return np.asarray(centred / spread * scale_and_shift[0] + scale_and_shift[1], np.float32)


def _gelu(states: SingleArray) -> SingleArray:
    """x Φ(x), with the error function after Abramowitz and Stegun 7.1.26 (off by 1.5e-7 at most): numpy has none."""
    scaled = np.abs(states) * np.float32(0.7071067811865476)
    t = 1 / (1 + np.float32(0.3275911) * scaled)
    series = np.float32(-1.453152027) + t * np.float32(1.061405429)
    for coefficient in (1.421413741, -0.284496736, 0.254829592):
        series = np.float32(coefficient) + t * series
    error = np.copysign(1 - t * series * np.exp(-scaled * scaled), states)
    return np.asarray(states * np.float32(0.5) * (1 + error), np.float32)


def _sigmoid(logits: SingleArray) -> SingleArray:
    return (1 / (1 + np.exp(-np.clip(logits, -30, 30)))).astype(np.float32)

"""Predicts the pronunciation of an unknown word from its spelling (grapheme-to-phoneme conversion).

A graphone is a chunk of one or two letters with the phones it spells, "ph:F" or "x:K_S". The model is an n-gram model
over graphones; the pronunciation is that of the likeliest sequence that spells the word, found by beam search (Bisani &
Ney 2008). `training/pronunciation/` trains the model; `models/pronunciation/README.md` documents its accuracy.

On disk (`graphones.npz`, no pickles) the n-grams are a trie. An n-gram of order k is a row of order k: the row of its
context in order k − 1, times 1024, plus its last graphone. The rows are sorted; `keys_k` holds their differences.
"""

import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...errors import ServiceError
from ...model import FloatArray

GRAPHONE_BITS = 10
START, END = 1, 2
BEAM = 24
LONGEST_CHUNK = 2

Indices: TypeAlias = NDArray[np.int64]

State: TypeAlias = tuple[int, int]
"""A context: its length in graphones, and its row in that order of the trie."""


@dataclass(frozen=True, slots=True, eq=False)
class _Order:
    """The n-grams of one length: sorted keys, natural logs, and the row of the n-gram without its first graphone, one
    order down. In the same precision as on disk, since there are 400,000."""

    keys: NDArray[np.int32]
    log_probability: FloatArray
    log_backoff: FloatArray
    suffix: NDArray[np.int32]

    def row(self, context: int, graphone: int) -> int | None:
        key = (context << GRAPHONE_BITS) | graphone
        row = int(np.searchsorted(self.keys, key))
        return row if row < len(self.keys) and self.keys[row] == key else None

    def rows(self, contexts: Indices, graphones: Indices) -> tuple[Indices, NDArray[np.bool_]]:
        """The row of each context with its graphone, where there is one, and whether there is."""
        keys = (contexts << GRAPHONE_BITS) | graphones
        rows = np.minimum(np.searchsorted(self.keys, keys), len(self.keys) - 1)
        return rows, self.keys[rows] == keys


@dataclass(frozen=True, slots=True)
class _Hypothesis:
    """A pronunciation of the first letters of a word; of hypotheses in the same state only the best is kept."""

    score: float
    state: State
    phones: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Extension:
    """A hypothesis and the graphone that is to follow it, with its phones; it ends before the letter `end`."""

    hypothesis: _Hypothesis
    graphone: int
    phones: tuple[str, ...]
    end: int


@dataclass(frozen=True, slots=True, eq=False)
class GraphoneModel:
    """The loaded model; immutable and thread-safe."""

    spellings: dict[str, tuple[tuple[int, tuple[str, ...]], ...]]
    orders: tuple[_Order, ...]

    @classmethod
    def load(cls, path: Path) -> "GraphoneModel":
        """Load the model. Raises ServiceError `model_unreadable` if the file is missing or not such a model."""
        try:
            with np.load(path, allow_pickle=False) as arrays:
                graphones = [str(graphone) for graphone in arrays["graphones"]]
                orders = _orders(dict(arrays))
        except (OSError, KeyError, ValueError, zipfile.BadZipFile) as error:
            raise ServiceError("model_unreadable", f"{path} is not a pronunciation model: {error}") from None
        return cls(_by_letters(graphones), orders)

    def pronounce(self, word: str) -> tuple[str, ...]:
        """The likeliest ARPABET phones of `word` (lower-case a to z); empty if no graphones spell it."""
        reached: list[list[_Hypothesis]] = [[] for _ in range(len(word) + 1)]
        reached[0] = [_Hypothesis(0.0, self._initial(), ())]
        for position in range(len(word)):
            extensions = [
                _Extension(hypothesis, graphone, phones, position + length)
                for hypothesis in _best(reached[position])
                for length in range(1, min(LONGEST_CHUNK, len(word) - position) + 1)
                for graphone, phones in self.spellings.get(word[position : position + length], ())
            ]
            for extension, hypothesis in zip(extensions, self._extended(extensions), strict=True):
                reached[extension.end].append(hypothesis)
        finals = self._extended([_Extension(spelt, END, (), len(word)) for spelt in _best(reached[-1])])
        spoken = [final for final in finals if final.phones]
        return max(spoken, key=lambda final: final.score).phones if spoken else ()

    def _initial(self) -> State:
        row = self.orders[0].row(0, START)
        return (1, row) if row is not None else (0, 0)

    def _extended(self, extensions: Sequence["_Extension"]) -> list[_Hypothesis]:
        states = np.array([extension.hypothesis.state for extension in extensions], dtype=np.int64).reshape(-1, 2)
        graphones = np.array([extension.graphone for extension in extensions], dtype=np.int64)
        log_probabilities, reached = self._step(states, graphones)
        return [
            _Hypothesis(
                extension.hypothesis.score + step, (length, row), extension.hypothesis.phones + extension.phones
            )
            for extension, step, (length, row) in zip(
                extensions, log_probabilities.tolist(), reached.tolist(), strict=True
            )
        ]

    def _step(self, states: Indices, graphones: Indices) -> tuple[FloatArray, Indices]:
        """The log probability of each graphone after its state (a row each: length, row), with backoff, and the next
        states; -inf and the empty context for a graphone that never occurs."""
        log_probability, reached = np.full(len(graphones), -np.inf), np.zeros_like(states)
        log_weight, open_states = np.zeros(len(graphones)), states.copy()
        for length in reversed(range(len(self.orders))):
            here = np.flatnonzero(open_states[:, 0] == length)
            rows, found = self.orders[length].rows(open_states[here, 1], graphones[here])
            known, unknown = here[found], here[~found]
            log_probability[known] = log_weight[known] + self.orders[length].log_probability[rows[found]]
            reached[known] = self._following(length, rows[found])
            open_states[known, 0] = -1
            if length:
                shorter, contexts = self.orders[length - 1], open_states[unknown, 1]
                log_weight[unknown] += shorter.log_backoff[contexts]
                open_states[unknown] = np.column_stack((np.full(len(unknown), length - 1), shorter.suffix[contexts]))
        return log_probability, reached

    def _following(self, length: int, rows: Indices) -> Indices:
        """The states after the n-grams in `rows` of the order with contexts of `length` graphones."""
        if length + 1 < len(self.orders):
            return np.column_stack((np.full(len(rows), length + 1), rows))
        return np.column_stack((np.full(len(rows), length), self.orders[length].suffix[rows]))


def _best(hypotheses: list[_Hypothesis]) -> list[_Hypothesis]:
    """The `BEAM` best hypotheses, one per state."""
    best: dict[State, _Hypothesis] = {}
    for hypothesis in hypotheses:
        rival = best.get(hypothesis.state)
        if rival is None or hypothesis.score > rival.score:
            best[hypothesis.state] = hypothesis
    return sorted(best.values(), key=lambda hypothesis: -hypothesis.score)[:BEAM]


def _by_letters(graphones: list[str]) -> dict[str, tuple[tuple[int, tuple[str, ...]], ...]]:
    """Graphones with their indices, by their letters; index 0 is unused, START and END have no letters."""
    spellings: dict[str, list[tuple[int, tuple[str, ...]]]] = {}
    for number, graphone in enumerate(graphones):
        letters, colon, phones = graphone.partition(":")
        if colon:
            spellings.setdefault(letters, []).append((number, tuple(phones.split("_")) if phones else ()))
    return {letters: tuple(choices) for letters, choices in spellings.items()}


def _orders(arrays: dict[str, NDArray[Any]]) -> tuple[_Order, ...]:
    orders: list[_Order] = []
    for length in range(1, int(arrays["order"]) + 1):
        keys = np.cumsum(arrays[f"keys_{length}"], dtype=np.int32)
        log_probability, log_backoff = (arrays[f"log_{name}_{length}"] for name in ("probability", "backoff"))
        orders.append(_Order(keys, log_probability, log_backoff, _suffixes(keys, orders)))
    return tuple(orders)


def _suffixes(keys: NDArray[np.int32], shorter: list[_Order]) -> NDArray[np.int32]:
    """For each n-gram, the row one order down of the n-gram without its first graphone (row 0: the empty one)."""
    if not shorter:
        return np.zeros(len(keys), dtype=np.int32)
    context, graphone = keys >> GRAPHONE_BITS, keys & ((1 << GRAPHONE_BITS) - 1)
    wanted = (shorter[-1].suffix[context] << GRAPHONE_BITS) | graphone
    return np.asarray(np.searchsorted(shorter[-1].keys, wanted), dtype=np.int32)

"""The log-linear choice: how much each gesture family is worth with its stroke on each word, and because of which
terms.

    log-odds of worth(word, family) = bias(family) + α · reading(word, family) + Σ weight(term, family) over its terms

The reading is the log-odds of the encoder's expected worth. α, biases and weights are fitted to directed lines (`python
-m training.acting.weights`); the weights that authors set by hand (lexicon/acting/weights.yaml) are added. Shapes: W
words, F families, T terms.
"""

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

import numpy as np

from ...errors import ServiceError
from ...model import SingleArray, Term

READING = "reading in context"
BIAS = "how common it is"

_LEAST, _MOST = 1e-4, 1 - 1e-4


@dataclass(frozen=True, slots=True, eq=False)
class ChoiceModel:
    """Fitted weights: `bias` (F,), `reading` the weight of the reading (α), `weights` (T, F) of the terms by row
    number.

    `price` is the least gain for which a gesture is made, `head` and `face` are the least probabilities of each kind.
    """

    families: tuple[str, ...]
    bias: SingleArray
    reading: float
    rows: Mapping[str, int]
    weights: SingleArray
    price: float
    head: Mapping[str, float]
    face: Mapping[str, float]

    @classmethod
    def load(cls, path: Path) -> "ChoiceModel":
        """Raises ServiceError `model_unreadable` where the file is missing or not such a model."""
        try:
            stored = json.loads(path.read_text(encoding="utf-8"))
            families = tuple(stored["families"])
            places = {family: place for place, family in enumerate(families)}
            weights = np.zeros((len(stored["terms"]), len(families)), np.float32)
            for row, by_family in enumerate(stored["terms"].values()):
                for family, weight in by_family.items():
                    weights[row, places[family]] = weight
            return cls(
                families=families,
                bias=np.array([stored["bias"][family] for family in families], np.float32),
                reading=float(stored["reading"]),
                rows=MappingProxyType({name: row for row, name in enumerate(stored["terms"])}),
                weights=weights,
                price=float(stored["price"]),
                head=MappingProxyType({kind: float(likely) for kind, likely in stored["head"].items()}),
                face=MappingProxyType({kind: float(likely) for kind, likely in stored["face"].items()}),
            )
        except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
            raise ServiceError("model_unreadable", f"{path} is not a model of gesture choice: {error}") from error

    @property
    def terms(self) -> frozenset[str]:
        """The fitted terms."""
        return frozenset(self.rows)

    def with_weights(self, added: Mapping[str, Mapping[str, float]]) -> "ChoiceModel":
        """The model with weights by term and family added to its own; new terms are new rows. Weights of
        other names are ignored."""
        rows = dict(self.rows)
        for name in added:
            rows.setdefault(name, len(rows))
        weights = np.zeros((len(rows), len(self.families)), np.float32)
        weights[: len(self.weights)] = self.weights
        for name, by_family in added.items():
            for family, weight in by_family.items():
                if family in self.families:
                    weights[rows[name], self.families.index(family)] += weight
        return replace(self, rows=MappingProxyType(rows), weights=weights)

    def log_odds(self, read: SingleArray, terms: Sequence[Iterable[str]]) -> SingleArray:
        """The log-odds (W, F) that each family is right there; `read` (W, F) is the reading's expected worth."""
        scores = self.bias + self.reading * log_odds_of(read)
        for word, names in enumerate(terms):
            known = [self.rows[name] for name in names if name in self.rows]
            if known:
                scores[word] += self.weights[sorted(known)].sum(axis=0)
        return np.asarray(scores, np.float32)

    def explained(self, read: SingleArray, terms: Iterable[str], family: str) -> tuple[Term, ...]:
        """The contributions to a family's log-odds on one word, whose reading (F,) is `read`, the largest first."""
        place = self.families.index(family)
        weighed = [
            Term(f"{READING}: {family}", round(self.reading * float(log_odds_of(read)[place]), 2)),
            Term(f"{BIAS}: {family}", round(float(self.bias[place]), 2)),
        ]
        weighed += [
            Term(name, round(float(self.weights[self.rows[name], place]), 2)) for name in terms if name in self.rows
        ]
        heavy = (term for term in weighed if abs(term.weight) >= 0.05)
        return tuple(sorted(heavy, key=lambda term: (-abs(term.weight), term.name)))


def log_odds_of(worth: SingleArray) -> SingleArray:
    """The log-odds of worths, which are clipped away from 0 and 1."""
    kept_off = np.clip(worth, _LEAST, _MOST)
    return np.asarray(np.log(kept_off / (1 - kept_off)), np.float32)


def worth_of(log_odds: SingleArray) -> SingleArray:
    """The worth in [0, 1] for log-odds."""
    return np.asarray(1 / (1 + np.exp(-log_odds)), np.float32)

"""Fits the weights of the log-linear choice to directed lines that the readers had not seen.

    python -m training.acting.weights READINGS.npz … --terms TERMS.pkl --output models/acting/weights.json

READINGS are those of `training.acting.encoder read`, each line by a reader trained on other folds, so that the reading
is trusted as far as it can be on new lines. The worth of a family with its stroke on a word, for the one director there
is, is regressed on the reading's log-odds and the word's terms (`app/behavior/reading/choice_model.py`): logistic
regression on soft targets, the weights of terms drawn to 0. Terms on fewer than `FEWEST` words are left out. Then the
price of a gesture is set so that lines get `GESTURES_A_LINE`, and the likelihoods that head and face movements need, so
that they are not missed, or are right often enough: a wrong shake, smile or frown says the contrary of what is meant, a
wrong tilt hardly anything.
"""

import argparse
import json
import pickle
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.optimize import minimize
from scipy.sparse import csr_matrix

from understudy.behavior.reading.choice_model import log_odds_of
from understudy.behavior.reading.families import load_families
from understudy.behavior.reading.planning import expected_worth
from understudy.behavior.reading.strokes import Worth, strokes
from understudy.behavior.reading.word_times import usual_times_s
from understudy.behavior.reading.worths import lexeme_worth, shown_by_lexemes
from understudy.behavior.table.behavior_table import load_table
from understudy.files import resource_folder
from understudy.model import FloatArray, SingleArray

from .directed import FAMILIES, DirectedLine, read_lines, targets_of
from .thresholds import read_readings, thresholds

FEWEST = 60
PENALTY = 100.0
"""What a squared weight costs, in words."""

GESTURES_A_LINE = 2.1


@dataclass(frozen=True, slots=True, eq=False)
class Examples:
    """All words of all lines in a row (N): the readings' log-odds (N, F), the terms (N, T), the worths (N, F)."""

    read: SingleArray
    terms: csr_matrix
    worth: SingleArray
    names: tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Fitted:
    """The weight of the reading, the biases (F,) and the weights of the terms (T, F)."""

    reading: float
    bias: FloatArray
    weights: FloatArray

    def worth(self, examples: Examples) -> FloatArray:
        scores = self.bias + self.reading * examples.read + examples.terms @ self.weights
        return np.asarray(1 / (1 + np.exp(-scores)))


def expected(reading: SingleArray) -> SingleArray:
    """The expected worth (W, F) that a reading (W, outputs) comes to, as in `app/behavior/reading/planning.py`."""
    count = len(FAMILIES)
    return expected_worth(reading[:, :count], reading[:, count : 2 * count])


def examples_of(
    lines: Sequence[DirectedLine],
    readings: Mapping[str, SingleArray],
    terms: Mapping[str, Sequence[frozenset[str]]],
    names: tuple[str, ...] | None = None,
) -> Examples:
    """The words of the lines as examples; `names` are the terms to tell apart, by default all that are common."""
    counts = Counter(name for line in lines for word in terms[line.name] for name in word)
    names = names or tuple(sorted(name for name, count in counts.items() if count >= FEWEST))
    places = {name: place for place, name in enumerate(names)}
    rows = [[places[name] for name in sorted(word) if name in places] for line in lines for word in terms[line.name]]
    ends = np.cumsum([0, *map(len, rows)])
    columns = np.array([column for row in rows for column in row], np.int64)
    matrix = csr_matrix((np.ones(len(columns)), columns, ends), shape=(len(rows), len(names)))
    return Examples(
        read=np.concatenate([log_odds_of(expected(readings[line.name])) for line in lines]),
        terms=matrix,
        worth=np.concatenate([targets_of(line).nearby for line in lines]),
        names=names,
    )


def fitted(examples: Examples, penalty: float = PENALTY) -> Fitted:
    """The weights under which the directors' worths are likeliest, small ones before large."""
    families, count = examples.worth.shape[1], len(examples.names)
    turned = examples.terms.T.tocsr()

    def unpacked(values: FloatArray) -> Fitted:
        return Fitted(float(values[0]), values[1 : 1 + families], values[1 + families :].reshape(count, families))

    def loss(values: FloatArray) -> tuple[float, FloatArray]:
        model = unpacked(values)
        scores = model.bias + model.reading * examples.read + examples.terms @ model.weights
        surprise = np.logaddexp(0, scores).sum() - (examples.worth * scores).sum()
        error = 1 / (1 + np.exp(-scores)) - examples.worth
        slopes = np.concatenate(
            [[(error * examples.read).sum()], error.sum(axis=0), (turned @ error + penalty * model.weights).ravel()]
        )
        return float(surprise + 0.5 * penalty * (model.weights**2).sum()), slopes

    start = np.zeros(1 + families + count * families)
    start[0] = 1.0
    return unpacked(minimize(loss, start, jac=True, method="L-BFGS-B", options={"maxiter": 120}).x)


def price_of(lines: Sequence[DirectedLine], worths: Sequence[Worth]) -> float:
    """What a gesture must gain so that a line has `GESTURES_A_LINE` on average."""
    low, high = 0.01, 1.5
    for _ in range(10):
        middle = (low + high) / 2
        taken = sum(len(strokes(each, middle, usual_times_s(len(each.stroke)))) for each in worths)
        low, high = (middle, high) if taken > GESTURES_A_LINE * len(lines) else (low, middle)
    return round((low + high) / 2, 3)


def card(lines: Sequence[DirectedLine], readings: Mapping[str, SingleArray], examples: Examples) -> dict[str, object]:
    """All that models/acting/weights.json holds. Read once, a line is taken as read twice alike."""
    model, pairs = fitted(examples), [(line, line) for line in lines]
    return {
        "families": list(FAMILIES),
        "reading": round(model.reading, 4),
        "bias": {family: round(float(bias), 3) for family, bias in zip(FAMILIES, model.bias, strict=True)},
        "price": price_of(lines, [each for each, _ in lexeme_worths(lines, readings, model.worth(examples))]),
        "head": thresholds(pairs, readings, "head"),
        "face": thresholds(pairs, readings, "face"),
        "terms": {
            name: {
                family: round(float(weight), 2)
                for family, weight in zip(FAMILIES, row, strict=True)
                if abs(weight) >= 0.05
            }
            for name, row in zip(examples.names, model.weights, strict=True)
        },
    }


def lexeme_worths(
    lines: Sequence[DirectedLine], readings: Mapping[str, SingleArray], worth: FloatArray
) -> Iterator[tuple[Worth, SingleArray]]:
    """What strokes on each line are worth, and how much each lexeme shows each family (L, F)."""
    lexicon = resource_folder("lexicon")
    families = load_families(lexicon / "acting" / "families.yaml", load_table(lexicon / "behaviors.yaml").lines)
    shown = shown_by_lexemes(families.shows, FAMILIES)
    ends = np.cumsum([len(line.words) for line in lines])[:-1]
    count = len(FAMILIES)
    for line, own in zip(lines, np.split(worth.astype(np.float32), ends), strict=True):
        reading = readings[line.name]
        yield Worth(lexeme_worth(own, shown), reading[:, :count] @ shown.T, reading[:, 2 * count]), shown


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("readings", nargs="+", type=Path)
    parser.add_argument("--terms", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    arguments = parser.parse_args()
    readings = {name: row for path in arguments.readings for name, row in read_readings(path).items()}
    terms = pickle.loads(arguments.terms.read_bytes())
    lines = [line for line in read_lines(arguments.directing) if line.name in readings]
    written = card(lines, readings, examples_of(lines, readings, terms))
    arguments.output.write_text(json.dumps(written, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

import json
from pathlib import Path

import numpy as np
import pytest

from understudy.behavior.reading.choice_model import ChoiceModel, log_odds_of, worth_of
from understudy.errors import ServiceError

WRITTEN = {
    "families": ["present", "negation"],
    "reading": 1.0,
    "bias": {"present": 0.5, "negation": 0.0},
    "price": 0.4,
    "head": {"nod": 0.4},
    "face": {"smile": 0.5},
    "terms": {"function(negation)": {"negation": 2.0, "present": -1.0}, "line(last word)": {"present": 0.25}},
}
EVEN = np.full((1, 2), 0.5, np.float32)
"""A reading that says nothing either way: log-odds of 0."""


@pytest.fixture
def model(tmp_path: Path) -> ChoiceModel:
    path = tmp_path / "weights.json"
    path.write_text(json.dumps(WRITTEN))
    return ChoiceModel.load(path)


def test_log_odds_are_the_sum_of_bias_reading_and_terms(model: ChoiceModel) -> None:
    scores = model.log_odds(EVEN, [["function(negation)", "line(last word)", "a term nobody weighs"]])
    assert scores.tolist() == [[0.5 - 1.0 + 0.25, 2.0]]


def test_a_reading_counts_by_its_log_odds(model: ChoiceModel) -> None:
    read = np.array([[0.8, 0.2]], np.float32)
    assert worth_of(model.log_odds(read, [[]]))[0, 1] == pytest.approx(0.2, abs=1e-6)


def test_every_term_is_told_with_its_weight_and_the_heaviest_first(model: ChoiceModel) -> None:
    told = model.explained(np.array([0.5, 0.2], np.float32), ["function(negation)"], "negation")
    assert [(term.name, term.weight) for term in told] == [
        ("function(negation)", 2.0),
        ("reading in context: negation", round(float(np.log(0.25)), 2)),
    ]


def test_authors_add_to_weights_and_weigh_new_terms(model: ChoiceModel) -> None:
    changed = model.with_weights({"function(negation)": {"negation": -2.0}, "voice(stressed)": {"present": 1.0}})
    assert changed.log_odds(EVEN, [["function(negation)", "voice(stressed)"]]).tolist() == [[0.5 - 1.0 + 1.0, 0.0]]
    assert model.log_odds(EVEN, [["voice(stressed)"]]).tolist() == [[0.5, 0.0]]


def test_worths_and_log_odds_are_each_others_way_back() -> None:
    worth = np.array([0.01, 0.3, 0.99], np.float32)
    assert worth_of(log_odds_of(worth)) == pytest.approx(worth, abs=1e-6)


@pytest.mark.parametrize("content", ["", "[]", "{}", '{"families": ["a"], "terms": {"t": {"b": 1}}}'])
def test_a_broken_file_is_told(tmp_path: Path, content: str) -> None:
    path = tmp_path / "weights.json"
    path.write_text(content)
    with pytest.raises(ServiceError, match=r"weights\.json is not a model of gesture choice"):
        ChoiceModel.load(path)

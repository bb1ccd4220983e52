"""Smoothing, and the choice of its strength."""

from math import log

import pytest

from understudy.profiles.learning.tables import chosen_strength, folds_of, log_probability, shares_of, smoothed


def test_a_prior_is_worth_so_many_observations() -> None:
    prior = {"a": 0.5, "b": 0.5}
    assert smoothed({"a": 3}, prior, 1.0) == {"a": 3.5 / 4, "b": 0.5 / 4}
    assert smoothed({}, prior, 2.0) == prior


def test_shares_of_nothing_are_nothing() -> None:
    assert shares_of({}) == {}
    assert shares_of({"a": 1, "b": 3}) == {"a": 0.25, "b": 0.75}


def test_the_strength_with_the_greatest_likelihood_is_chosen() -> None:
    assert chosen_strength(lambda strength: -abs(strength - 10.0)) == (10.0, 0.0)
    assert chosen_strength(lambda _strength: 0.0)[0] == 300.0


def test_folds_hold_each_out_once() -> None:
    items = list(range(12))
    folds = list(folds_of(items))
    assert sorted(item for _fitted, held_out in folds for item in held_out) == items
    assert all(set(fitted) | set(held_out) == set(items) for fitted, held_out in folds)


def test_the_impossible_has_a_floor() -> None:
    assert log_probability({"a": 1.0}, "b") == pytest.approx(log(1e-9))

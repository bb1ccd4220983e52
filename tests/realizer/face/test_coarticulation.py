"""Dominance: a mean of neighbours by their say, smooth, and nothing beyond its horizon."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.realizer.face.coarticulation import HORIZON_S, Segments, blend
from understudy.realizer.face.face_tables import Dominance

TIMES_S = np.arange(0, 2, 0.001)


def dominance(*strengths: float, before_s: float = 0.03, after_s: float = 0.03) -> Dominance:
    """A kind of segment for each strength, and one articulator."""
    strength = np.array(strengths, dtype=np.float64)[:, None]
    return Dominance(strength, np.full_like(strength, before_s), np.full_like(strength, after_s), np.array([0.02]))


def segments(*ends_s: float) -> Segments:
    """One of each kind, from 0 to the last end."""
    bounds_s = np.array([0.0, *ends_s])
    return Segments(np.arange(len(ends_s)), bounds_s[:-1], bounds_s[1:], np.ones(len(ends_s)))


def course(table: Dominance, said: Segments, *targets: float) -> FloatArray:
    return blend(table, said, np.array(targets)[:, None], np.zeros(1, dtype=np.int64), TIMES_S)[:, 0]


def test_equals_meet_in_the_middle_at_their_bound() -> None:
    values = course(dominance(1, 1), segments(1, 2), 0, 1)
    assert values[1000] == pytest.approx(0.5, abs=0.02)
    assert values[:900].max() < 0.05
    assert values[1100:].min() > 0.95


def test_the_stronger_one_is_heard_beyond_its_bounds() -> None:
    values = course(dominance(1, 20, 1), segments(0.9, 1.1, 2), 0, 1, 0)
    assert values[880] > 0.7
    assert values[1120] > 0.7
    weak = course(dominance(1, 0.1, 1), segments(0.95, 1.05, 2), 0, 1, 0)
    assert weak.max() < 0.35


def test_anticipation_reaches_further_than_carrying_over_when_it_fades_slower() -> None:
    values = course(dominance(1, 1, 1, before_s=0.09, after_s=0.02), segments(0.9, 1.1, 2), 0, 1, 0)
    assert values[850] > values[1150] + 0.1


def test_values_lie_between_their_neighbours_and_do_not_jump() -> None:
    values = course(dominance(1, 30, 0.2, 2), segments(0.5, 0.55, 0.6, 2), 0.2, 0.9, 0.1, 0.4)
    assert values.min() >= 0.1
    assert values.max() <= 0.9
    assert np.abs(np.diff(values)).max() < 0.05


def test_beyond_the_horizon_there_is_nothing() -> None:
    near, far = (course(dominance(1, 1, 90), segments(1, 1 + HORIZON_S, 2), 0, 0, target) for target in (0, 1))
    assert np.array_equal(near[:1000], far[:1000])
    assert far[1990] > 0.9


def test_articulators_mind_their_own_say() -> None:
    table = Dominance(np.array([[1, 1.0], [9, 0.1]]), np.full((2, 2), 0.03), np.full((2, 2), 0.03), np.zeros(2))
    targets = np.array([[0.0, 0.0], [1.0, 1.0]])
    blended = blend(table, segments(1, 2), targets, np.array([0, 1]), TIMES_S)
    assert blended[1000, 0] > 0.8
    assert blended[1000, 1] < 0.2

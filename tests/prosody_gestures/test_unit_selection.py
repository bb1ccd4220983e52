"""Units for a path: the cheapest of all ways, by both sources' costs."""

from itertools import pairwise, product

import numpy as np
import pytest

from understudy.errors import InputError
from understudy.model import FloatArray
from understudy.prosody_gestures.semi_markov import FRAME_S, Segment
from understudy.prosody_gestures.unit_selection import (
    Pool,
    Unit,
    Weights,
    motion_of,
    paper_weights,
    select,
    stretched,
    thesis_weights,
)

PATH = (Segment(0, 0, 10), Segment(1, 10, 20), Segment(0, 30, 5), Segment(1, 35, 12))


def drawn_units(seed: int) -> list[Unit]:
    generator = np.random.default_rng(seed)
    return [
        Unit(state, generator.normal(size=(int(generator.integers(4, 30)), 3)), generator.uniform(-1, 1, 3))
        for state in (0, 0, 0, 1, 1, 1)
    ]


def cost(
    units: tuple[Unit, ...], affects: FloatArray, joint: float, duration: float, affect: float, norm: bool
) -> float:
    """The sum of a path's costs, by definition."""
    total = 0.0
    for segment, wanted, unit in zip(PATH, affects, units, strict=True):
        total += duration * abs(len(unit.angles) - segment.frames) * FRAME_S
        total += affect * float(np.mean((unit.affect - wanted) ** 2))
    for one, other in pairwise(units):
        apart = one.angles[-1] - other.angles[0]
        total += joint * float(np.linalg.norm(apart) if norm else np.mean(apart**2))
    return total


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(
    ("weights", "shares"),
    [
        (thesis_weights(0.4), (0.4, 0.6, 0.0, True)),
        (paper_weights(1.0), (0.30, 0.35, 0.35, False)),
        (paper_weights(0.0), (0.30, 0.70, 0.0, False)),
    ],
)
def test_no_other_units_cost_less(seed: int, weights: Weights, shares: tuple[float, float, float, bool]) -> None:
    units, affects = drawn_units(seed), np.random.default_rng(seed).uniform(-1, 1, (4, 3))
    offered = [[unit for unit in units if unit.state == segment.state] for segment in PATH]
    least = min(cost(each, affects, *shares) for each in product(*offered))
    chosen = select(PATH, affects, Pool.of(units), weights)
    assert [unit.state for unit in chosen] == [segment.state for segment in PATH]
    assert cost(tuple(chosen), affects, *shares) == pytest.approx(least)


def test_with_affect_the_unit_that_feels_alike_is_chosen() -> None:
    glad, sad = (Unit(0, np.zeros((10, 3)), np.full(3, feeling)) for feeling in (0.8, -0.8))
    path, wanted = (Segment(0, 0, 10),), np.full((1, 3), -0.5)
    assert select(path, wanted, Pool.of([glad, sad]), paper_weights(1.0)) == [sad]


def test_motion_has_no_jump_and_ends_where_its_unit_does() -> None:
    """Two still units, a radian apart: nine tenths of the jump are left after the first frame, next to none at the
    end."""
    units = [Unit(0, np.zeros((4, 2)), np.zeros(3)), Unit(1, np.ones((7, 2)), np.zeros(3))]
    motion = motion_of((Segment(0, 0, 10), Segment(1, 10, 30)), units)
    assert motion.shape == (40, 2)
    assert np.abs(np.diff(motion, axis=0)).max() < 0.4
    assert motion[-1] == pytest.approx([1, 1], abs=0.001)


def test_stretching_keeps_ends() -> None:
    course = np.array([[0.0, 5.0], [1.0, 3.0], [2.0, 1.0]])
    assert stretched(course, 5)[:, 0] == pytest.approx([0, 0.5, 1, 1.5, 2])
    assert stretched(course, 1).tolist() == [[0.0, 5.0]]


def test_a_state_without_units_is_named() -> None:
    with pytest.raises(InputError, match="state 7"):
        select((Segment(7, 0, 3),), np.zeros((1, 3)), Pool.of(drawn_units(0)), paper_weights(0.0))


def test_no_path_needs_no_units() -> None:
    assert select((), np.empty((0, 3)), Pool.of([]), paper_weights(1.0)) == []

"""Units for a path: the cheapest of all ways, by both sources' costs."""

from itertools import pairwise, product

import numpy as np
import pytest

from understudy.errors import InputError
from understudy.model import FloatArray
from understudy.motion_models.unit_selection import (
    MotionUnit,
    UnitPool,
    Weights,
    motion_of,
    paper_weights,
    select,
    stretched,
    thesis_weights,
)
from understudy.prosody_gestures.semi_markov import FRAME_S, Segment
from understudy.realizer.geometry.rotations import from_rotation_vector, to_rotation_vector

PATH = (Segment(0, 0, 10), Segment(1, 10, 20), Segment(0, 30, 5), Segment(1, 35, 12))


STILL = np.tile([0.0, 0.0, 0.0, 1.0], (1, 1, 1))


def unit(state: int, frames: int, angles: FloatArray, affect: FloatArray) -> MotionUnit:
    """A unit whose motion does not matter."""
    return MotionUnit(state, np.repeat(STILL, frames, axis=0), angles, affect)


def turned(angle: float, frames: int) -> FloatArray:
    """One joint, turned by so much all the time (frames × 1 × 4)."""
    return np.tile(from_rotation_vector(np.array([[angle, 0.0, 0.0]])), (frames, 1, 1))


def drawn_units(seed: int) -> list[MotionUnit]:
    generator = np.random.default_rng(seed)
    return [
        unit(state, int(generator.integers(4, 30)), generator.normal(size=(2, 3)), generator.uniform(-1, 1, 3))
        for state in (0, 0, 0, 1, 1, 1)
    ]


def cost(
    units: tuple[MotionUnit, ...], affects: FloatArray, joint: float, duration: float, affect: float, norm: bool
) -> float:
    """The sum of a path's costs, by definition."""
    total = 0.0
    for segment, wanted, unit in zip(PATH, affects, units, strict=True):
        total += duration * abs(len(unit.rotations) - segment.frames) * FRAME_S
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
    chosen = select(PATH, affects, UnitPool.of(units), weights)
    assert [unit.state for unit in chosen] == [segment.state for segment in PATH]
    assert cost(tuple(chosen), affects, *shares) == pytest.approx(least)


def test_with_affect_the_unit_that_feels_alike_is_chosen() -> None:
    glad, sad = (unit(0, 10, np.zeros((2, 3)), np.full(3, feeling)) for feeling in (0.8, -0.8))
    path, wanted = (Segment(0, 0, 10),), np.full((1, 3), -0.5)
    assert select(path, wanted, UnitPool.of([glad, sad]), paper_weights(1.0)) == [sad]


def test_motion_has_no_jump_and_ends_where_its_unit_does() -> None:
    """Two still units, a radian apart: the joint turns by less than .1 a frame, and is all there at the end."""
    nowhere = np.zeros((2, 2))
    units = [MotionUnit(0, turned(0.0, 4), nowhere, np.zeros(3)), MotionUnit(1, turned(1.0, 7), nowhere, np.zeros(3))]
    motion = motion_of((Segment(0, 0, 10), Segment(1, 10, 30)), units)
    assert motion.shape == (40, 1, 4)
    angles = to_rotation_vector(motion)[:, 0, 0]
    assert np.abs(np.diff(angles)).max() < 0.1
    assert angles[-1] == pytest.approx(1.0, abs=0.001)


def test_stretching_keeps_ends() -> None:
    course = np.concatenate([turned(angle, 1) for angle in (0.0, 0.1, 0.2)])
    assert to_rotation_vector(stretched(course, 5))[:, 0, 0] == pytest.approx([0, 0.05, 0.1, 0.15, 0.2], abs=1e-4)
    assert stretched(course, 1) == pytest.approx(turned(0.0, 1))
    assert stretched(course[:1], 3) == pytest.approx(turned(0.0, 3))


def test_a_state_without_units_is_named() -> None:
    with pytest.raises(InputError, match="state 7"):
        select((Segment(7, 0, 3),), np.zeros((1, 3)), UnitPool.of(drawn_units(0)), paper_weights(0.0))


def test_no_path_needs_no_units() -> None:
    assert select((), np.empty((0, 3)), UnitPool.of([]), paper_weights(1.0)) == []

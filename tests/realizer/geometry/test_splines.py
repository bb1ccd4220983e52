"""Splines through rotations: through the keys, smooth where they should be, and no further than they should go."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from understudy.model import FloatArray
from understudy.realizer.geometry.rotations import (
    IDENTITY,
    angle_between,
    from_axis_angle,
    inverse,
    multiply,
    to_rotation_vector,
)
from understudy.realizer.geometry.splines import Curves, rotations_at, splines

TIMES_S: FloatArray = np.array([0.0, 0.3, 0.45, 1.2, 1.9])


def keys(seed: int, largest: float = 2.8) -> FloatArray:
    """Five keys of three channels, neighbours up to `largest` radians apart, with signs at random."""
    chance = np.random.default_rng(seed)
    steps = chance.normal(size=(5, 3, 3))
    steps *= chance.uniform(0.1, largest, (5, 3, 1)) / np.linalg.norm(steps, axis=-1, keepdims=True)
    turned = [Rotation.from_rotvec(steps[0])]
    for step in steps[1:]:
        turned.append(turned[-1] * Rotation.from_rotvec(step))
    quaternions: FloatArray = np.stack([each.as_quat() for each in turned])
    signs: FloatArray = chance.choice([-1.0, 1.0], (5, 3, 1))
    return np.asarray(quaternions * signs)


def shape(seed: int, *, continuity: bool = True) -> FloatArray:
    return np.random.default_rng(seed).uniform(-1, 1, (5, 3)) * [1.0, float(continuity), 1.0]


def spline(key_times_s: FloatArray, through: FloatArray, shaped: FloatArray, times_s: FloatArray) -> FloatArray:
    """Channels (K, C, 4) that share their times and shapes."""
    return evaluated([curve(key_times_s, channel, shaped) for channel in through.swapaxes(0, 1)], times_s)


def curve(key_times_s: FloatArray, through: FloatArray, shaped: FloatArray) -> Curves:
    return Curves(key_times_s, through, shaped, np.array([len(key_times_s)]))


def evaluated(curves: list[Curves], times_s: FloatArray) -> FloatArray:
    return rotations_at(splines(Curves.joined(curves)), times_s)


def speeds(found: FloatArray, step_s: float) -> FloatArray:
    return to_rotation_vector(multiply(inverse(found[:-1]), found[1:])) / step_s


@pytest.mark.parametrize("seed", range(8))
def test_a_spline_passes_through_its_keys_and_rests_at_its_ends(seed: int) -> None:
    asked = keys(seed)
    assert np.all(angle_between(spline(TIMES_S, asked, shape(seed), TIMES_S), asked) < 1e-6)
    outside = spline(TIMES_S, asked, shape(seed), np.array([-1.0, 5.0]))
    assert np.all(angle_between(outside, asked[[0, -1]]) < 1e-6)


@pytest.mark.parametrize("seed", range(8))
def test_speed_has_no_step_at_a_key_of_continuity_zero_nor_at_the_ends(seed: int) -> None:
    step_s = 1e-5
    for key_s in TIMES_S:
        around = spline(TIMES_S, keys(seed), shape(seed, continuity=False), key_s + step_s * np.array([-1.0, 0.0, 1.0]))
        before, after = speeds(around, step_s)
        assert np.allclose(before, after, atol=0.02)


def test_a_corner_is_a_corner() -> None:
    step_s = 1e-5
    sharp = np.tile([0.0, -1.0, 0.0], (5, 1))
    around = spline(TIMES_S, keys(1), sharp, 0.45 + step_s * np.array([-1.0, 0.0, 1.0]))
    before, after = speeds(around, step_s)
    assert np.linalg.norm(before - after, axis=-1).min() > 0.5


@pytest.mark.parametrize("seed", range(8))
def test_full_tension_goes_straight_from_key_to_key(seed: int) -> None:
    asked = keys(seed)
    tense = np.tile([1.0, 0.0, 0.0], (5, 1))
    found = spline(TIMES_S, asked, tense, np.linspace(0.45, 1.2, 50))
    whole = angle_between(asked[2], asked[3])
    there_and_on = angle_between(asked[2], found) + angle_between(found, asked[3])
    assert np.allclose(there_and_on, whole, atol=1e-6)


@pytest.mark.parametrize("seed", range(8))
def test_a_repeated_key_is_held(seed: int) -> None:
    asked = keys(seed)
    asked[3] = asked[2]
    held = spline(TIMES_S, asked, shape(seed), np.linspace(0.45, 1.2, 50))
    assert np.all(angle_between(held, asked[2]) < 1e-6)


def test_neighbours_are_of_one_sign_and_of_unit_length() -> None:
    found = spline(TIMES_S, keys(3), shape(3), np.linspace(-0.2, 2.2, 600))
    assert np.all(np.sum(found[1:] * found[:-1], axis=-1) > 0)
    assert np.allclose(np.linalg.norm(found, axis=-1), 1.0)


def test_even_keys_about_one_axis_give_an_even_speed() -> None:
    turning = from_axis_angle((0.0, 0.0, 1.0), np.array([0.0, 0.2, 0.5, 0.9, 1.2]))[:, None]
    found = spline(np.array([0.0, 0.2, 0.5, 0.9, 1.2]), turning, np.zeros((5, 3)), np.linspace(0.2, 0.9, 71))
    assert np.allclose(speeds(found, 0.01)[..., 2], 1.0)


def test_one_key_is_everywhere() -> None:
    assert np.allclose(spline(np.zeros(1), IDENTITY[None, None], np.zeros((1, 3)), np.arange(4.0)), IDENTITY)


def test_curves_of_different_keys_do_not_touch_each_other() -> None:
    one, other = curve(TIMES_S, keys(1)[:, 0], shape(1)), curve(TIMES_S[1:4] + 0.1, keys(2)[1:4, 1], shape(2)[1:4])
    alone = curve(np.array([0.7]), keys(3)[:1, 0], np.zeros((1, 3)))
    times_s = np.linspace(-0.2, 2.2, 50)
    together = evaluated([alone, one, other, alone, one, alone], times_s)
    for column, each in enumerate((alone, one, other, alone, one, alone)):
        assert np.all(angle_between(together[:, column], evaluated([each], times_s)[:, 0]) < 1e-6)


@pytest.mark.parametrize("tension", [-0.5, 0.0, 1.0])
@pytest.mark.parametrize("continuity", [-1.0, 0.0, 0.6])
@pytest.mark.parametrize("bias", [-1.0, 0.0, 0.4])
def test_a_key_is_reached_and_left_as_kochanek_and_bartels_say(tension: float, continuity: float, bias: float) -> None:
    """Their equations 8 and 9, about one axis: a step of .5 radians to the key, one of .3 from it, a second each."""
    turning = from_axis_angle((0.0, 0.0, 1.0), np.array([0.0, 0.5, 0.8]))[:, None]
    shaped = np.array([[0.0, 0.0, 0.0], [tension, continuity, bias], [0.0, 0.0, 0.0]])
    step_s = 1e-5
    around = spline(np.arange(3.0), turning, shaped, 1.0 + step_s * np.array([-1.0, 0.0, 1.0]))
    more, less = (1 - tension) * (1 + bias) / 2, (1 - tension) * (1 - bias) / 2
    arriving = more * (1 - continuity) * 0.5 + less * (1 + continuity) * 0.3
    leaving = more * (1 + continuity) * 0.5 + less * (1 - continuity) * 0.3
    most = 3 * 0.3  # of the flatter side's slope, so that nothing overshoots
    expected = [min(arriving, most), min(leaving, most)]
    assert speeds(around, step_s)[:, 0, 2] == pytest.approx(expected, abs=1e-3)

"""The face's shapes do what their names say."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.mannequin.eyes import AZIMUTHS, BALL_M, CLOSED_AT, IRIS_DEGREES, brow, lids
from understudy.realizer.mannequin.face import FACE_SHAPES, MOUTH_HALF_M, MOUTH_Y_M, Tissue, displacements_m
from understudy.realizer.mannequin.head import skin

LIPS = {material: tissue for material, _surface, tissue in skin()}["lips"]
LIP_SHAPES = displacements_m(LIPS)
EYE_M = np.array([0.032, 0.075, 0.085])


def moved(lips: np.ndarray, *weights: tuple[str, float]) -> FloatArray:
    """The mean displacement of some of the lips' points."""
    total = sum((weight * LIP_SHAPES[name][lips] for name, weight in weights), np.zeros((int(lips.sum()), 3)))
    return np.asarray(total.mean(axis=0))


def along_the_line(below: bool) -> np.ndarray:
    """The middle of the upper or lower lip, at the line between them."""
    near = (np.abs(LIPS.points_m[:, 0]) < 0.010) & (np.abs(LIPS.points_m[:, 1] - MOUTH_Y_M) < 0.004)
    return np.asarray(near & (LIPS.below > 0.9 if below else LIPS.below < 0.1))


UPPER, LOWER = along_the_line(below=False), along_the_line(below=True)
LEFT_CORNER = LIPS.points_m[:, 0] > 0.9 * MOUTH_HALF_M


def test_every_shape_of_arkit_is_there_and_fifteen_visemes() -> None:
    assert FACE_SHAPES[: len(SHAPES)] == SHAPES
    assert len(FACE_SHAPES) == 67


def test_the_lips_are_closed_at_rest_and_the_jaw_parts_them() -> None:
    upper, lower = LIPS.points_m[LIPS.below < 0.4], LIPS.points_m[LIPS.below > 0.6]
    apart_m = np.linalg.norm(upper[:, None] - lower[None], axis=-1).min(axis=1)
    assert np.sum(apart_m < 1e-9) >= 20
    assert moved(UPPER, ("jawOpen", 1.0))[1] > -0.002
    assert moved(LOWER, ("jawOpen", 1.0))[1] < -0.018


def test_mouth_close_takes_back_what_the_jaw_opens() -> None:
    assert moved(LOWER, ("jawOpen", 0.7), ("mouthClose", 0.7)) == pytest.approx([0, 0, 0], abs=1e-3)


@pytest.mark.parametrize(
    ("shape", "lips", "axis", "sign"),
    [
        ("mouthSmileLeft", LEFT_CORNER, 1, 1),
        ("mouthFrownLeft", LEFT_CORNER, 1, -1),
        ("mouthStretchLeft", LEFT_CORNER, 0, 1),
        ("mouthPucker", LEFT_CORNER, 0, -1),
        ("mouthUpperUpLeft", UPPER, 1, 1),
        ("mouthLowerDownLeft", LOWER, 1, -1),
        ("mouthRollLower", LOWER, 2, -1),
        ("mouthFunnel", LOWER, 2, 1),
        ("mouthLeft", UPPER, 0, 1),
        ("mouthRight", UPPER, 0, -1),
        ("jawLeft", LOWER, 0, 1),
        ("jawForward", LOWER, 2, 1),
    ],
)
def test_shapes_move_the_lips_their_way(shape: str, lips: np.ndarray, axis: int, sign: int) -> None:
    assert sign * moved(lips, (shape, 1.0))[axis] > 0.001


@pytest.mark.parametrize("viseme", ["PP", "FF"])
def test_closing_visemes_keep_the_lips_nearly_together(viseme: str) -> None:
    gap = moved(UPPER, (f"viseme_{viseme}", 1.0)) - moved(LOWER, (f"viseme_{viseme}", 1.0))
    assert gap[1] < 0.004


def test_open_visemes_open_in_the_order_of_their_vowels() -> None:
    opening = {
        name: float((moved(UPPER, (f"viseme_{name}", 1.0)) - moved(LOWER, (f"viseme_{name}", 1.0)))[1])
        for name in ("aa", "O", "E", "I")
    }
    assert opening["aa"] > opening["O"] > opening["E"] > opening["I"] > 0


@pytest.mark.parametrize("side", ["left", "right"])
def test_lids_meet_when_they_blink_and_never_pass_through_the_ball(side: str) -> None:
    edges = []
    for material, _surface, tissue in lids(EYE_M, side):
        if material != "skin":
            continue
        shape = displacements_m(tissue)[f"eyeBlink{side.capitalize()}"]
        for weight in np.linspace(0, 1, 11):
            distances = np.linalg.norm(tissue.points_m + weight * shape - EYE_M, axis=1)
            assert distances.min() > BALL_M - 1e-4
        closed = tissue.points_m + shape - EYE_M
        middle = np.argmin(np.abs(closed[:25, 0]))
        edges.append(np.degrees(np.arctan2(closed[middle, 1], closed[middle, 2])))
    assert edges == pytest.approx([CLOSED_AT, CLOSED_AT], abs=0.5)


def test_a_shape_that_does_nothing_to_a_tissue_is_left_out() -> None:
    nothing = np.zeros(1)
    far = Tissue(np.array([[0.0, 0.15, -0.09]]), nothing, nothing, nothing)
    assert displacements_m(far) == {}


def edge_m(side: str, material: str, number: int) -> FloatArray:
    """The points of a lid's edge at rest, from the inner to the outer corner."""
    points = [tissue.points_m for name, _surface, tissue in lids(EYE_M, side) if name == material][number]
    edge = points[: len(AZIMUTHS)]
    return edge if side == "left" else edge[::-1]


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_face_at_rest_is_awake_and_does_not_worry(side: str) -> None:
    upper, lower = edge_m(side, "skin", 0), edge_m(side, "skin", 1)
    iris_m = BALL_M * np.sin(np.radians(IRIS_DEGREES))
    covered = (EYE_M[1] + iris_m - upper[:, 1].max()) / (2 * iris_m)
    assert 0.10 <= covered < 0.16
    assert lower[:, 1].min() < EYE_M[1] - 0.6 * iris_m
    apart = np.flatnonzero(np.abs(upper[:, 1] - lower[:, 1]) > 1e-4)
    assert upper[apart[-1] + 1, 1] > upper[apart[0] - 1, 1]
    surface, _tissue = brow(side)
    outwards = np.abs(surface.positions_m[:, 0])
    ends_m = [np.median(surface.positions_m[outwards < 0.018, 1]), np.median(surface.positions_m[outwards > 0.050, 1])]
    assert ends_m[0] == pytest.approx(ends_m[1], abs=0.003)

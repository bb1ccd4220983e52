"""Shape keys as rigs spell them."""

import numpy as np
import pytest

from plugins.blender.retargeting.face_weights import face_weights
from tests.plugins.blender.clips import clip
from understudy.realizer.body.motion import SHAPES

SPOKEN = clip(
    blendshapes={name: [round(number / 100, 2)] for number, name in enumerate(SHAPES)},
    visemes={"aa": [0.5], "I": [0.25], "SS": [0.5], "sil": [0.25]},
)


@pytest.mark.parametrize(
    "spelt",
    [
        str,
        lambda name: name[0].upper() + name[1:],
        lambda name: name.replace("Left", "_L").replace("Right", "_R"),
        lambda name: "".join(f"_{letter.lower()}" if letter.isupper() else letter for letter in name),
    ],
)
def test_arkits_shapes_in_every_spelling(spelt: object) -> None:
    assert callable(spelt)
    found = face_weights(["Basis", *map(spelt, SHAPES), "viseme_aa"], SPOKEN)
    assert {name: float(weights[0]) for name, weights in found.items()} == {
        spelt(name): round(number / 100, 2) for number, name in enumerate(SHAPES)
    }


def test_visemes_where_there_is_no_arkit_mouth() -> None:
    found = face_weights(["Basis", "viseme_aa", "viseme_I", "mouthSmileLeft"], SPOKEN)
    assert {name: weights.tolist() for name, weights in found.items()} == {"viseme_aa": [0.5], "viseme_I": [0.25]}


def test_vroids_mouth_is_a_sum() -> None:
    found = face_weights(["Fcl_MTH_A", "Fcl_MTH_I", "Fcl_EYE_Close_L", "Fcl_ALL_Joy"], SPOKEN)
    assert found["Fcl_MTH_A"] == pytest.approx([0.5])
    assert found["Fcl_MTH_I"] == pytest.approx([0.25 + 0.4 * 0.5])
    assert found["Fcl_EYE_Close_L"] == pytest.approx([SHAPES.index("eyeBlinkLeft") / 100])
    assert "Fcl_ALL_Joy" not in found


def test_a_mesh_without_a_face_gets_nothing_and_silence_no_visemes() -> None:
    assert face_weights(["Basis", "Key 1"], SPOKEN) == {}
    silent = face_weights(["aa"], clip(blendshapes={"eyeBlinkLeft": [0.0]}))
    assert np.array_equal(silent["aa"], [0.0])

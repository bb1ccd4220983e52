"""The VRM animation keeps to VRMC_vrm_animation 1.0."""

import numpy as np
import pytest

from tests.support.motion.gltf_reading import Gltf, read
from tests.support.motion.hand_made_motion import BODY, Y, turned, waving
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.exporting.vrma import MOODS, VOWELS, presets, to_vrma
from understudy.realizer.geometry.rotations import from_axis_angle
from understudy.realizer.mannequin.face import VISEME_MIXTURES


@pytest.fixture(scope="module")
def waved() -> Gltf:
    return read(to_vrma(waving(2.0, 60), BODY))


def test_every_bone_but_the_eyes_is_named(waved: Gltf) -> None:
    extension = waved.tree["extensions"]["VRMC_vrm_animation"]
    assert extension["specVersion"] == "1.0"
    assert waved.tree["extensionsUsed"] == ["VRMC_vrm_animation"]
    named = {
        name: waved.tree["nodes"][bone["node"]]["name"] for name, bone in extension["humanoid"]["humanBones"].items()
    }
    assert named == {name: name for name in BODY.names if not name.endswith("Eye")}


def test_only_the_hips_and_the_expressions_move_from_their_place(waved: Gltf) -> None:
    expressions = waved.tree["extensions"]["VRMC_vrm_animation"]["expressions"]["preset"]
    allowed = {waved.node("hips")} | {expression["node"] for expression in expressions.values()}
    paths = {
        (channel["target"]["node"], channel["target"]["path"]) for channel in waved.tree["animations"][0]["channels"]
    }
    assert {node for node, path in paths if path == "translation"} == allowed
    assert {path for _node, path in paths} == {"translation", "rotation"}
    assert not {waved.node("leftEye"), waved.node("rightEye")} & {node for node, _path in paths}


def test_sixty_frames_a_second_become_thirty(waved: Gltf) -> None:
    times_s, rotations = waved.track("rightLowerArm", "rotation")
    assert times_s == pytest.approx(np.arange(61) / 30)
    assert rotations == pytest.approx(waving(2.0, 60).body.rotations[::2, BODY.index["rightLowerArm"]], abs=1e-6)


def test_an_expressions_weight_is_the_x_of_its_node(waved: Gltf) -> None:
    _times_s, blink = waved.track("blinkLeft", "translation")
    expected = waving(2.0, 60).shapes[::2, SHAPES.index("eyeBlinkLeft")]
    assert blink[:, 0] == pytest.approx(expected, abs=1e-6)
    assert not blink[:, 1:].any()


def test_the_look_is_midway_between_the_eyes() -> None:
    motion = turned("leftEye", from_axis_angle(Y, np.array(0.2)))
    motion.body.rotations[:, BODY.index["rightEye"]] = from_axis_angle(Y, np.array(0.4))
    found = read(to_vrma(motion, BODY))
    node = found.tree["extensions"]["VRMC_vrm_animation"]["lookAt"]["node"]
    assert node in found.tree["nodes"][found.node("head")]["children"]
    assert found.track("lookAt", "rotation")[1][0] == pytest.approx(from_axis_angle(Y, np.array(0.3)), abs=1e-6)


@pytest.mark.parametrize("vowel", VOWELS)
def test_a_mouth_that_is_a_vowel_is_that_vowel(vowel: str) -> None:
    weights = np.zeros((1, len(SHAPES)))
    for name, weight in VISEME_MIXTURES[VOWELS[vowel]].items():
        for k, shape in enumerate(SHAPES):
            if shape in {name, f"{name}Left", f"{name}Right"}:
                weights[0, k] = weight
    found = presets(weights)
    assert max(VOWELS, key=lambda name: float(found[name][0])) == vowel
    assert found[vowel][0] > 0.6


def test_moods_are_read_from_the_face() -> None:
    weights = np.zeros((2, len(SHAPES)))
    weights[1, [SHAPES.index("mouthSmileLeft"), SHAPES.index("mouthSmileRight")]] = 1.0
    found = presets(weights)
    assert found["happy"].tolist() == [0, 1]
    assert all(found[name].tolist() == [0, 0] for name in MOODS if name != "happy")


def test_arkit_shapes_may_go_instead_of_the_presets() -> None:
    found = read(to_vrma(waving(), BODY, shapes=True))
    expressions = found.tree["extensions"]["VRMC_vrm_animation"]["expressions"]
    assert set(expressions) == {"custom"}
    assert set(expressions["custom"]) == set(SHAPES)

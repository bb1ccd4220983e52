"""Sparse animations: who moves what, how far from the baked one, and what they say of the behaviours."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from tests.support.motion.gltf_reading import Gltf, read
from tests.support.motion.hand_made_motion import BODY, waving
from understudy.model import Behavior, Channel, SyncPoints
from understudy.realizer.exporting.animations import CHANNELS, Layer
from understudy.realizer.exporting.glb import to_glb
from understudy.realizer.exporting.keyframes import PLACE_M, ROTATION_DEG, WEIGHT

SYNC = SyncPoints(0.1, 1.9)
WAVE = Behavior("wave1", Channel.GESTURE, "WAVE", SYNC, 2, 3, 1.0, rule="greet", function="f2")
NOD, LOST = replace(WAVE, id="nod2", kind=Channel.HEAD, lexeme="NOD"), replace(WAVE, id="lost")
MOTION = waving(4.0, 60)
FRAMES = len(MOTION.body.times_s)


def sparse() -> Gltf:
    motion = replace(MOTION, realized={**MOTION.realized, "nod2": SyncPoints(0.5, 1.0, ready=0.6)})
    return read(to_glb(motion, BODY, sparse_for=[WAVE, NOD, LOST]))


def track(found: Gltf, layer: Layer, node: str, path: str) -> tuple[np.ndarray, np.ndarray]:
    alone = replace(found, tree=found.tree | {"animations": [_animation(found, layer)]})
    times_s, values = alone.track(node, path)
    return np.asarray(times_s), np.asarray(values)


def _animation(found: Gltf, layer: Layer) -> dict[str, object]:
    (animation,) = (each for each in found.tree["animations"] if each["name"] == layer)
    return dict(animation)


def test_body_head_and_face_are_animations_of_their_own() -> None:
    found = sparse()
    assert [each["name"] for each in found.tree["animations"]] == ["body", "head", "face"]
    moved = [
        {(found.tree["nodes"][each["target"]["node"]]["name"], each["target"]["path"]) for each in one["channels"]}
        for one in found.tree["animations"]
    ]
    assert moved[1] == {(joint, "rotation") for joint in ("neck", "head", "leftEye", "rightEye")}
    assert moved[2] == {("Face", "weights")}
    assert len(moved[0]) == len(BODY.names) - 4 + 1
    assert len(found.tree["animations"][0]["channels"]) == len(moved[0])


@pytest.mark.parametrize("joint", ["rightLowerArm", "rightIndexProximal", "head"])
def test_players_are_within_the_tolerance_of_every_frame(joint: str) -> None:
    times_s, keys = track(sparse(), Layer.HEAD if joint == "head" else Layer.BODY, joint, "rotation")
    assert 2 < len(keys) < 0.6 * FRAMES
    played = Slerp(times_s, Rotation.from_quat(keys))(np.clip(MOTION.body.times_s, times_s[0], times_s[-1]))
    apart = Rotation.from_quat(MOTION.body.rotations[:, BODY.index[joint]]).inv() * played
    assert np.degrees(apart.magnitude().max()) <= ROTATION_DEG + 0.01


def test_hips_and_face_are_within_theirs() -> None:
    times_s, hips_m = track(sparse(), Layer.BODY, "hips", "translation")
    played = np.stack([np.interp(MOTION.body.times_s, times_s, hips_m[:, axis]) for axis in range(3)], axis=1)
    assert np.abs(played - MOTION.body.hips_m).max() <= PLACE_M + 1e-6
    times_s, weights = track(sparse(), Layer.FACE, "Face", "weights")
    played = np.stack([np.interp(MOTION.body.times_s, times_s, weights[:, k]) for k in range(52)], axis=1)
    assert np.abs(played - MOTION.shapes).max() <= WEIGHT + 1e-6


def test_markers_have_ids_times_and_reasons_where_they_are_shown() -> None:
    extras = [each["extras"] for each in sparse().tree["animations"]]
    (wave,) = extras[0]["markers"]
    assert (wave["id"], wave["lexeme"], wave["words"], wave["rule"], wave["function"]) == (
        "wave1",
        "WAVE",
        [2, 3],
        "greet",
        "f2",
    )
    assert wave["points_s"]["stroke"] == pytest.approx(0.8)
    (nod,) = extras[1]["markers"]
    assert nod["decisions"] == [{"action": "dropped", "reason": "the head was taken"}]
    assert extras[2]["markers"] == []
    assert all(each["tolerances"]["rotation_deg"] == ROTATION_DEG for each in extras)


def test_every_channel_has_its_layer() -> None:
    assert set(CHANNELS) == set(Channel)

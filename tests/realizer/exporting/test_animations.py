"""Sparse animations: who moves what, how far from the baked one, and what they say of the behaviours."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from tests.support.motion.gltf_reading import Gltf, read
from tests.support.motion.hand_made_motion import BODY, waving
from understudy.model import Behavior, Channel, FloatArray, SyncPoints
from understudy.realizer.exporting.animations import (
    CHANNELS,
    PLACE_M,
    ROTATION_DEG,
    WEIGHT,
    Layer,
    rotation_keys,
    value_keys,
)
from understudy.realizer.exporting.glb import to_glb
from understudy.realizer.geometry.rotations import with_continuous_signs

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


def wandering(frames: int, seed: int) -> FloatArray:
    """Rotations (T, 4) that turn about one axis and another, slowly and fast."""
    chance = np.random.default_rng(seed)
    times = np.linspace(0, 6, frames)
    waves = [np.sin(times * chance.uniform(0.5, 8) + chance.uniform(0, 6)) for _axis in range(3)]
    return with_continuous_signs(np.asarray(Rotation.from_rotvec(np.stack(waves, axis=-1)).as_quat()))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("tolerance_deg", [0.1, 1.0, 5.0])
def test_rotations_between_keys_are_within_the_tolerance(seed: int, tolerance_deg: float) -> None:
    """Played by scipy's slerp."""
    rotations = wandering(400, seed)
    kept = rotation_keys(rotations, np.radians(tolerance_deg))
    played = Slerp(kept, Rotation.from_quat(rotations[kept]))(np.arange(400))
    apart = (Rotation.from_quat(rotations).inv() * played).magnitude()
    assert np.degrees(apart.max()) <= tolerance_deg + 1e-6
    assert len(kept) < 400


def test_fewer_keys_for_more_tolerance_and_none_that_a_line_does_not_need() -> None:
    rotations = wandering(400, 1)
    counts = [len(rotation_keys(rotations, np.radians(degrees))) for degrees in (0.1, 0.5, 2.0, 10.0)]
    assert counts == sorted(counts, reverse=True)
    assert counts[0] > 2 * counts[-1]
    steady = np.asarray(Rotation.from_rotvec(np.outer(np.linspace(0, 2, 50), [0, 1, 0])).as_quat())
    assert rotation_keys(steady, 1e-6).tolist() == [0, 49]


def test_values_between_keys_are_within_the_tolerance_of_all_of_them() -> None:
    times = np.arange(300)
    values = np.stack([np.sin(times / 9), np.where(times == 150, 1.0, 0.0), times / 300], axis=1)
    kept = value_keys(values, 0.02)
    played = np.stack([np.interp(times, kept, values[kept, k]) for k in range(3)], axis=1)
    assert np.abs(played - values).max() <= 0.02
    assert {149, 150, 151} <= set(kept.tolist())
    assert len(kept) < 100


@pytest.mark.parametrize("frames", [1, 2])
def test_the_shortest_tracks_keep_their_frames(frames: int) -> None:
    assert len(rotation_keys(wandering(400, 0)[:frames], 0.1)) == frames
    assert len(value_keys(np.zeros((frames, 3)), 0.1)) == frames

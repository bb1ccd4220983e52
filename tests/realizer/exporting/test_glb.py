"""The GLB holds the motion, the figure and its face: parsed back by the specification alone."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.support.motion.gltf_reading import Gltf, read
from tests.support.motion.hand_made_motion import BODY, Y, Z, turned, waving
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.body.skeleton import forward
from understudy.realizer.exporting.glb import to_glb
from understudy.realizer.geometry.rotations import from_axis_angle
from understudy.realizer.mannequin.face import FACE_SHAPES

MOTION = waving()
FRAMES = len(MOTION.body.times_s)


@pytest.fixture(scope="module")
def waved() -> Gltf:
    return read(to_glb(MOTION, BODY))


def test_skinned_meshes_stand_at_the_root_with_a_joint_for_each_of_ours(waved: Gltf) -> None:
    roots = waved.tree["scenes"][0]["nodes"]
    skinned = [number for number, node in enumerate(waved.tree["nodes"]) if "skin" in node]
    assert len(skinned) == 2
    assert set(skinned) < set(roots)
    assert [waved.tree["nodes"][joint]["name"] for joint in waved.tree["skins"][0]["joints"]] == list(BODY.names)


def test_in_the_rest_pose_the_skin_stays_where_it_is(waved: Gltf) -> None:
    """A joint's place in the T-pose and its inverse bind matrix cancel out."""
    matrices = waved.values(waved.tree["skins"][0]["inverseBindMatrices"]).reshape(-1, 4, 4)
    places = np.zeros((len(BODY.names), 3))
    for joint, parent in enumerate(BODY.parents):
        places[joint] = np.array(waved.tree["nodes"][joint]["translation"]) + (places[parent] if parent >= 0 else 0)
    assert matrices[:, 3, :3] == pytest.approx(-places, abs=1e-6)
    assert matrices[:, :3, :3] == pytest.approx(np.tile(np.eye(3), (len(places), 1, 1)))


def test_the_face_has_52_shapes_and_15_visemes_each_of_which_moves_it(waved: Gltf) -> None:
    face = next(mesh for mesh in waved.tree["meshes"] if mesh["name"] == "Face")
    names = face["extras"]["targetNames"]
    assert names == list(FACE_SHAPES)
    assert len(names) == 67
    largest = dict.fromkeys(names, 0.0)
    for primitive in face["primitives"]:
        for name, target in zip(names, primitive["targets"], strict=True):
            moved = waved.values(target["POSITION"])
            assert len(moved) == waved.tree["accessors"][primitive["attributes"]["POSITION"]]["count"]
            largest[name] = max(largest[name], float(np.linalg.norm(moved, axis=1).max()))
    assert largest.pop("viseme_sil") == 0
    assert min(largest.values()) > 0.0012
    assert largest["jawOpen"] > 0.02


def test_left_shapes_move_the_characters_left(waved: Gltf) -> None:
    face = next(mesh for mesh in waved.tree["meshes"] if mesh["name"] == "Face")
    for number, name in enumerate(FACE_SHAPES):
        side = {"Left": 1, "Right": -1}.get(name[-4:] if name.endswith("Left") else name[-5:])
        if side is None or name in {"jawLeft", "jawRight", "mouthLeft", "mouthRight"}:
            continue
        total = sum(
            float(
                np.linalg.norm(waved.values(primitive["targets"][number]["POSITION"]), axis=1)
                @ waved.values(primitive["attributes"]["POSITION"])[:, 0]
            )
            for primitive in face["primitives"]
        )
        assert total * side > 0, name


def test_triangles_weights_and_bounds_are_in_order(waved: Gltf) -> None:
    for mesh in waved.tree["meshes"]:
        for primitive in mesh["primitives"]:
            attributes = primitive["attributes"]
            positions = waved.values(attributes["POSITION"])
            assert waved.values(primitive["indices"]).max() == len(positions) - 1
            assert waved.values(attributes["WEIGHTS_0"]).sum(axis=1) == pytest.approx(1.0, abs=1e-5)
            assert np.linalg.norm(waved.values(attributes["NORMAL"]), axis=1) == pytest.approx(1.0, abs=1e-4)
            accessor = waved.tree["accessors"][attributes["POSITION"]]
            assert accessor["min"] == positions.min(axis=0).tolist()
            assert accessor["max"] == positions.max(axis=0).tolist()


def test_tracks_hold_the_motion_and_their_times_rise(waved: Gltf) -> None:
    times_s, rotations = waved.track("rightLowerArm", "rotation")
    assert len(times_s) == FRAMES
    assert times_s[0] == 0
    assert (np.diff(times_s) > 0).all()
    assert times_s[-1] == pytest.approx(MOTION.duration_s)
    assert rotations == pytest.approx(MOTION.body.rotations[:, BODY.index["rightLowerArm"]], abs=1e-6)
    assert waved.track("hips", "translation")[1] == pytest.approx(MOTION.body.hips_m, abs=1e-6)


def test_all_weights_of_a_key_stand_together_and_visemes_rest(waved: Gltf) -> None:
    times_s, weights = waved.track("Face", "weights")
    assert weights.shape == (FRAMES, 67)
    assert weights[:, : len(SHAPES)] == pytest.approx(MOTION.shapes, abs=1e-6)
    assert not weights[:, len(SHAPES) :].any()
    assert len(times_s) == FRAMES


def test_a_joint_that_never_moves_has_one_key(waved: Gltf) -> None:
    times_s, rotations = waved.track("leftUpperArm", "rotation")
    assert times_s.tolist() == [0]
    assert rotations[0] == pytest.approx(from_axis_angle(Z, np.array(-1.25)), abs=1e-6)


def test_neighbouring_rotations_have_one_sign() -> None:
    spin = from_axis_angle(Y, np.linspace(0, 4 * np.pi, 60))
    spin[20:40] *= -1
    _times_s, rotations = read(to_glb(turned("head", spin, frames=60), BODY)).track("head", "rotation")
    assert (np.sum(rotations[1:] * rotations[:-1], axis=1) > 0).all()


def test_forward_kinematics_of_the_nodes_put_the_joints_where_we_have_them(waved: Gltf) -> None:
    places, turns = np.zeros((FRAMES, len(BODY.names), 3)), {}
    for joint, parent in enumerate(BODY.parents):
        rotations = waved.track(BODY.names[joint], "rotation")[1]
        turn = Rotation.from_quat(np.broadcast_to(rotations, (FRAMES, 4)))
        if parent < 0:
            places[:, joint], turns[joint] = waved.track("hips", "translation")[1], turn
        else:
            offset = waved.tree["nodes"][joint]["translation"]
            places[:, joint] = places[:, parent] + turns[parent].apply(offset)
            turns[joint] = turns[parent] * turn
    ours, _turns = forward(BODY, MOTION.body.rotations, MOTION.body.hips_m)
    assert np.abs(places - ours).max() < 1e-5


def test_events_by_bml_id_and_decisions_go_with_the_animation(waved: Gltf) -> None:
    extras = waved.tree["animations"][0]["extras"]
    assert {"behavior": "wave1", "point": "stroke", "time_s": 0.8} in extras["events"]
    assert extras["decisions"] == [{"behavior": "nod2", "action": "dropped", "reason": "the head was taken"}]

"""The motion on other avatars: however they rest and whatever their joints are called, they stand as ours does."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from benchmarks.realizer.exporting.avatar_mutants import mutants, outcome, short_motion, small_avatar
from tests.support.motion.gltf_reading import Gltf, read
from tests.support.motion.hand_made_motion import BODY, waving
from tests.support.shared_data import AVATAR, needs
from understudy.errors import InputError, UndecodableError
from understudy.model import FloatArray
from understudy.realizer.avatars.avatar import to_avatar_glb
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.body.skeleton import forward
from understudy.realizer.exporting.gltf import Accessors, Json, joint_nodes, to_glb_bytes
from understudy.realizer.exporting.retargeting import load_rigs

RIGS = load_rigs(Path(__file__).parents[3] / "lexicon" / "retarget", BODY)
MOTION = waving(1.0)
FRAMES = len(MOTION.body.times_s)
FOREARM = ("rightLowerArm", "rightHand")


def avatar(nodes: list[Any], *, targets: tuple[str, ...] = ("jawOpen", "mine"), **parts: Json) -> bytes:
    """A file of these nodes and a triangle with morph targets."""
    accessors = Accessors()
    corners = np.eye(3)
    position = accessors.floats(corners, bounds=True, target="ARRAY_BUFFER")
    moved = [{"POSITION": accessors.displacements(corners * 0.1)} for _ in targets]
    mesh = {
        "primitives": [{"attributes": {"POSITION": position}, "targets": moved}],
        "extras": {"targetNames": targets},
    }
    tree: dict[str, Any] = {"nodes": [*nodes, {"name": "Mesh", "mesh": 0}], "meshes": [mesh], **parts}
    return to_glb_bytes(tree, accessors)


def t_posed() -> list[Any]:
    return [dict(node) for node in joint_nodes(BODY)]


def a_posed() -> list[Any]:
    """Arms down by 45° at rest, yet no node turned: the offsets say it."""
    nodes = t_posed()
    for side, sign in (("left", -1), ("right", 1)):
        down = Rotation.from_euler("z", sign * 45, degrees=True)
        for name, joint in BODY.index.items():
            if name.startswith(side) and any(
                part in name for part in ("LowerArm", "Hand", "Proximal", "Inter", "Dist", "Meta")
            ):
                nodes[joint]["translation"] = down.apply(nodes[joint]["translation"]).tolist()
    return nodes


def along_bones() -> list[Any]:
    """Every joint has axes of its own at rest, as Mixamo's have."""
    nodes = t_posed()
    turns = [Rotation.from_euler("xyz", [20 * joint, 7 * joint, 0], degrees=True) for joint in range(len(nodes))]
    for joint, parent in enumerate(BODY.parents):
        above = turns[parent] if parent >= 0 else Rotation.identity()
        nodes[joint]["rotation"] = (above.inv() * turns[joint]).as_quat().tolist()
        nodes[joint]["translation"] = above.inv().apply(nodes[joint]["translation"]).tolist()
    return nodes


def directions(found: Gltf, names: tuple[str, str]) -> FloatArray:
    """Where a bone points in each frame (T, 3), by forward kinematics over the file's nodes."""
    ends = [_world(found, found.node(name))[0] for name in names]
    along = ends[1] - ends[0]
    return np.asarray(along / np.linalg.norm(along, axis=1, keepdims=True))


def _world(found: Gltf, number: int) -> tuple[FloatArray, Rotation]:
    node = found.tree["nodes"][number]
    channels = {(each["target"]["node"], each["target"]["path"]) for each in found.tree["animations"][0]["channels"]}
    turn = np.array(node.get("rotation", [0, 0, 0, 1]))
    place = np.array(node.get("translation", [0, 0, 0]), dtype=np.float64)
    if (number, "rotation") in channels:
        turn = found.track(node["name"], "rotation")[1]
    if (number, "translation") in channels:
        place = found.track(node["name"], "translation")[1]
    here = Rotation.from_quat(np.broadcast_to(turn, (FRAMES, 4)))
    parent = next((k for k, each in enumerate(found.tree["nodes"]) if number in each.get("children", [])), None)
    if parent is None:
        return np.broadcast_to(place, (FRAMES, 3)), here
    above_m, above = _world(found, parent)
    return above_m + above.apply(place), above * here


def ours(names: tuple[str, str]) -> FloatArray:
    places, _turns = forward(BODY, MOTION.body.rotations, MOTION.body.hips_m)
    along = places[:, BODY.index[names[1]]] - places[:, BODY.index[names[0]]]
    return np.asarray(along / np.linalg.norm(along, axis=1, keepdims=True))


@pytest.mark.parametrize("nodes", [t_posed, a_posed, along_bones])
@pytest.mark.parametrize(
    "bone", [FOREARM, ("leftUpperArm", "leftLowerArm"), ("rightIndexProximal", "rightIndexIntermediate")]
)
def test_limbs_point_as_ours_do_however_the_avatar_rests(nodes: Callable[[], list[Any]], bone: tuple[str, str]) -> None:
    found = read(to_avatar_glb(MOTION, BODY, avatar(nodes()), RIGS))
    assert directions(found, bone) == pytest.approx(ours(bone), abs=1e-5)


def test_an_avatar_that_faces_backwards_is_turned_with_its_back() -> None:
    nodes = t_posed()
    for node in nodes:
        x, y, z = node["translation"]
        node["translation"] = [-x, y, -z]
    found = read(to_avatar_glb(MOTION, BODY, avatar(nodes), RIGS))
    assert directions(found, FOREARM) == pytest.approx(ours(FOREARM) * [-1, 1, -1], abs=1e-5)


def test_hips_move_in_proportion_to_the_avatars_legs() -> None:
    nodes = t_posed()
    nodes[0]["translation"][1] /= 2
    found = read(to_avatar_glb(MOTION, BODY, avatar(nodes), RIGS))
    moved = found.track("hips", "translation")[1]
    assert moved == pytest.approx(MOTION.body.hips_m / 2, abs=1e-6)


@pytest.mark.parametrize("rig", ["mixamo", "unreal"])
def test_joints_are_found_by_the_names_of_rigs_with_or_without_colons(rig: str) -> None:
    nodes = t_posed()
    for node, name in zip(nodes, RIGS[rig].names.values(), strict=True):
        node["name"] = f"mixamorig{name}" if rig == "mixamo" else name
    found = read(to_avatar_glb(MOTION, BODY, avatar(nodes), RIGS))
    assert len(found.tree["animations"][0]["channels"]) == len(BODY.names) + 2


@pytest.mark.parametrize("version", [0, 1])
def test_vrms_table_of_bones_goes_before_names(version: int) -> None:
    nodes = t_posed()
    for node in nodes:
        node["name"] = f"x{node['name']}"
    if version == 1:
        extension: Any = {
            "VRMC_vrm": {"humanoid": {"humanBones": {name: {"node": k} for name, k in BODY.index.items()}}}
        }
    else:
        old = {"ThumbProximal": "ThumbIntermediate", "ThumbMetacarpal": "ThumbProximal"}
        bones = [{"bone": re.sub("Thumb(Proximal|Metacarpal)", lambda found: old[found[0]], name), "node": joint}
                 for name, joint in BODY.index.items()]  # fmt: skip
        extension = {"VRM": {"humanoid": {"humanBones": bones}}}
    found = read(to_avatar_glb(MOTION, BODY, avatar(nodes, extensions=extension), RIGS))
    assert found.track("xrightThumbMetacarpal", "rotation")[1] is not None
    assert len(found.tree["animations"][0]["channels"]) == len(BODY.names) + 2


def test_the_face_goes_to_targets_of_arkits_names_and_others_stay() -> None:
    weights = read(to_avatar_glb(MOTION, BODY, avatar(t_posed()), RIGS)).track("Mesh", "weights")[1]
    assert weights[:, 0] == pytest.approx(MOTION.shapes[:, SHAPES.index("jawOpen")], abs=1e-6)
    assert not weights[:, 1].any()


def test_eyeballs_that_turn_by_joints_are_not_moved_by_shapes_too() -> None:
    found = read(to_avatar_glb(MOTION, BODY, avatar(t_posed(), targets=("eyeLookUpLeft",)), RIGS))
    assert "weights" not in {each["target"]["path"] for each in found.tree["animations"][0]["channels"]}


def test_the_avatar_itself_is_kept() -> None:
    given = avatar(t_posed(), asset={"version": "2.0", "copyright": "somebody"})
    before, after = read(given), read(to_avatar_glb(MOTION, BODY, given, RIGS))
    assert after.tree["asset"]["copyright"] == "somebody"
    assert after.tree["nodes"] == before.tree["nodes"]
    assert after.tree["accessors"][: len(before.tree["accessors"])] == before.tree["accessors"]
    assert after.buffer.startswith(before.buffer)


def test_an_avatar_without_arms_is_refused_by_name() -> None:
    nodes = [node for node in t_posed() if "Arm" not in node["name"]]
    with pytest.raises(InputError, match="leftUpperArm") as caught:
        to_avatar_glb(MOTION, BODY, avatar([{"name": node["name"]} for node in nodes]), RIGS)
    assert caught.value.code == "unknown_avatar"


def circular() -> bytes:
    nodes = t_posed()
    nodes[BODY.index["leftToes"]]["children"] = [BODY.index["leftFoot"]]
    return avatar(nodes)


@pytest.mark.parametrize(
    "content",
    [b"", b"glTF", b"RIFF" * 20, avatar(t_posed())[:60], circular(), avatar([{"children": [99]}]), avatar(["hips"])],
)
def test_files_that_are_no_avatar_are_refused(content: bytes) -> None:
    with pytest.raises(UndecodableError) as caught:
        to_avatar_glb(MOTION, BODY, content, RIGS)
    assert caught.value.code == "avatar_undecodable"


@needs(AVATAR)
def test_a_real_avatar_in_an_a_pose_points_where_ours_does() -> None:
    found = read(to_avatar_glb(MOTION, BODY, AVATAR.read_bytes(), RIGS))
    names = (RIGS["ready_player_me"].names[FOREARM[0]], RIGS["ready_player_me"].names[FOREARM[1]])
    assert directions(found, names) == pytest.approx(ours(FOREARM), abs=1e-4)


def with_matrices() -> list[Any]:
    """Every joint is placed by a matrix, as some exporters write nodes."""
    nodes = along_bones()
    for node in nodes:
        matrix = np.eye(4)
        matrix[:3, :3] = Rotation.from_quat(node.pop("rotation")).as_matrix()
        matrix[:3, 3] = node.pop("translation")
        node["matrix"] = matrix.T.reshape(-1).tolist()
    return nodes


def test_joints_placed_by_matrices_get_their_parts_since_what_is_animated_has_no_matrix() -> None:
    found = read(to_avatar_glb(MOTION, BODY, avatar(with_matrices()), RIGS))
    assert directions(found, FOREARM) == pytest.approx(ours(FOREARM), abs=1e-5)
    assert all("matrix" not in node for node in found.tree["nodes"])


def test_nodes_between_joints_stay_as_they_rest() -> None:
    nodes = t_posed()
    twist = len(nodes)
    nodes[BODY.index["rightLowerArm"]]["children"] = [twist]
    nodes.append({"name": "twist", "rotation": [0, 0.6, 0, 0.8], "children": [BODY.index["rightHand"]]})
    offset = Rotation.from_quat([0, 0.6, 0, 0.8]).inv().apply(nodes[BODY.index["rightHand"]]["translation"])
    nodes[BODY.index["rightHand"]]["translation"] = offset.tolist()
    found = read(to_avatar_glb(MOTION, BODY, avatar(nodes), RIGS))
    assert directions(found, FOREARM) == pytest.approx(ours(FOREARM), abs=1e-5)


def of(change: Callable[[dict[str, Any]], object]) -> bytes:
    """The avatar, after a change to its JSON."""
    content = avatar(t_posed())
    size = int.from_bytes(content[12:16], "little")
    tree = json.loads(content[20 : 20 + size])
    change(tree)
    text = json.dumps(tree).encode()
    return content[:12] + len(text).to_bytes(4, "little") + content[16:20] + text + content[20 + size :]


SHEAR = [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


@pytest.mark.parametrize(
    ("change", "where"),
    [
        (lambda tree: tree.update(buffers={}), "buffers"),
        (lambda tree: tree.update(buffers=None), "buffers"),
        (lambda tree: tree.update(buffers=[None]), "buffers.0"),
        (lambda tree: tree.update(buffers=[{"byteLength": 3, "uri": "hair.bin"}]), "buffers.0.uri"),
        (lambda tree: tree["buffers"][0].update(byteLength=10**9), "buffers.0.byteLength"),
        (lambda tree: tree["bufferViews"][0].update(byteOffset=10**6), "bufferViews.0"),
        (lambda tree: tree["accessors"][0].update(bufferView=99), "accessors.0.bufferView"),
        (lambda tree: tree.update(nodes={}), "nodes"),
        (lambda tree: tree["nodes"][0].update(children=[2.7]), "nodes.0.children.0"),
        (lambda tree: tree["nodes"][0].update(children=[-1]), "nodes.0.children.0"),
        (lambda tree: tree["nodes"][0].update(children=[10**30]), "nodes.0.children.0"),
        (lambda tree: tree["nodes"][0].update(children=[999]), "nodes.0.children"),
        (lambda tree: tree["nodes"][4].update(rotation=[float("nan"), 0, 0, 1]), "NaN"),
        (lambda tree: tree["nodes"][4].update(rotation=[0, 0, 0, 0]), "nodes.4.rotation"),
        (lambda tree: tree["nodes"][4].update(translation=[0, 1e30, 0]), "nodes.4.translation.1"),
        (lambda tree: tree["nodes"][4].update(translation=[0, True, 0]), "nodes.4.translation.1"),
        (
            lambda tree: tree["nodes"][4].update(matrix=SHEAR),
            "nodes.4.matrix",
        ),
        (lambda tree: tree["nodes"][-1].update(mesh=1), "there is no mesh 1"),
        (lambda tree: tree["nodes"].append({"children": [0], "scale": [0, 0, 0]}), "scaled to nothing"),
        (lambda tree: tree.update(extensions={"VRM": {"humanoid": {"humanBones": [{}]}}}), "humanBones.0"),
        (
            lambda tree: tree.update(
                extensions={"VRMC_vrm": {"humanoid": {"humanBones": {"hips": {"node": 0}, "spine": {"node": 0}}}}}
            ),
            "node 0 is both 'hips' and 'spine'",
        ),
    ],
)
def test_what_cannot_be_right_is_refused_with_its_place(change: Callable[[dict[str, Any]], object], where: str) -> None:
    with pytest.raises(UndecodableError, match=re.escape(where)) as caught:
        to_avatar_glb(MOTION, BODY, of(change), RIGS)
    assert caught.value.code == "avatar_undecodable"


def test_whatever_is_broken_is_refused_by_a_code_or_worn_with_finite_numbers() -> None:
    motion = short_motion(BODY)
    found = [outcome(each, motion, BODY, RIGS) for each in mutants(small_avatar(), 150, seed=14)]
    assert set(found) <= {"worn", "avatar_undecodable", "unknown_avatar"}

"""Reads MPEG-4's body and face parameters by the layout of the files that others play (vreng, Greta), and turns body
parameters back into rotations of our joints.

Written from the description of the format, not from our writer: masks are read column by column, the order of columns
is spelt out by number, and angles are composed with matrices.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from understudy.model import FloatArray

RAD = 1e-5
FACE_COLUMNS = 68
SEVERAL = {0: 4, 1: 6}
"""How many numbers FAP 1 (two visemes, blend, def) and FAP 2 (two expressions with intensities, init, def) have."""

COLUMNS = {"sacroiliac": 1, "hip": 4, "knee": 10, "ankle": 14, "subtalar": 18, "toe": 22, "clavicle": 24}
COLUMNS |= {"shoulder": 32, "elbow": 38, "wrist": 42, "skullbase": 48, "vc4": 60, "vt6": 87, "vt10": 99, "vl3": 114}
COLUMNS |= {"pinky": 123, "ring": 135, "middle": 147, "index": 159, "thumb": 171, "place": 181, "root": 184}
"""The first column of each joint, counted from 1; left and right alternate."""

TRUNK = {"spine": "vl3", "chest": "vt10", "upperChest": "vt6", "neck": "vc4", "head": "skullbase"}
HINGE = np.array([0.513, 0.643, -0.570])


@dataclass(frozen=True)
class ParameterFile:
    """The first line, the masks (T, N) and the values (T, N), 0 where they are not set."""

    version: str
    name: str
    rate_hz: int
    masks: np.ndarray[tuple[int, int], np.dtype[np.int64]]
    values: np.ndarray[tuple[int, int], np.dtype[np.int64]]
    several: list[dict[int, list[int]]]
    """All numbers of each set column, frame by frame."""


def read_parameters(content: bytes) -> ParameterFile:
    first, *rows = content.decode("ascii").splitlines()
    version, name, rate, count = first.split()
    assert len(rows) == 2 * int(count)
    masks = np.array([[int(bit) for bit in row.split()] for row in rows[::2]])
    values, several = np.zeros_like(masks), []
    for frame, row in enumerate(rows[1::2]):
        number, *told = map(int, row.split())
        assert number == frame
        set_ones = np.flatnonzero(masks[frame]).tolist()
        counts = [SEVERAL.get(column, 1) if masks.shape[1] == FACE_COLUMNS else 1 for column in set_ones]
        assert len(told) == sum(counts)
        starts = np.cumsum([0, *counts[:-1]])
        values[frame, set_ones] = np.array(told)[starts]
        several.append(
            {column: told[start : start + count] for column, start, count in zip(set_ones, starts, counts, strict=True)}
        )
    return ParameterFile(version, name, int(rate), masks, values, several)


class Body:
    """The angles of one file, as rotations (T,) of our joints about the axes of the pose with the arms down."""

    def __init__(self, file: ParameterFile) -> None:
        self._rad = file.values * RAD
        self.place_mm = file.values[:, 180:183]

    def joints(self) -> dict[str, Rotation]:
        found = {"hips": self._turns("XZY", [(186, 1), (185, 1), (184, 1)])}
        for joint, bone in TRUNK.items():
            start = COLUMNS[bone]
            found[joint] = self._turns("XZY", [(start + 2, -1), (start, 1), (start + 1, 1)])
        for offset, side, inward in ((0, "left", -1), (1, "right", 1)):
            hang = Rotation.from_euler("z", 90 * inward, degrees=True)
            found |= {side + name: turn for name, turn in self._limbs(offset, hang).items()}
            found |= {side + name: turn for name, turn in self._fingers(offset, inward, hang).items()}
        return found

    def _limbs(self, offset: int, hang: Rotation) -> dict[str, Rotation]:
        def at(bone: str, place: int) -> int:
            return COLUMNS[bone] + offset + 2 * place

        foot = self._turns("XZY", [(at("ankle", 0), -1), (at("subtalar", 0), 1), (at("ankle", 1), -1)])
        arm = self._turns("XZY", [(at("shoulder", 0), -1), (at("shoulder", 1), 1), (at("shoulder", 2), -1)])
        forearm = self._turns("XY", [(at("elbow", 0), -1), (at("elbow", 1), -1)])
        hand = self._turns("XZY", [(at("wrist", 1), -1), (at("wrist", 0), -1), (at("wrist", 2), -1)])
        return {
            "Shoulder": self._turns("YZ", [(at("clavicle", 1), 1), (at("clavicle", 0), 1)]),
            "UpperArm": arm * hang,
            "LowerArm": hang.inv() * forearm * hang,
            "Hand": hang.inv() * hand * hang,
            "UpperLeg": self._turns("XZY", [(at("hip", 0), -1), (at("hip", 1), 1), (at("hip", 2), -1)]),
            "LowerLeg": self._turns("XY", [(at("knee", 0), -1), (at("knee", 1), -1)]),
            "Foot": foot,
            "Toes": self._turns("X", [(at("toe", 0), -1)]),
        }

    def _fingers(self, offset: int, inward: int, hang: Rotation) -> dict[str, Rotation]:
        found = {}
        for name, finger in (("Index", "index"), ("Middle", "middle"), ("Ring", "ring"), ("Little", "pinky")):
            start = COLUMNS[finger] + offset
            root = self._turns("ZXY", [(start + 2, inward), (start + 4, 1), (start + 6, -1)])
            found[f"{name}Proximal"] = hang.inv() * root * hang
            found[f"{name}Intermediate"] = self._turns("Z", [(start + 8, inward)])
            found[f"{name}Distal"] = self._turns("Z", [(start + 10, inward)])
        start = COLUMNS["thumb"] + offset
        thumb = self._turns("XZY", [(start, -1), (start + 2, 1), (start + 4, -1)])
        hinge = HINGE / np.linalg.norm(HINGE) * np.array([1.0, -inward, -inward])
        found["ThumbMetacarpal"] = hang.inv() * thumb * hang
        found["ThumbProximal"] = Rotation.from_rotvec(self._rad[:, start + 5, None] * hinge)
        found["ThumbDistal"] = Rotation.from_rotvec(self._rad[:, start + 7, None] * hinge)
        return found

    def _turns(self, order: str, columns: list[tuple[int, int]]) -> Rotation:
        turn = Rotation.identity()
        for axis, (column, sign) in zip(order, columns, strict=True):
            turn = turn * Rotation.from_euler(axis.lower(), sign * self._rad[:, [column - 1]])
        return turn


GRETA_JOINTS: dict[str, tuple[str, tuple[int, int, int]]] = {
    "hips": ("", (186, 184, 185)),
    **{
        joint: (parent, (COLUMNS[bone] + 2, COLUMNS[bone] + 1, COLUMNS[bone]))
        for (joint, bone), parent in zip(TRUNK.items(), ("hips", *TRUNK), strict=False)
    },
}
"""Of each joint its parent and its columns about X, Y and Z, 0 where it has none, as in Greta's `JointType`."""

for _offset, _side in enumerate(("left", "right")):

    def _at(bone: str, place: int, offset: int = _offset) -> int:
        return COLUMNS[bone] + offset + 2 * place

    GRETA_JOINTS |= {
        f"{_side}Shoulder": ("upperChest", (0, _at("clavicle", 1), _at("clavicle", 0))),
        f"{_side}UpperArm": (f"{_side}Shoulder", (_at("shoulder", 0), _at("shoulder", 2), _at("shoulder", 1))),
        f"{_side}LowerArm": (f"{_side}UpperArm", (_at("elbow", 0), _at("elbow", 1), 0)),
        f"{_side}Hand": (f"{_side}LowerArm", (_at("wrist", 1), _at("wrist", 2), _at("wrist", 0))),
        f"{_side}UpperLeg": ("hips", (_at("hip", 0), _at("hip", 2), _at("hip", 1))),
        f"{_side}LowerLeg": (f"{_side}UpperLeg", (_at("knee", 0), _at("knee", 1), 0)),
        f"{_side}Ankle": (f"{_side}LowerLeg", (_at("ankle", 0), _at("ankle", 1), 0)),
        f"{_side}Foot": (f"{_side}Ankle", (0, 0, _at("subtalar", 0))),
        f"{_side}Toes": (f"{_side}Foot", (_at("toe", 0), 0, 0)),
        f"{_side}ThumbMetacarpal": (f"{_side}Hand", (_at("thumb", 0), _at("thumb", 1), _at("thumb", 2))),
    }
    for _ours, _finger in (("Index", "index"), ("Middle", "middle"), ("Ring", "ring"), ("Little", "pinky")):
        _name = f"{_side}{_ours}"
        GRETA_JOINTS |= {
            f"{_name}Proximal": (f"{_side}Hand", (_at(_finger, 2), _at(_finger, 3), _at(_finger, 1))),
            f"{_name}Intermediate": (f"{_name}Proximal", (0, 0, _at(_finger, 4))),
            f"{_name}Distal": (f"{_name}Intermediate", (0, 0, _at(_finger, 5))),
        }


def greta_world(file: ParameterFile) -> dict[str, Rotation]:
    """The orientations (T,) of Greta's joints in the world, from the pose with the arms down: Rz·Ry·Rx."""
    found: dict[str, Rotation] = {"": Rotation.identity()}
    for joint, (parent, columns) in GRETA_JOINTS.items():
        about = {
            axis: Rotation.from_euler(axis, file.values[:, [column - 1]] * RAD)
            for axis, column in zip("xyz", columns, strict=True)
            if column
        }
        x, y, z = (about.get(axis, Rotation.identity()) for axis in "xyz")
        found[joint] = found[parent] * z * y * x
    return found


def world(joints: dict[str, Rotation], names: tuple[str, ...], parents: tuple[int, ...]) -> list[FloatArray]:
    """The orientations (T, 3, 3) of joints in the world."""
    found: list[Rotation] = []
    for name, parent in zip(names, parents, strict=True):
        local = joints.get(name, Rotation.identity())
        found.append(local if parent < 0 else found[parent] * local)
    return [np.asarray(each.as_matrix()) for each in found]

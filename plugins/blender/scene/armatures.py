"""Armatures as retargeting knows them, and the custom properties and bones of those that are performed on."""

from typing import Any

import numpy as np

from ..retargeting.armature import Armature, RestBone
from ..retargeting.bone_tables import BoneTable, load_tables
from ..retargeting.matching import BoneMap, find_bones
from ..retargeting.skeleton import NEEDED


class NoHumanoidError(ValueError):
    """An armature whose bones are not found; the message says which."""


def bones_of(armature: Any) -> BoneMap:
    """The bones of an armature object by our joints: as its list of bones says, where there is one, else by their
    names. Raises NoHumanoidError if too few are found."""
    tables = load_tables()
    written = {each.joint: each.bone for each in armature.understudy.bones if each.bone in armature.data.bones}
    found = find_bones([bone.name for bone in armature.data.bones], tables)
    if written:
        table = next((each for each in tables if each.name == armature.understudy.table), found.table)
        found = BoneMap(table, written)
    if found.missing:
        message = f"{armature.name} has no bones for {', '.join(found.missing)}: name them in the list of bones"
        raise NoHumanoidError(message)
    return found


def list_bones(armature: Any, found: BoneMap) -> None:
    """Writes the bones into the armature's list, where they can be changed: what is found, and what is needed."""
    settings = armature.understudy
    settings.table = found.table.name
    settings.bones.clear()
    for joint in dict.fromkeys((*NEEDED, *found.table.names)):
        entry = settings.bones.add()
        entry.joint, entry.bone = joint, found.bones.get(joint, "")


def rest_of(armature: Any, found: BoneMap) -> Armature:
    """The armature at rest. Blender has parents before their children."""
    bones = {bone.name: _rest_bone(bone) for bone in armature.data.bones}
    return Armature(bones, found.bones)


def apply_properties(armature: Any, table: BoneTable) -> list[str]:
    """Sets the custom properties that the table asks for; those that changed, for the person to know."""
    changed = []
    for each in table.properties:
        bone = armature.pose.bones.get(each.bone)
        if bone is not None and each.name in bone and bone[each.name] != each.value:
            bone[each.name] = each.value
            changed.append(f"{each.bone}[{each.name}]")
    if changed:
        armature.update_tag()
    return changed


def _rest_bone(bone: Any) -> RestBone:
    matrix = np.array(bone.matrix_local)
    return RestBone(
        bone.name,
        bone.parent.name if bone.parent else "",
        matrix[:3, 3],
        matrix[:3, :3],
        bone.use_inherit_rotation,
        bone.use_local_location,
    )

"""Performers: a character's own body is added, or the bones of an armature are found."""

import tempfile
from pathlib import Path
from typing import Any

import bpy

from ...retargeting.bone_tables import load_tables
from ...retargeting.matching import find_bones
from ...scene.armatures import list_bones
from ..jobs import JobOperator, Work
from ..preferences import connection
from ..requests import performer_of


class AddMannequin(JobOperator):
    """Add a character's own body at the cursor, rigged, with a face"""

    bl_idname = "understudy.add_mannequin"
    bl_label = "Add Mannequin"

    character: bpy.props.StringProperty(name="Character", default="default")

    def gather(self, context: Any) -> Work:
        connected, character = connection(context), self.character
        return lambda _progress, _cancelled: connected.mannequin(character)

    def finish(self, context: Any, result: bytes) -> tuple[str, ...]:
        there, actions = set(bpy.data.objects), set(bpy.data.actions)
        with tempfile.TemporaryDirectory(prefix="understudy-") as folder:
            path = Path(folder) / "mannequin.glb"
            path.write_bytes(result)
            bpy.ops.import_scene.gltf(filepath=str(path))
        added = [each for each in bpy.data.objects if each not in there]
        armature = next(each for each in added if each.type == "ARMATURE")
        for owner in (
            *added,
            *(each.data.shape_keys for each in added if each.type == "MESH" and each.data.shape_keys),
        ):
            owner.animation_data_clear()
        for action in [each for each in bpy.data.actions if each not in actions]:
            bpy.data.actions.remove(action)
        for pose in armature.pose.bones:
            pose.matrix_basis.identity()
        armature.name = self.character.replace("_", " ").title() if self.character != "default" else "Mannequin"
        armature.location = context.scene.cursor.location
        armature.understudy.character = self.character
        context.view_layer.objects.active = armature
        return ()


class FindBones(bpy.types.Operator):
    """Find the armature's bones by their names, and list them so that they can be changed"""

    bl_idname = "understudy.find_bones"
    bl_label = "Find Bones"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        try:
            armature = performer_of(context)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        found = find_bones([bone.name for bone in armature.data.bones], load_tables())
        list_bones(armature, found)
        if found.missing:
            self.report({"WARNING"}, f"no bones for {', '.join(found.missing)}: name them in the list")
        else:
            self.report({"INFO"}, f"{found.table.title}: {len(found.bones)} bones")
        return {"FINISHED"}


CLASSES = (AddMannequin, FindBones)

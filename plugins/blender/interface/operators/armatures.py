"""Performers: a character's own body is added, or the bones of an armature are found."""

from typing import Any

import bpy

from ...retargeting.bone_tables import load_tables
from ...retargeting.matching import find_bones
from ...scene.armatures import list_bones
from ...scene.mannequins import add_body
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
        armature = add_body(result)
        armature.name = "Mannequin" if self.character == "default" else self.character.replace("_", " ").title()
        armature.location = context.scene.cursor.location
        armature.understudy.character = self.character
        context.view_layer.objects.active = armature
        return ()


class FindBones(bpy.types.Operator):
    """Match the armature's bones by name and list them for editing"""

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

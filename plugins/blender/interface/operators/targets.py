"""The list of things to look and point at."""

from typing import Any

import bpy


class AddTarget(bpy.types.Operator):
    """Add the selected objects to what can be looked and pointed at, or an empty entry"""

    bl_idname = "understudy.add_target"
    bl_label = "Add Target"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        targets = context.scene.understudy.targets
        there = {each.thing for each in targets}
        chosen = [each for each in context.selected_objects if each.type != "ARMATURE" and each not in there]
        for thing in chosen or [None]:
            targets.add().thing = thing
        return {"FINISHED"}


class RemoveTarget(bpy.types.Operator):
    """Take the entry out of the list"""

    bl_idname = "understudy.remove_target"
    bl_label = "Remove Target"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        settings = context.scene.understudy
        settings.targets.remove(settings.active_target)
        settings.active_target = max(settings.active_target - 1, 0)
        return {"FINISHED"}


CLASSES = (AddTarget, RemoveTarget)

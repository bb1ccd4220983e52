"""The list of things to look and point at."""

from typing import Any

import bpy


class AddTarget(bpy.types.Operator):
    """Add the selected objects as targets of gaze and pointing, or an empty entry"""

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
    """Remove the entry from the list"""

    bl_idname = "understudy.remove_target"
    bl_label = "Remove Target"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        settings = context.scene.understudy
        settings.targets.remove(settings.active_target)
        settings.active_target = max(settings.active_target - 1, 0)
        return {"FINISHED"}


CLASSES = (AddTarget, RemoveTarget)

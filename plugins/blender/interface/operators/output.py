"""Out of Blender: a performed armature as one action, FBX or USD, and a scene as a timeline."""

from pathlib import Path
from typing import Any

import bpy
from bpy_extras.io_utils import ExportHelper

from ...scene.baking import bake, unbake
from ...scene.exports import export_fbx, export_usd
from ...scene.sounds import frame_rate_hz
from ...scene.timelines import tracks_of
from ...schedule.otio import to_otio
from ..requests import performer_of


class Bake(bpy.types.Operator):
    """Bake the performance into one action and mute its source tracks"""

    bl_idname = "understudy.bake"
    bl_label = "Bake to Action"
    bl_options = {"REGISTER", "UNDO"}

    sparse: bpy.props.BoolProperty(
        name="Sparse Keys", default=True, description="Only the keys needed to keep the motion within a quarter degree"
    )

    def execute(self, context: Any) -> set[str]:
        try:
            baked = bake(context.scene, performer_of(context), sparse=self.sparse)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        frames = baked.last_frame - baked.first_frame + 1
        self.report({"INFO"}, f"{frames} frames baked, {baked.most_keys} keys on a joint at most")
        return {"FINISHED"}


class Unbake(bpy.types.Operator):
    """Remove the baked action and unmute its source tracks"""

    bl_idname = "understudy.unbake"
    bl_label = "Remove Baked Action"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        if not unbake(performer_of(context)):
            self.report({"WARNING"}, "nothing was baked")
        return {"FINISHED"}


class _Export(bpy.types.Operator, ExportHelper):
    """Writes a file."""

    def write(self, context: Any, path: Path) -> None:
        raise NotImplementedError

    def execute(self, context: Any) -> set[str]:
        try:
            self.write(context, Path(self.filepath))
        except (ValueError, OSError, RuntimeError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class ExportFbx(_Export):
    """Write the performed armature with its meshes as FBX, baked into one take"""

    bl_idname = "understudy.export_fbx"
    bl_label = "Export FBX"

    filename_ext = ".fbx"
    filter_glob: bpy.props.StringProperty(default="*.fbx", options={"HIDDEN"})

    def write(self, context: Any, path: Path) -> None:
        export_fbx(context, performer_of(context), path, sparse=context.scene.understudy.sparse_keys)


class ExportUsd(_Export):
    """Write the performed armature with its meshes as USD, baked"""

    bl_idname = "understudy.export_usd"
    bl_label = "Export USD"

    filename_ext = ".usdc"
    filter_glob: bpy.props.StringProperty(default="*.usd;*.usda;*.usdc", options={"HIDDEN"})

    def write(self, context: Any, path: Path) -> None:
        export_usd(context, performer_of(context), path)


class ExportOtio(_Export):
    """Write the scene's sounds and behaviours as an OpenTimelineIO timeline"""

    bl_idname = "understudy.export_otio"
    bl_label = "Export Timeline (OTIO)"

    filename_ext = ".otio"
    filter_glob: bpy.props.StringProperty(default="*.otio", options={"HIDDEN"})

    def write(self, context: Any, path: Path) -> None:
        scene = context.scene
        path.write_bytes(to_otio(scene.name, tracks_of(scene), frame_rate_hz(scene), scene.frame_start))


CLASSES = (Bake, Unbake, ExportFbx, ExportUsd, ExportOtio)

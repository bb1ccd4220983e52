"""A performed armature with its meshes as FBX or USD: baked for the export, and afterwards as it was.

Blender's FBX exporter bakes every NLA strip as a take of its own, each behaviour too, unless it is told not to; its
USD exporter writes what an action plays.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import bpy

from .baking import bake, unbake


def export_fbx(context: Any, armature: Any, path: Path, *, sparse: bool) -> None:
    """Writes FBX of the armature, its meshes and one take. Raises NothingToBakeError."""
    with _exported(context, armature):
        bpy.ops.export_scene.fbx(
            filepath=str(path),
            use_selection=True,
            object_types={"ARMATURE", "MESH"},
            apply_scale_options="FBX_SCALE_ALL",
            add_leaf_bones=False,
            bake_anim_use_nla_strips=False,
            bake_anim_use_all_actions=False,
            bake_anim_force_startend_keying=True,
            bake_anim_simplify_factor=1.0 if sparse else 0.0,
        )


def export_usd(context: Any, armature: Any, path: Path) -> None:
    """Writes USD of the armature, its meshes and its motion, a sample in every frame. Raises NothingToBakeError."""
    with _exported(context, armature):
        bpy.ops.wm.usd_export(filepath=str(path), selected_objects_only=True, export_animation=True)


@contextmanager
def _exported(context: Any, armature: Any) -> Iterator[None]:
    """The armature baked and selected with its meshes, the scene's frames those of its performances."""
    scene, layer = context.scene, context.view_layer
    range_before = (scene.frame_start, scene.frame_end)
    selected, active = list(context.selected_objects), layer.objects.active
    is_baked = bool(armature.animation_data and armature.animation_data.action)
    try:
        if not is_baked:
            baked = bake(scene, armature, sparse=False)
            scene.frame_start, scene.frame_end = baked.first_frame, baked.last_frame
        for each in selected:
            each.select_set(False)
        for each in (armature, *_meshes(armature)):
            each.select_set(True)
        layer.objects.active = armature
        yield
    finally:
        if not is_baked:
            unbake(armature)
        scene.frame_start, scene.frame_end = range_before
        for each in context.selected_objects:
            each.select_set(False)
        for each in selected:
            each.select_set(True)
        layer.objects.active = active


def _meshes(armature: Any) -> list[Any]:
    """The meshes that the armature carries or moves."""
    return [
        each
        for each in bpy.data.objects
        if each.type == "MESH"
        and (
            each in armature.children_recursive
            or any(part.type == "ARMATURE" and part.object is armature for part in each.modifiers)
        )
    ]

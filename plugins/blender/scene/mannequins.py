"""Understudy's own bodies: a GLB becomes an armature at rest with its meshes."""

import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import bpy


def add_body(glb: bytes) -> Any:
    """The armature of a GLB, without the file's motion."""
    objects, actions = set(bpy.data.objects), set(bpy.data.actions)
    with tempfile.TemporaryDirectory(prefix="understudy-") as folder:
        path = Path(folder) / "mannequin.glb"
        path.write_bytes(glb)
        bpy.ops.import_scene.gltf(filepath=str(path))
    added = [each for each in bpy.data.objects if each not in objects]
    armature = next(each for each in added if each.type == "ARMATURE")
    _forget_motion(added, [each for each in bpy.data.actions if each not in actions])
    for pose in armature.pose.bones:
        pose.matrix_basis.identity()
        pose.custom_shape = None
    for each in set(added) - {armature, *armature.children_recursive}:
        bpy.data.objects.remove(each)  # what the importer draws bones with
    return armature


def _forget_motion(objects: Sequence[Any], actions: Sequence[Any]) -> None:
    keys = [each.data.shape_keys for each in objects if each.type == "MESH" and each.data.shape_keys]
    for owner in (*objects, *keys):
        owner.animation_data_clear()
    for action in actions:
        bpy.data.actions.remove(action)

"""Makes an FBX of a GLB. Blender runs this, in a process of its own; our code never imports it.

    blender --background --factory-startup --python-exit-code 1 --python in_blender.py -- IN.glb OUT.fbx RATE FRAMES

A Python that has `bpy` runs it without the options before the file. Blender's glTF reader counts frames at the scene's
rate, and does not set the scene's end, without which the FBX would have more frames than the motion.
"""

import sys

import bpy


def convert(glb: str, fbx: str, rate_hz: int, frames: int) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps, scene.render.fps_base = rate_hz, 1.0
    bpy.ops.import_scene.gltf(filepath=glb, bone_heuristic="TEMPERANCE", guess_original_bind_pose=False)
    for empty in [each for each in scene.objects if each.type == "EMPTY"]:
        bpy.data.objects.remove(empty)  # the reader makes one of the node that the face's weights are animated on
    for each in scene.objects:
        each.name = each.data.name
    scene.frame_start, scene.frame_end = 0, frames - 1
    scene.frame_set(0)
    bpy.ops.export_scene.fbx(
        filepath=fbx,
        apply_scale_options="FBX_SCALE_ALL",
        axis_forward="-Z",
        axis_up="Y",
        object_types={"ARMATURE", "MESH", "EMPTY"},
        use_custom_props=True,
        add_leaf_bones=False,
        bake_anim_use_all_bones=True,
        bake_anim_use_nla_strips=False,
        bake_anim_use_all_actions=False,
        bake_anim_force_startend_keying=True,
        bake_anim_simplify_factor=0.0,
    )


if __name__ == "__main__":
    given = sys.argv[sys.argv.index("--") + 1 :]
    convert(given[0], given[1], int(given[2]), int(given[3]))

"""What lies on NLA tracks, and where bones are."""

import json
from typing import Any

import numpy as np

from plugins.blender.motion.clip import Clip
from plugins.blender.motion.rotations import Array


def tracks(owner: Any) -> dict[str, list[Any]]:
    """The strips of each track by its name."""
    data = owner.animation_data
    return {track.name: list(track.strips) for track in data.nla_tracks} if data else {}


def strip(owner: Any, name: str) -> Any:
    """The strip whose name begins so."""
    (found,) = [each for strips in tracks(owner).values() for each in strips if each.name.startswith(name)]
    return found


def id_of(strip: Any) -> str:
    """The BML id of the behaviour that a strip stands for; empty for strips of motion."""
    written = strip.action.get("understudy_behavior")
    return str(json.loads(written)["id"]) if written else ""


def behavior_strip(owner: Any, name: str) -> Any:
    """The strip of the behaviour with this id."""
    (found,) = [each for strips in tracks(owner).values() for each in strips if id_of(each) == name]
    return found


def heads(blender: Any, armature: Any, frame: int) -> dict[str, Array]:
    """Where each bone begins in the world in a frame, in our axes: Y up, facing Z."""
    blender.context.scene.frame_set(frame)
    found = {}
    for bone in armature.pose.bones:
        x, y, z = armature.matrix_world @ bone.head
        found[bone.name] = np.array([x, z, -y])
    return found


def joints_m(clip: Clip, frame: int) -> dict[str, Array]:
    """Where our joints are in a frame of the clip, by their offsets and rotations."""
    world = clip.world_rotations()
    places: dict[str, Array] = {}
    for joint, parent in clip.parents.items():
        offset = clip.offsets_m[joint]
        places[joint] = places[parent] + world[parent][frame] @ offset if parent else clip.hips_m[frame]
    return places

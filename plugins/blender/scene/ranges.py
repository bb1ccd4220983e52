"""The scene's frame range, which is extended to the lines that are added."""

from math import ceil, floor
from typing import Any

from ..motion.clip import Clip
from .layers import OWNER

_USUAL = (1, 250)
"""The range of a new scene, which nobody chose."""


def take_in(scene: Any, clip: Clip, zero_frame: float, rate_hz: float) -> None:
    """Sets the scene's frame range to its lines: the first sets the range, later ones widen it."""
    first, last = floor(zero_frame + clip.start_s * rate_hz), ceil(zero_frame + clip.end_s * rate_hz)
    alone = sum(1 for each in scene.objects if each.type == "ARMATURE" for _strip in _lines(each)) <= 1
    if alone or (scene.frame_start, scene.frame_end) == _USUAL:
        scene.frame_start, scene.frame_end = max(first, 0), last
    else:
        scene.frame_start, scene.frame_end = min(scene.frame_start, max(first, 0)), max(scene.frame_end, last)


def _lines(armature: Any) -> set[str]:
    """The performances whose strips are on an armature."""
    tracks = armature.animation_data.nla_tracks if armature.animation_data else ()
    strips = (strip for track in tracks for strip in track.strips if strip.action is not None)
    return {strip.action[OWNER] for strip in strips if OWNER in strip.action}

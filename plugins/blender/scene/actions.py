"""Actions with their curves, whichever way this Blender stores them.

Up to Blender 4.3 an action holds curves; from 4.4 on it has slots, one a data-block that it animates, with the curves
of each in a bag, and 5.0 knows no other way.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import bpy
import numpy as np

from ..motion.rotations import Array

_LINEAR = 1
LONGEST_NAME = 63
"""Bytes of a name in Blender."""


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """The values (T,) of a property, at `frames` (T,) or one a frame from the action's first; `group` is where the
    editors show it."""

    path: str
    index: int
    values: Array
    group: str = ""
    frames: Array | None = None


def new_action(name: str, owner: Any, curves: Iterable[Curve], frames: float, *, first: float = 0.0) -> Any:
    """An action that animates `owner`, an object or shape keys, from frame `first` to `frames`."""
    action = bpy.data.actions.new(name)
    action.use_frame_range, action.frame_start, action.frame_end = True, first, frames
    bag = _bag(action, owner)
    for curve in curves:
        _fill(_new_curve(bag, curve), curve)
    return action


def curves_of(action: Any) -> list[Any]:
    """All curves of an action."""
    if not hasattr(action, "layers"):
        return list(action.fcurves)
    bags = (bag for layer in action.layers for strip in layer.strips for bag in strip.channelbags)
    return [curve for bag in bags for curve in bag.fcurves]


def assign_slot(strip: Any, action: Any) -> None:
    """Has an NLA strip play the only slot of its action."""
    if hasattr(strip, "action_slot"):
        strip.action_slot = action.slots[0]


def assign_action(owner: Any, action: Any) -> None:
    """Has a data-block play an action of one slot; None: no action."""
    data = owner.animation_data or owner.animation_data_create()
    data.action = action
    if action is not None and hasattr(data, "action_slot"):
        data.action_slot = action.slots[0]


def mark(action: Any, name: str, frame: float) -> None:
    """A marker of the action; a name that is too long is cut."""
    marker = action.pose_markers.new(shortened(name))
    marker.frame = round(frame)


def shortened(name: str) -> str:
    """As much of a name as Blender keeps."""
    return name.encode()[:LONGEST_NAME].decode(errors="ignore")


def _bag(action: Any, owner: Any) -> Any:
    """The collection that new curves are added to: the action itself, or the channel bag of its only slot."""
    if not hasattr(action, "layers"):
        action.id_root = _kind(owner)
        return action
    slot = action.slots.new(id_type=_kind(owner), name=owner.name)
    strip = action.layers.new("Layer").strips.new(type="KEYFRAME")
    return strip.channelbag(slot, ensure=True)


def _kind(owner: Any) -> str:
    return "KEY" if isinstance(owner, bpy.types.Key) else "OBJECT"


def _new_curve(bag: Any, curve: Curve) -> Any:
    """Groups are named when a curve is made: `action_group` before Blender 4.4, in bags `group_name` from 5.0 on."""
    made = bag.fcurves.new(curve.path, index=curve.index)
    if curve.group:
        group = bag.groups.get(curve.group) or bag.groups.new(curve.group)
        made.group = group
    return made


def _fill(made: Any, curve: Curve) -> None:
    """A key in every frame that has a value, or a single one where nothing changes, with straight lines between."""
    values = np.asarray(curve.values, dtype=float)
    frames = np.arange(len(values)) if curve.frames is None else np.asarray(curve.frames, dtype=float)
    if np.all(values == values[0]):
        values, frames = values[:1], frames[:1]
    made.keyframe_points.add(len(values))
    places = np.stack([frames, values], axis=1)
    made.keyframe_points.foreach_set("co", places.ravel())
    made.keyframe_points.foreach_set("interpolation", np.full(len(values), _LINEAR, dtype=np.int32))
    made.update()

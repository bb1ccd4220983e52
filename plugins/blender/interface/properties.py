"""The settings that are saved with the file: how the next line is performed, and what armatures remember."""

from typing import Any

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

LARGEST_SEED = 2**31 - 1


class TargetSettings(bpy.types.PropertyGroup):
    """Something to look and point at."""

    thing: PointerProperty(
        type=bpy.types.Object, name="Object", description="The object to point and look at for words with this name"
    )


class BoneSettings(bpy.types.PropertyGroup):
    """The bone of a joint."""

    joint: StringProperty(name="Joint")
    bone: StringProperty(name="Bone", description="The bone that this joint drives")


class StripRecord(bpy.types.PropertyGroup):
    """An NLA strip of a take that is not shown, under the group's own name: its action, the mesh whose shape keys it
    plays on (empty: the armature), its track and place, and how it blends with others."""

    action: PointerProperty(type=bpy.types.Action)
    mesh: PointerProperty(type=bpy.types.Object)
    track: StringProperty()
    start_frame: FloatProperty()
    end_frame: FloatProperty()
    mute: BoolProperty()


class TakeRecord(bpy.types.PropertyGroup):
    """A take of a performance; its name is the group's own. `strips` are those of a take that is not shown."""

    bml: PointerProperty(type=bpy.types.Text, name="BML")
    trace: PointerProperty(type=bpy.types.Text, name="Record")
    behaviors: StringProperty()
    order: StringProperty()
    strips: CollectionProperty(type=StripRecord)


class NoteRecord(bpy.types.PropertyGroup):
    """A note on a line, as JSON; its name is what it asks for in words."""

    content: StringProperty()


def _show_chosen(record: Any, _context: Any) -> None:
    """Shows the take that was clicked in the list."""
    if record.active_take_row != record.active_take:
        bpy.ops.understudy.show_take(number=record.active_take_row)


class PerformanceRecord(bpy.types.PropertyGroup):
    """A performance of the armature; its name is the group's own. BML, record, behaviours and order are
    those of the take that is shown."""

    zero_frame: FloatProperty(name="Frame", description="The frame at which the recording begins")
    bml: PointerProperty(type=bpy.types.Text, name="BML")
    trace: PointerProperty(type=bpy.types.Text, name="Record", description="Words, functions and reasons, as JSON")
    behaviors: StringProperty()
    order: StringProperty()
    takes: CollectionProperty(type=TakeRecord)
    active_take: IntProperty()
    active_take_row: IntProperty(update=_show_chosen)
    notes: CollectionProperty(type=NoteRecord)
    active_note: IntProperty()


class PerformerSettings(bpy.types.PropertyGroup):
    """An armature's own settings."""

    character: StringProperty(
        name="Character", default="default", description="Character: size and frequency of gestures"
    )
    profile: StringProperty(name="Profile", description="Gesture profile of a speaker; empty for the character's own")
    table: StringProperty()
    bones: CollectionProperty(type=BoneSettings)
    active_bone: IntProperty()
    performances: CollectionProperty(type=PerformanceRecord)
    active_performance: IntProperty()


def _is_armature(_settings: Any, thing: Any) -> bool:
    return bool(thing.type == "ARMATURE")


def _is_camera(_settings: Any, thing: Any) -> bool:
    return bool(thing.type == "CAMERA")


class LineSettings(bpy.types.PropertyGroup):
    """How the next line is performed."""

    source: EnumProperty(
        name="Recording",
        items=[
            ("STRIP", "Strip", "Sound strip in the sequencer"),
            ("FILE", "File", "A file, placed in the sequencer at the current frame"),
        ],
    )
    strip: StringProperty(name="Strip", description="Sound strip in the sequencer")
    audio: StringProperty(name="File", subtype="FILE_PATH", description="A recording")
    text: StringProperty(
        name="Text", description="The words of the line; if empty, those of the strip or of text strips beside it"
    )
    performer: PointerProperty(
        type=bpy.types.Object,
        name="Performer",
        poll=_is_armature,
        description="The armature that performs; if empty, the active one",
    )
    seed: IntProperty(name="Seed", min=-LARGEST_SEED, max=LARGEST_SEED, description="Random seed")
    agitation: EnumProperty(
        name="Agitation",
        items=[
            ("HEARD", "As Heard", "As the voice sounds"),
            ("low", "Low", "Lax"),
            ("medium", "Medium", "As usual"),
            ("high", "High", "Tense"),
        ],
    )
    stillness: FloatProperty(name="Stillness", min=0, max=1, subtype="FACTOR", description="Reduces all movement")
    lead_in_s: FloatProperty(
        name="Lead-In",
        min=0,
        max=3,
        unit="TIME_ABSOLUTE",
        description="Time before the recording in which the performance begins",
    )
    tail_s: FloatProperty(
        name="Tail",
        min=0,
        max=10,
        unit="TIME_ABSOLUTE",
        description="Time after the recording in which the performance ends",
    )
    listener: PointerProperty(
        type=bpy.types.Object, name="Listener", description="The person or object that is addressed"
    )
    listener_performs: BoolProperty(
        name="Listener Reacts", default=True, description="Perform the listener too, if it is an armature"
    )
    camera: PointerProperty(
        type=bpy.types.Object,
        name="Camera",
        poll=_is_camera,
        description="A camera to look at; it is addressed if there is no listener",
    )
    targets: CollectionProperty(type=TargetSettings)
    active_target: IntProperty()
    set_range: BoolProperty(name="Set Range", default=True, description="Extend the scene's frame range to the line")
    sparse_keys: BoolProperty(
        name="Sparse Keys",
        default=True,
        description="Bake only the keys needed to keep the motion within .25°",
    )


class JobSettings(bpy.types.PropertyGroup):
    """The progress of the current job."""

    running: BoolProperty()
    cancel: BoolProperty()
    stage: StringProperty()
    done: FloatProperty(min=0, max=1, subtype="FACTOR")


CLASSES = (
    TargetSettings,
    BoneSettings,
    StripRecord,
    TakeRecord,
    NoteRecord,
    PerformanceRecord,
    PerformerSettings,
    LineSettings,
    JobSettings,
)


def register() -> None:
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.understudy = PointerProperty(type=LineSettings)
    bpy.types.Object.understudy = PointerProperty(type=PerformerSettings)
    bpy.types.WindowManager.understudy = PointerProperty(type=JobSettings)


def unregister() -> None:
    del bpy.types.WindowManager.understudy
    del bpy.types.Object.understudy
    del bpy.types.Scene.understudy
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)

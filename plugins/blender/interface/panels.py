"""The panels: in the sidebars of the 3D view and of the sequencer, under the tab Understudy."""

from typing import Any

import bpy

from ..scene.behavior_strips import strips_of
from ..schedule.behaviors import gestures_in

_TAB = "Understudy"


class TargetList(bpy.types.UIList):
    """What can be looked and pointed at."""

    bl_idname = "UNDERSTUDY_UL_targets"

    def draw_item(
        self, _context: Any, layout: Any, _data: Any, item: Any, _icon: int, _active_data: Any, _active: str
    ) -> None:
        layout.prop(item, "thing", text="", emboss=False)


class BoneList(bpy.types.UIList):
    """The bones of an armature by our joints."""

    bl_idname = "UNDERSTUDY_UL_bones"

    def draw_item(
        self, context: Any, layout: Any, _data: Any, item: Any, _icon: int, _active_data: Any, _active: str
    ) -> None:
        row = layout.split(factor=0.45)
        row.label(text=item.joint)
        row.prop_search(item, "bone", context.object.data, "bones", text="")


class PerformanceList(bpy.types.UIList):
    """The performances of an armature."""

    bl_idname = "UNDERSTUDY_UL_performances"

    def draw_item(
        self, _context: Any, layout: Any, _data: Any, item: Any, _icon: int, _active_data: Any, _active: str
    ) -> None:
        row = layout.row()
        row.label(text=item.name, icon="OUTLINER_OB_SPEAKER")
        row.label(text=f"frame {item.zero_frame:.0f}")


class TakeList(bpy.types.UIList):
    """The takes of a performance, each with its gestures; the one that is lit is shown, others have a cross."""

    bl_idname = "UNDERSTUDY_UL_takes"

    def draw_item(
        self, _context: Any, layout: Any, data: Any, item: Any, _icon: int, _active_data: Any, _active: str, index: int
    ) -> None:
        shown = data.active_take == index
        row = layout.split(factor=0.25)
        row.label(text=item.name)
        rest = row.row(align=True)
        rest.label(text=gestures_in(item.behaviors) or "no gestures")
        if not shown:
            rest.operator("understudy.remove_take", text="", icon="X", emboss=False).number = index


class NoteList(bpy.types.UIList):
    """The notes on a line, each with a cross."""

    bl_idname = "UNDERSTUDY_UL_notes"

    def draw_item(
        self, _context: Any, layout: Any, _data: Any, item: Any, _icon: int, _active_data: Any, _active: str, index: int
    ) -> None:
        row = layout.row(align=True)
        row.label(text=item.name, icon="PINNED")
        row.operator("understudy.clear_notes", text="", icon="X", emboss=False).number = index


def draw_line(layout: Any, context: Any) -> None:
    """The line, who performs it and how, and the button."""
    settings = context.scene.understudy
    layout.use_property_split = True
    layout.use_property_decorate = False
    layout.row().prop(settings, "source", expand=True)
    if settings.source == "FILE":
        layout.prop(settings, "audio")
    elif context.scene.sequence_editor:
        editor = context.scene.sequence_editor
        layout.prop_search(settings, "strip", editor, "strips" if hasattr(editor, "strips") else "sequences")
    else:
        layout.label(text="The sequencer has no strips", icon="INFO")
    layout.prop(settings, "text")
    layout.prop(settings, "performer")
    performer = settings.performer or context.object
    if performer is not None and performer.type == "ARMATURE":
        layout.prop(performer.understudy, "character")
        layout.prop(performer.understudy, "profile")
    for name in ("seed", "agitation", "stillness", "lead_in_s", "tail_s", "set_range"):
        layout.prop(settings, name)
    draw_button(layout, context)


def draw_button(layout: Any, context: Any) -> None:
    """What starts the work, or how far it is."""
    state = context.window_manager.understudy
    if not state.running:
        layout.operator("understudy.perform", icon="PLAY")
        layout.operator("understudy.perform_all", icon="SEQ_SEQUENCER")
        layout.operator("understudy.import_script", icon="IMPORT")
        return
    row = layout.row(align=True)
    row.progress(factor=state.done, text=state.stage)
    row.operator("understudy.cancel", text="", icon="X")


class LineView3D(bpy.types.Panel):
    """Performs a line."""

    bl_idname = "UNDERSTUDY_PT_line"
    bl_label = "Perform"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = _TAB

    def draw(self, context: Any) -> None:
        draw_line(self.layout, context)


class LineSequencer(bpy.types.Panel):
    """Performs a line, its strip at hand."""

    bl_idname = "UNDERSTUDY_PT_line_sequencer"
    bl_label = "Perform"
    bl_space_type = "SEQUENCE_EDITOR"
    bl_region_type = "UI"
    bl_category = _TAB

    def draw(self, context: Any) -> None:
        draw_line(self.layout, context)


class Scene(bpy.types.Panel):
    """Listener, camera and targets."""

    bl_idname = "UNDERSTUDY_PT_scene"
    bl_label = "Listener and Targets"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = _TAB

    def draw(self, context: Any) -> None:
        settings, layout = context.scene.understudy, self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for name in ("listener", "listener_performs", "camera"):
            layout.prop(settings, name)
        row = layout.row()
        row.template_list("UNDERSTUDY_UL_targets", "", settings, "targets", settings, "active_target", rows=3)
        column = row.column(align=True)
        column.operator("understudy.add_target", text="", icon="ADD")
        column.operator("understudy.remove_target", text="", icon="REMOVE")


class Performances(bpy.types.Panel):
    """The armature's performances and their strips."""

    bl_idname = "UNDERSTUDY_PT_performances"
    bl_label = "Performances"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = _TAB

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.object is not None and context.object.type == "ARMATURE"

    def draw(self, context: Any) -> None:
        own, layout = context.object.understudy, self.layout
        layout.template_list("UNDERSTUDY_UL_performances", "", own, "performances", own, "active_performance", rows=2)
        layout.operator("understudy.import_bml", icon="IMPORT")
        if not 0 <= own.active_performance < len(own.performances):
            return
        record = own.performances[own.active_performance]
        column = layout.column(align=True)
        column.operator("understudy.play_strips", icon="FILE_REFRESH")
        column.operator("understudy.perform_again", icon="MOD_PHYSICS")
        column.operator("understudy.lock_strips", icon="LOCKED")
        column.operator("understudy.export_bml", icon="EXPORT")
        column.operator("understudy.forget", icon="TRASH").name = record.name
        _draw_takes(layout, record)
        _draw_notes(layout, record)
        for strip in (each for each in strips_of(context.object, record.name) if each.strip.select):
            box = layout.box().column(align=True)
            box.label(text=strip.behavior.label)
            for text in (strip.behavior.words, strip.behavior.why, *strip.behavior.decisions):
                if text:
                    box.label(text=text)


def _draw_takes(layout: Any, record: Any) -> None:
    if len(record.takes) > 1:
        layout.label(text="Takes")
        layout.template_list("UNDERSTUDY_UL_takes", "", record, "takes", record, "active_take_row", rows=2)


def _draw_notes(layout: Any, record: Any) -> None:
    if record.notes:
        row = layout.row()
        row.label(text="Notes")
        row.operator("understudy.clear_notes", text="Clear")
        layout.template_list("UNDERSTUDY_UL_notes", "", record, "notes", record, "active_note", rows=2)


class Output(bpy.types.Panel):
    """A performed armature as one action, and as files."""

    bl_idname = "UNDERSTUDY_PT_output"
    bl_label = "Bake and Export"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = _TAB
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.object is not None and context.object.type == "ARMATURE"

    def draw(self, context: Any) -> None:
        settings, layout = context.scene.understudy, self.layout
        layout.prop(settings, "sparse_keys")
        column = layout.column(align=True)
        column.operator("understudy.bake", icon="ACTION").sparse = settings.sparse_keys
        column.operator("understudy.unbake", icon="LOOP_BACK")
        column.operator("understudy.export_fbx", icon="EXPORT")
        column.operator("understudy.export_usd", icon="EXPORT")
        column.operator("understudy.export_otio", icon="EXPORT")


class Bones(bpy.types.Panel):
    """The performer's bones."""

    bl_idname = "UNDERSTUDY_PT_bones"
    bl_label = "Performer"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = _TAB
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: Any) -> None:
        layout = self.layout
        layout.operator("understudy.add_mannequin", icon="ADD")
        if context.object is None or context.object.type != "ARMATURE":
            return
        layout.operator("understudy.find_bones", icon="VIEWZOOM")
        own = context.object.understudy
        if own.bones:
            layout.template_list("UNDERSTUDY_UL_bones", "", own, "bones", own, "active_bone", rows=8)


CLASSES = (
    TargetList,
    BoneList,
    PerformanceList,
    TakeList,
    NoteList,
    LineView3D,
    LineSequencer,
    Scene,
    Performances,
    Output,
    Bones,
)

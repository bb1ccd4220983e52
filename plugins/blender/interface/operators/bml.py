"""Imports BML from any source and plays it on the armature; exports performances with their strips' changes."""

from pathlib import Path
from typing import Any

import bpy
from bpy_extras.io_utils import ExportHelper, ImportHelper

from ...performing.lines import PlayedLine, play_sheet
from ...performing.requests import Sheet
from ...scene.performances import Order, free_name, lay_performance
from ...scene.ranges import take_in
from ...scene.sounds import frame_rate_hz, place_sound, readable
from ...schedule.bml_document import character_of, text_of
from ..jobs import JobOperator, Work
from ..preferences import connection
from ..requests import performer_of, realization
from .strips import changed_bml, chosen_record


class ImportBml(JobOperator, ImportHelper):
    """Play BML on the active armature: BML 1.0 or SmartBody's, from Understudy or elsewhere"""

    bl_idname = "understudy.import_bml"
    bl_label = "Import BML"

    filename_ext = ".bml"
    filter_glob: bpy.props.StringProperty(default="*.bml;*.xml", options={"HIDDEN"})
    audio: bpy.props.StringProperty(
        name="Recording", subtype="FILE_PATH", description="The recording of the speech, if there is one"
    )

    by_hand: bpy.props.BoolProperty(options={"HIDDEN", "SKIP_SAVE"})

    def invoke(self, context: Any, event: Any) -> set[str]:
        """First the file, which Blender's file browser asks for, then the work."""
        if self.properties.is_property_set("filepath"):
            return JobOperator.invoke(self, context, event)
        self.by_hand = True
        return ImportHelper.invoke(self, context, event)

    def execute(self, context: Any) -> set[str]:
        """Called by the file browser, the work goes on in a thread; called by a script, at once."""
        return JobOperator.invoke(self, context, None) if self.by_hand else JobOperator.execute(self, context)

    def gather(self, context: Any) -> Work:
        path, performer = Path(self.filepath), performer_of(context)
        bml = path.read_bytes()
        text_of(bml)
        audio = readable(Path(bpy.path.abspath(self.audio))) if self.audio else None
        options = realization(context.scene, performer, context.scene.understudy.tail_s)
        if character_of(bml):
            options.pop("character")
        name = free_name(path.stem, performer)
        self._order = Order(name, float(context.scene.frame_current), audio, text_of(bml), None, options)
        self._performer, connected = performer, connection(context)
        return lambda progress, cancelled: play_sheet(connected, Sheet(bml, audio, options), progress, cancelled)

    def finish(self, context: Any, result: PlayedLine) -> tuple[str, ...]:
        scene, order = context.scene, self._order
        rate_hz = frame_rate_hz(scene)
        messages = lay_performance(self._performer, result, order, rate_hz)
        if order.audio is not None:
            messages += place_sound(scene, order.audio, round(order.zero_frame), order.name)
        if scene.understudy.set_range:
            take_in(scene, result.clip, order.zero_frame, rate_hz)
        return messages


class ExportBml(bpy.types.Operator, ExportHelper):
    """Export the performance's BML with its strips as they are now"""

    bl_idname = "understudy.export_bml"
    bl_label = "Export BML"

    filename_ext = ".bml"
    filter_glob: bpy.props.StringProperty(default="*.bml;*.xml", options={"HIDDEN"})

    def execute(self, context: Any) -> set[str]:
        try:
            bml = changed_bml(context, performer_of(context), chosen_record(context))
            Path(self.filepath).write_bytes(bml)
        except (ValueError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


CLASSES = (ImportBml, ExportBml)

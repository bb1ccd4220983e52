"""The takes of a performance: another is shown, or one is removed."""

from typing import Any

import bpy

from ...scene.line_notes import keep_notes, notes_now
from ...scene.sounds import frame_rate_hz
from ...scene.takes import remove_take, show_take
from ..requests import performer_of
from .strips import chosen_record


class _TakeOperator(bpy.types.Operator):
    """An operator on one of the takes."""

    bl_options = {"REGISTER", "UNDO"}

    number: bpy.props.IntProperty(name="Take", description="The take's place in the list, from 0")

    def act(self, context: Any, record: Any) -> None:
        raise NotImplementedError

    def execute(self, context: Any) -> set[str]:
        try:
            self.act(context, chosen_record(context))
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class ShowTake(_TakeOperator):
    """Apply this take to the armature; the current take stays in the list"""

    bl_idname = "understudy.show_take"
    bl_label = "Show Take"

    def act(self, context: Any, record: Any) -> None:
        performer = performer_of(context)
        keep_notes(record, notes_now(performer, record, frame_rate_hz(context.scene)))
        show_take(performer, record, self.number)


class RemoveTake(_TakeOperator):
    """Delete this take and its actions"""

    bl_idname = "understudy.remove_take"
    bl_label = "Remove Take"

    def act(self, _context: Any, record: Any) -> None:
        remove_take(record, self.number)


CLASSES = (ShowTake, RemoveTake)

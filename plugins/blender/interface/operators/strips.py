"""What was done to the strips of behaviours is played: the BML with their changes, or the line performed again around
them. Both note what was done, for every take of the line (docs/edits.md)."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import bpy

from ...performing.lines import PlayedLine, perform_line, play_sheet
from ...performing.requests import Line, Remark, Sheet
from ...scene.behavior_strips import changes_of
from ...scene.line_notes import clear_notes, keep_notes, lock_selected, notes_now, notes_of
from ...scene.performances import behaviors_in, bml_of, lay_performance, order_of, trace_of
from ...scene.sounds import frame_rate_hz
from ...scene.takes import next_seed
from ...schedule.bml_document import StripChange, changed
from ...schedule.notes import Note, edits_of, in_words, landed, made_by
from ..jobs import JobOperator, Work
from ..preferences import connection
from ..requests import performer_of

_GONE = "edit_behavior_gone"


class NoPerformanceError(ValueError):
    """The armature does not have the requested performance."""


class PlayStrips(JobOperator):
    """Update the motion to the strips as they are now: moved, resized, muted or deleted"""

    bl_idname = "understudy.play_strips"
    bl_label = "Play Strips"

    def gather(self, context: Any) -> Work:
        self._performer, record = performer_of(context), chosen_record(context)
        rate_hz = frame_rate_hz(context.scene)
        self._order, trace = order_of(record), trace_of(record)
        self._notes = notes_now(self._performer, record, rate_hz)
        self._wanted_s = _wanted_s(self._performer, record, rate_hz)
        sheet = Sheet(changed_bml(context, self._performer, record), self._order.audio, self._order.realization or {})
        connected = connection(context)
        return lambda progress, cancelled: play_sheet(connected, sheet, progress, cancelled, trace=trace)

    def finish(self, context: Any, result: PlayedLine) -> tuple[str, ...]:
        rate_hz = frame_rate_hz(context.scene)
        messages = lay_performance(self._performer, result, self._order, rate_hz)
        keep_notes(_record(self._performer, self._order.name), self._notes)
        played = {each.id: each for each in result.behaviors}
        wanted = ((Note(0, {}, "", time_s), played[name]) for name, time_s in self._wanted_s.items() if name in played)
        return (*messages, *filter(None, (landed(note, behavior, 1.5 / rate_hz) for note, behavior in wanted)))


class PerformAgain(JobOperator):
    """Perform another take of the line: moved, muted and locked strips are kept, the rest is chosen again"""

    bl_idname = "understudy.perform_again"
    bl_label = "Perform Again"

    def gather(self, context: Any) -> Work:
        self._performer, record = performer_of(context), chosen_record(context)
        order = order_of(record)
        if order.audio is None or not trace_of(record):
            raise NoPerformanceError(f"{order.name} was not performed here, but read from BML: play its strips instead")
        self._notes = notes_now(self._performer, record, frame_rate_hz(context.scene))
        options = (order.options or {}) | {"seed": next_seed(record)}
        self._order = replace(order, options=options, notes=tuple(note.number for note in self._notes))
        line = Line(order.audio, order.text, options, edits_of(self._notes))
        connected, realized = connection(context), {"": order.realization or {}}
        return lambda progress, cancelled: perform_line(connected, line, realized, progress, cancelled)

    def finish(self, context: Any, result: dict[str, PlayedLine]) -> tuple[str, ...]:
        rate_hz = frame_rate_hz(context.scene)
        keep_notes(_record(self._performer, self._order.name), self._notes)
        played = replace(result[""], warnings=_of_notes(result[""].warnings, self._notes))
        messages = lay_performance(self._performer, played, self._order, rate_hz, new_take=True)
        made = ((note, made_by(note, played.behaviors, self._order.notes)) for note in self._notes)
        return (*messages, *filter(None, (landed(note, behavior, 1.5 / rate_hz) for note, behavior in made)))


class LockStrips(bpy.types.Operator):
    """Keep the selected strips unchanged in every take of this line"""

    bl_idname = "understudy.lock_strips"
    bl_label = "Lock Selected Strips"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        try:
            record = chosen_record(context)
            locked = lock_selected(performer_of(context), record, frame_rate_hz(context.scene))
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if not locked:
            self.report({"WARNING"}, "select strips of behaviours in the NLA editor first")
        return {"FINISHED"}


class ClearNotes(bpy.types.Operator):
    """Remove a note, or all notes on the line; the next take ignores them"""

    bl_idname = "understudy.clear_notes"
    bl_label = "Clear Notes"
    bl_options = {"REGISTER", "UNDO"}

    number: bpy.props.IntProperty(name="Note", default=-1, description="The note's place in the list; -1: all")

    def execute(self, context: Any) -> set[str]:
        record = chosen_record(context)
        numbers = [note.number for note in notes_of(record)]
        chosen = numbers if self.number < 0 else numbers[self.number : self.number + 1]
        clear_notes(performer_of(context), record, chosen)
        return {"FINISHED"}


def chosen_record(context: Any) -> Any:
    """The performance chosen in the list of the performer's. Raises NoPerformanceError."""
    own = performer_of(context).understudy
    if not own.performances:
        raise NoPerformanceError(f"{performer_of(context).name} has no performance yet: perform a line, or import BML")
    return own.performances[min(max(own.active_performance, 0), len(own.performances) - 1)]


def changed_bml(context: Any, performer: Any, record: Any) -> bytes:
    """A performance's BML with what was done to its strips."""
    changes = _changes(performer, record, frame_rate_hz(context.scene))
    return changed(bml_of(record), changes, {each.id: each.points_s for each in behaviors_in(record)})


def _changes(performer: Any, record: Any, rate_hz: float) -> dict[str, StripChange]:
    return changes_of(performer, record.name, behaviors_in(record), rate_hz)


def _wanted_s(performer: Any, record: Any, rate_hz: float) -> dict[str, float]:
    """When the behaviours whose strips were moved should be fully seen, by their ids."""
    seen_s = {each.id: each.stroke_s for each in behaviors_in(record)}
    moved = (change for change in _changes(performer, record, rate_hz).values() if change.shift_s)
    return {change.behavior: seen_s[change.behavior] + change.shift_s for change in moved}


def _of_notes(warnings: Sequence[Remark], notes: Sequence[Note]) -> tuple[Remark, ...]:
    """The messages about the notes, by the notes' names; none for a muted strip, which is left out on purpose."""
    muted = [f"behaviors[{place}]:" for place, note in enumerate(notes) if "omit" in note.edit]
    kept = (each for each in warnings if each.code != _GONE or not each.message.startswith(tuple(muted)))
    return tuple(Remark(each.code, in_words(each.message, notes)) for each in kept)


def _record(performer: Any, name: str) -> Any:
    return performer.understudy.performances[name]


CLASSES = (PlayStrips, PerformAgain, LockStrips, ClearNotes)

"""What was done to the strips of behaviours is played: the BML with their changes, or the line performed again around
them."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from ...performing.lines import PlayedLine, perform_line, play_sheet
from ...performing.requests import Line, Sheet
from ...scene.behavior_strips import changes_of, strips_of
from ...scene.performances import behaviors_in, bml_of, lay_performance, order_of, trace_of
from ...scene.sounds import frame_rate_hz
from ...schedule.bml_document import changed
from ...schedule.notes import notes
from ..jobs import JobOperator, Work
from ..preferences import connection
from ..requests import performer_of


class NoPerformanceError(ValueError):
    """An armature without the performance that is asked for."""


class PlayStrips(JobOperator):
    """Play the strips as they lie now: moved, longer, muted or deleted"""

    bl_idname = "understudy.play_strips"
    bl_label = "Play Strips"

    def gather(self, context: Any) -> Work:
        self._performer, record = performer_of(context), chosen_record(context)
        self._order, self._trace = order_of(record), trace_of(record)
        sheet = Sheet(changed_bml(context, self._performer, record), self._order.audio, self._order.realization or {})
        connected, trace = connection(context), self._trace
        return lambda progress, cancelled: play_sheet(connected, sheet, progress, cancelled, trace=trace)

    def finish(self, context: Any, result: PlayedLine) -> tuple[str, ...]:
        return lay_performance(self._performer, result, self._order, frame_rate_hz(context.scene))


class PerformAgain(JobOperator):
    """Perform the line again with the next seed: strips that were moved or selected are kept, muted ones avoided"""

    bl_idname = "understudy.perform_again"
    bl_label = "Perform Again"

    def gather(self, context: Any) -> Work:
        self._performer, record = performer_of(context), chosen_record(context)
        order, trace = order_of(record), trace_of(record)
        if order.audio is None or not trace:
            raise NoPerformanceError(f"{order.name} was not performed here, but read from BML: play its strips instead")
        options = (order.options or {}) | {"seed": (order.options or {}).get("seed", 0) + 1}
        self._order = replace(order, options=options)
        line = Line(order.audio, order.text, options, self._direction(context, record, trace))
        connected, realized = connection(context), {"": order.realization or {}}
        return lambda progress, cancelled: perform_line(connected, line, realized, progress, cancelled)

    def finish(self, context: Any, result: dict[str, PlayedLine]) -> tuple[str, ...]:
        return lay_performance(self._performer, result[""], self._order, frame_rate_hz(context.scene))

    def _direction(self, context: Any, record: Any, trace: Mapping[str, Any]) -> dict[str, Any]:
        """The strips as a director's notes."""
        behaviors = {each.id: each for each in behaviors_in(record)}
        changes = changes_of(self._performer, record.name, tuple(behaviors.values()), frame_rate_hz(context.scene))
        moved = {name: change.shift_s for name, change in changes.items() if not change.removed}
        selected = {each.behavior.id: 0.0 for each in strips_of(self._performer, record.name) if each.strip.select}
        kept = [(behaviors[name], shift_s) for name, shift_s in ({**selected, **moved}).items()]
        muted = [behaviors[name] for name, change in changes.items() if change.removed]
        return notes(kept, muted, trace["words"])


def chosen_record(context: Any) -> Any:
    """The performance chosen in the list of the performer's. Raises NoPerformanceError."""
    own = performer_of(context).understudy
    if not own.performances:
        raise NoPerformanceError(f"{performer_of(context).name} has no performance yet: perform a line, or import BML")
    return own.performances[min(max(own.active_performance, 0), len(own.performances) - 1)]


def changed_bml(context: Any, performer: Any, record: Any) -> bytes:
    """A performance's BML with what was done to its strips."""
    behaviors = behaviors_in(record)
    changes = changes_of(performer, record.name, behaviors, frame_rate_hz(context.scene))
    return changed(bml_of(record), changes, {each.id: each.points_s for each in behaviors})


CLASSES = (PlayStrips, PerformAgain)

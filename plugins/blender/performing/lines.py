"""A line from its recording to motion, for who speaks and who listens; and BML to motion."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from ..motion.clip import Clip
from ..schedule.behaviors import Behavior, behaviors_of
from .requests import Cancellation, Connection, Json, Line, Progress, Remark, Sheet


@dataclass(frozen=True, slots=True, eq=False)
class PlayedLine:
    """BML, its motion and behaviours, its record, and the warnings to show."""

    bml: bytes
    clip: Clip
    behaviors: tuple[Behavior, ...]
    trace: Mapping[str, Any] = field(default_factory=dict)
    warnings: tuple[Remark, ...] = ()


def perform_line(
    connection: Connection,
    line: Line,
    realizations: Mapping[str, Json],
    progress: Progress,
    cancelled: Cancellation,
) -> dict[str, PlayedLine]:
    """The speaker by the name "", and each listener by his; `realizations` are the options of those who are to be
    realized. Raises PerformingError and CancelledError."""
    performed = connection.perform(line, progress, cancelled)
    written = {"": performed.bml, **performed.listeners}
    played = {}
    for name, options in realizations.items():
        sheet = Sheet(written[name], line.audio, options)
        trace = {} if name else performed.trace
        warnings = () if name else performed.warnings
        one = play_sheet(connection, sheet, progress, cancelled, trace=trace, warnings=warnings)
        played[name] = _without_notices(one) if name else one
    return played


def _without_notices(played: PlayedLine) -> PlayedLine:
    """A listener's BML has no words on purpose, so that the only warning there could be is left out."""
    return replace(played, clip=replace(played.clip, notices=()))


def play_sheet(
    connection: Connection,
    sheet: Sheet,
    progress: Progress,
    cancelled: Cancellation,
    *,
    trace: Mapping[str, Any] | None = None,
    warnings: tuple[Remark, ...] = (),
) -> PlayedLine:
    """BML with its motion; `trace` is the performance that it was written from, where there is one."""
    clip = connection.realize(sheet, progress, cancelled)
    return PlayedLine(sheet.bml, clip, behaviors_of(sheet.bml, clip, trace), trace or {}, warnings)

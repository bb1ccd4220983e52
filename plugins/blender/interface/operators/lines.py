"""Performs a line, and takes a performance away again."""

from dataclasses import replace
from typing import Any

import bpy

from ...performing.lines import PlayedLine, perform_line
from ...performing.requests import Cancellation, Connection, PerformingError, Progress
from ...scene.performances import Order, forget, lay_performance
from ...scene.ranges import take_in
from ...scene.sounds import frame_rate_hz, place_sound
from ..jobs import JobOperator, Work
from ..preferences import connection
from ..requests import Request, performer_of, request_of, requests_of_strips


class Perform(JobOperator):
    """Perform the line on the armature: body, head, gaze and face on NLA tracks, the sound in the sequencer"""

    bl_idname = "understudy.perform"
    bl_label = "Perform"

    def gather(self, context: Any) -> Work:
        self._request = request = request_of(context)
        connected = connection(context)
        return lambda progress, cancelled: perform_line(
            connected, request.line, request.realizations, progress, cancelled
        )

    def finish(self, context: Any, result: dict[str, PlayedLine]) -> tuple[str, ...]:
        return lay_line(context, self._request, result)


class PerformAll(JobOperator):
    """Perform every sound strip that has words and no performance, on the armature that its 'character' names"""

    bl_idname = "understudy.perform_all"
    bl_label = "Perform All Strips"

    def gather(self, context: Any) -> Work:
        self._requests, self._told = requests_of_strips(context)
        connected, requests = connection(context), tuple(self._requests)
        return lambda progress, cancelled: [
            _performed(connected, request, f"{place} of {len(requests)}, ", progress, cancelled)
            for place, request in enumerate(requests, start=1)
        ]

    def finish(self, context: Any, result: list[dict[str, PlayedLine] | PerformingError]) -> tuple[str, ...]:
        messages = list(self._told)
        for request, played in zip(self._requests, result, strict=True):
            if isinstance(played, PerformingError):
                messages.append(f"{request.order.name} was not performed: {played}")
            else:
                messages += lay_line(context, replace(request, new_sound=False), played)
        return tuple(messages)


class Forget(bpy.types.Operator):
    """Remove the performance: its strips, actions and texts"""

    bl_idname = "understudy.forget"
    bl_label = "Remove Performance"
    bl_options = {"REGISTER", "UNDO"}

    name: bpy.props.StringProperty(name="Performance")

    def execute(self, context: Any) -> set[str]:
        forget(performer_of(context), self.name)
        return {"FINISHED"}


class Cancel(bpy.types.Operator):
    """Cancel the current job"""

    bl_idname = "understudy.cancel"
    bl_label = "Cancel"

    def execute(self, context: Any) -> set[str]:
        context.window_manager.understudy.cancel = True
        return {"FINISHED"}


def _performed(
    connected: Connection, request: Request, place: str, progress: Progress, cancelled: Cancellation
) -> dict[str, PlayedLine] | PerformingError:
    """Performs one of many lines; its failure does not stop the others."""
    try:
        return perform_line(
            connected, request.line, request.realizations, lambda stage: progress(f"{place}{stage}"), cancelled
        )
    except PerformingError as error:
        return error


def lay_line(context: Any, request: Request, played: dict[str, PlayedLine]) -> tuple[str, ...]:
    """Adds a line to the scene: its sound, the speaker's performance and the listener's."""
    scene, order = context.scene, request.order
    rate_hz = frame_rate_hz(scene)
    messages = lay_performance(request.performer, played[""], order, rate_hz)
    for name in (name for name in played if name):
        heard = Order(order.name, order.zero_frame, order.audio, "", None, request.realizations[name])
        messages += lay_performance(request.listener, _seen_by(played[name], request.performer), heard, rate_hz)
    if request.new_sound and order.audio is not None:
        messages += place_sound(scene, order.audio, round(order.zero_frame), order.name)
    if scene.understudy.set_range:
        take_in(scene, played[""].clip, order.zero_frame, rate_hz)
    return messages


def _seen_by(played: PlayedLine, speaker: Any) -> PlayedLine:
    """A listener's line, with the speaker's name in BML replaced by the one in the scene."""
    character = speaker.understudy.character or "default"
    seen = (replace(each, target=speaker.name) if each.target == character else each for each in played.behaviors)
    return replace(played, behaviors=tuple(seen))


CLASSES = (Perform, PerformAll, Forget, Cancel)

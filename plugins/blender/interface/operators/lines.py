"""Performs a line, and takes a performance away again."""

from typing import Any

import bpy

from ...performing.lines import PlayedLine, perform_line
from ...scene.performances import Order, forget, lay_performance
from ...scene.ranges import take_in
from ...scene.sounds import frame_rate_hz, place_sound
from ..jobs import JobOperator, Work
from ..preferences import connection
from ..requests import Request, performer_of, request_of


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


class Forget(bpy.types.Operator):
    """Take the performance away: its strips, actions and texts"""

    bl_idname = "understudy.forget"
    bl_label = "Remove Performance"
    bl_options = {"REGISTER", "UNDO"}

    name: bpy.props.StringProperty(name="Performance")

    def execute(self, context: Any) -> set[str]:
        forget(performer_of(context), self.name)
        return {"FINISHED"}


class Cancel(bpy.types.Operator):
    """End what is under way"""

    bl_idname = "understudy.cancel"
    bl_label = "Cancel"

    def execute(self, context: Any) -> set[str]:
        context.window_manager.understudy.cancel = True
        return {"FINISHED"}


def lay_line(context: Any, request: Request, played: dict[str, PlayedLine]) -> tuple[str, ...]:
    """Lays a line for its speaker and its listener, and what belongs to it in the scene."""
    scene, order = context.scene, request.order
    rate_hz = frame_rate_hz(scene)
    told = lay_performance(request.performer, played[""], order, rate_hz)
    for name in (name for name in played if name):
        heard = Order(order.name, order.zero_frame, order.audio, "", None, request.realizations[name])
        told += lay_performance(request.listener, played[name], heard, rate_hz)
    if request.new_sound and order.audio is not None:
        told += place_sound(scene, order.audio, round(order.zero_frame), order.name)
    if scene.understudy.set_range:
        take_in(scene, played[""].clip, order.zero_frame, rate_hz)
    return told


CLASSES = (Perform, Forget, Cancel)

"""Long work of operators: in a thread while Blender stays usable, with its progress shown, ended by Esc.

An operator that is run by a script (`execute`) works at once and waits. The thread does not touch Blender's data: its
input is gathered before, and its result is added to the scene afterwards, as one undo step."""

import threading
from collections.abc import Callable
from typing import Any

import bpy

from ..performing.requests import Cancellation, CancelledError, PerformingError, Progress

Work = Callable[[Progress, Cancellation], Any]
_STAGES = 14
"""About so many stages has a line; the last of them is shown as long as it takes."""
_INTERVAL_S = 0.1


class Job:
    """Work in a thread: its stage, and in the end its result or what went wrong."""

    def __init__(self, work: Work) -> None:
        self.stage, self.stages = "", 0
        self.result: Any = None
        self.error: Exception | None = None
        self._cancelled = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(work,), daemon=True)

    def start(self) -> None:
        self._thread.start()

    def cancel(self) -> None:
        self._cancelled.set()

    @property
    def running(self) -> bool:
        return self._thread.is_alive()

    @property
    def done(self) -> float:
        """How far it is, from 0 to 1."""
        return min(self.stages / _STAGES, 1.0)

    def _run(self, work: Work) -> None:
        try:
            self.result = work(self._begin, self._cancelled.is_set)
        except Exception as error:  # noqa: BLE001 -- raised again in the main thread, which reports it
            self.error = error

    def _begin(self, stage: str) -> None:
        self.stage, self.stages = stage, self.stages + 1


class JobOperator(bpy.types.Operator):
    """An operator with long work: `gather` makes it from the scene, `finish` adds its result; both and the work
    raise ValueError, OSError or PerformingError for what the person can fix, which the info bar shows."""

    bl_options = {"REGISTER", "UNDO"}

    def gather(self, context: Any) -> Work:
        """The work; whatever it needs of the scene is read now."""
        raise NotImplementedError

    def finish(self, context: Any, result: Any) -> tuple[str, ...]:
        """Adds the result to the scene; returns the warnings to show."""
        raise NotImplementedError

    def execute(self, context: Any) -> set[str]:
        """Works at once."""
        try:
            result = self.gather(context)(lambda _stage: None, lambda: False)
            return self._finished(context, result)
        except (PerformingError, ValueError, OSError) as error:
            return self._failed(error)

    def invoke(self, context: Any, _event: Any) -> set[str]:
        """Works in a thread, unless Blender runs without windows, and so without events that would end the work."""
        state = context.window_manager.understudy
        if state.running:
            self.report({"ERROR"}, "Understudy is at work already: wait for it, or cancel it")
            return {"CANCELLED"}
        if bpy.app.background or context.window is None:
            return JobOperator.execute(self, context)
        try:
            self._job = Job(self.gather(context))
        except (PerformingError, ValueError, OSError) as error:
            return self._failed(error)
        self._job.start()
        state.running, state.cancel, state.stage, state.done = True, False, "", 0.0
        self._timer = context.window_manager.event_timer_add(_INTERVAL_S, window=context.window)
        context.window_manager.progress_begin(0, 1)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> set[str]:
        state = context.window_manager.understudy
        if event.type == "ESC" or state.cancel:
            self._job.cancel()
            self._end(context)
            self.report({"INFO"}, "Cancelled")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if self._job.running:
            self._show(context)
            return {"RUNNING_MODAL"}
        self._end(context)
        if self._job.error is not None:
            return self._failed(self._job.error)
        try:
            return self._finished(context, self._job.result)
        except (PerformingError, ValueError, OSError) as error:
            return self._failed(error)

    def _show(self, context: Any) -> None:
        state = context.window_manager.understudy
        state.stage, state.done = self._job.stage, self._job.done
        context.window_manager.progress_update(self._job.done)
        context.workspace.status_text_set(f"Understudy: {self._job.stage} (Esc cancels)")
        _redraw(context)

    def _end(self, context: Any) -> None:
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)
        context.window_manager.understudy.running = False
        _redraw(context)

    def _finished(self, context: Any, result: Any) -> set[str]:
        for told in self.finish(context, result):
            self.report({"WARNING"}, told)
        return {"FINISHED"}

    def _failed(self, error: Exception) -> set[str]:
        if isinstance(error, CancelledError):
            return {"CANCELLED"}
        if not isinstance(error, (PerformingError, ValueError, OSError)):
            raise error
        self.report({"ERROR"}, str(error))
        return {"CANCELLED"}


def _redraw(context: Any) -> None:
    """Has the panels show how far the work is, without waiting for the mouse."""
    for area in context.screen.areas:
        area.tag_redraw()

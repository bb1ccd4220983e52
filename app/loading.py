"""How models are loaded: on first use, without looking for garbage, and networks with ONNX Runtime, which is imported
with the first of them."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import copy_context
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

from .errors import ServiceError

if TYPE_CHECKING:
    from numpy.typing import NDArray

Value = TypeVar("Value")

_ONLY_ERRORS = 3
"""The log severity of ONNX Runtime: errors, but no warnings about the machine."""


@contextmanager
def uncollected() -> Iterator[None]:
    """Within the block, Python does not look for garbage among what is loaded, which all stays: a twelfth of the time
    of a short line."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


class OnDemand(Generic[Value]):
    """A value made on first use, once, whichever threads ask for it, in the context (contextvars) in which this was
    created. If making it raises, the next call tries again."""

    __slots__ = ("_context", "_lock", "_made", "_make")

    def __init__(self, make: Callable[[], Value]) -> None:
        self._make = make
        self._context = copy_context()
        self._made: tuple[Value] | None = None
        self._lock = Lock()

    @classmethod
    def ready(cls, value: Value) -> OnDemand[Value]:
        """A value that is made already."""
        found = cls(lambda: value)
        found._made = (value,)
        return found

    def get(self) -> Value:
        """The value; raises what making it raises."""
        with self._lock:
            if self._made is None:
                self._made = (self._context.run(self._make),)
            return self._made[0]

    def made(self) -> Value | None:
        """The value if it has been made, else None."""
        return self._made[0] if self._made else None


class OnnxSession(Protocol):
    """The part of ONNX Runtime's `InferenceSession` that we use; the library has no types."""

    def run(self, output_names: Sequence[str], input_feed: Mapping[str, NDArray[Any]]) -> Sequence[NDArray[Any]]: ...

    def get_modelmeta(self) -> Any: ...  # noqa: ANN401

    def get_inputs(self) -> Sequence[Any]: ...

    def get_outputs(self) -> Sequence[Any]: ...


def load_session(path: Path, kind: str) -> OnnxSession:
    """The network in a file. Raises ServiceError `model_unreadable` where the file is missing or is not such a `kind`,
    such as "a model of affect"."""
    import onnxruntime
    from onnxruntime.capi import onnxruntime_pybind11_state as state

    unusable = (
        OSError,
        state.Fail,
        state.InvalidArgument,
        state.InvalidGraph,
        state.InvalidProtobuf,
        state.NoSuchFile,
        state.NotImplemented,
    )
    options = onnxruntime.SessionOptions()
    # A line is too short to be shared among processors, and threads of its own would not survive a fork.
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    options.log_severity_level = _ONLY_ERRORS
    options.enable_cpu_mem_arena = False  # it would keep a third more than the network needs
    try:
        # By its name, since a session keeps the bytes that it is given.
        session: OnnxSession = onnxruntime.InferenceSession(path, options, providers=["CPUExecutionProvider"])
    except unusable as error:
        raise ServiceError("model_unreadable", f"{path} is not {kind}: {error}") from error
    return session

"""Loads networks that ONNX Runtime runs. The library is imported with the first of them."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

from numpy.typing import NDArray

from .errors import ServiceError

_ONLY_ERRORS = 3
"""The log severity of ONNX Runtime: errors, but no warnings about the machine."""


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
        state.NotImplemented,
    )
    options = onnxruntime.SessionOptions()
    # A line is too short to be shared among processors, and threads of its own would not survive a fork.
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    options.log_severity_level = _ONLY_ERRORS
    try:
        session: OnnxSession = onnxruntime.InferenceSession(
            path.read_bytes(), options, providers=["CPUExecutionProvider"]
        )
    except unusable as error:
        raise ServiceError("model_unreadable", f"{path} is not {kind}: {error}") from error
    return session

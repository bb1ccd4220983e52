"""Trained arrays on disk: `NAME.npz` (no pickles), with `NAME.npz.sha256` beside it, in the format of `sha256sum`."""

import hashlib
import io
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...errors import ServiceError

Model = TypeVar("Model")


def read_arrays(path: Path, kind: str, made: Callable[[Mapping[str, NDArray[Any]]], Model]) -> Model:
    """What is `made` of the arrays in the file, after its checksum is verified.

    Raises ServiceError: `model_unreadable` if a file is missing or is no such `kind`, `model_damaged` if the checksum
    differs.
    """
    checksum = _checksum(path)
    try:
        content = path.read_bytes()
        expected = checksum.read_text(encoding="ascii").partition(" ")[0]
    except (OSError, UnicodeDecodeError) as error:
        raise _unreadable(path, kind, error) from None
    if hashlib.sha256(content).hexdigest() != expected:
        raise ServiceError("model_damaged", f"{path} differs from its checksum in {checksum.name}; reinstall it")
    try:
        with np.load(io.BytesIO(content), allow_pickle=False) as arrays:
            return made(arrays)
    except (EOFError, KeyError, ValueError, TypeError, zipfile.BadZipFile) as error:
        raise _unreadable(path, kind, error) from None


def write_arrays(path: Path, arrays: Mapping[str, NDArray[Any]]) -> None:
    """Writes the arrays and their checksum for `read_arrays`."""
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **arrays)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(buffer.getvalue())
    digest = hashlib.sha256(buffer.getvalue()).hexdigest()
    _checksum(path).write_text(f"{digest}  {path.name}\n", encoding="ascii")


def _checksum(path: Path) -> Path:
    return path.with_name(path.name + ".sha256")


def _unreadable(path: Path, kind: str, error: Exception) -> ServiceError:
    return ServiceError("model_unreadable", f"{path} is not a {kind} ({error}); reinstall understudy")

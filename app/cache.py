"""What takes long to make and follows from files alone, kept from one process to the next: compiled rules, filters.

A thing is kept in one file under its name, in a folder of the user's own: `UNDERSTUDY_CACHE`, or where the platform
keeps caches. The file begins with a key over the content of all files that the thing was made from, the code that
made it and the versions of what it was made with; where the key is another, the thing is made again and the file
replaced. So files may be deleted at any time, and there are never more of them than names. A process writes to a name
of its own and renames it, so that another reads the old file or the new.

Files are pickles, and to read one is to run what it says. One is read only if it and its folder belong to the user and
nobody else may write there, and it may name no class but our own and a few of Python's and numpy's. Where that cannot
be had (a folder that others can write to, a read-only file system, a platform without owners of files) nothing is kept,
which only takes longer; why is logged at debug level.
"""

from __future__ import annotations

import io
import logging
import os
import pickle
import stat
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, fields, is_dataclass
from hashlib import blake2b
from pathlib import Path
from types import MappingProxyType
from typing import Any, Self, TypeVar

from .version import __version__

Value = TypeVar("Value")

VARIABLE = "UNDERSTUDY_CACHE"
OFF = "off"
_PACKAGE = Path(__file__).resolve().parent
_CODE_SUFFIXES = (".py", ".lark")
_KEY_BYTES = 32
_OTHERS_MAY_WRITE = stat.S_IWGRP | stat.S_IWOTH
_FOREIGN_CLASSES = frozenset(
    {
        ("builtins", "frozenset"),
        ("builtins", "set"),
        ("functools", "partial"),
        ("numpy", "dtype"),
        ("numpy", "ndarray"),
        ("numpy._core.multiarray", "_reconstruct"),
        ("numpy._core.numeric", "_frombuffer"),
        ("operator", "itemgetter"),
        ("pathlib", "PosixPath"),
    }
)
"""What a kept thing may be made of beside our own classes, by module and name."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Cache:
    """A folder of kept things; `folder` is None where nothing is kept."""

    folder: Path | None

    @classmethod
    def of_environment(cls) -> Self:
        """The folder that `UNDERSTUDY_CACHE` names, none where it says "off", the platform's where it says nothing."""
        told = os.environ.get(VARIABLE, "")
        if told.lower() == OFF or not hasattr(os, "geteuid"):
            return cls(None)
        return cls(Path(told) if told else _usual_folder())

    def kept(self, name: str, files: Iterable[Path], make: Callable[[], Value], *, made_with: str = "") -> Value:
        """What `make` makes of the content of `files`: what was kept under `name`, if all is as it was, else made now.

        The `files` are those that `make` reads; one that cannot be read counts as such, and `make` tells of it.
        `made_with` is whatever else the result follows from, as text. Raises what `make` raises.
        """
        if self.folder is None:
            return make()
        key = _key(name, files, made_with)
        payload = self._read(name, key)
        if payload is None:
            made = make()
            self._write(name, key, _pickled(made))
            return made
        kept: Value = _Unpickler(io.BytesIO(payload)).load()
        return kept

    def _path(self, name: str) -> str:
        """One file for each place where the package is installed, lest two versions replace each other's."""
        return f"{name}-{blake2b(os.fsencode(_PACKAGE), digest_size=6).hexdigest()}.{sys.implementation.cache_tag}"

    def _read(self, name: str, key: bytes) -> bytes | None:
        """The kept pickle; None when there is none that is whole, made of the same, and only ours to write."""
        try:
            with _own_folder(self.folder) as folder:
                number = os.open(self._path(name), os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC, dir_fd=folder)
                with open(number, "rb") as file:
                    _require_own(os.fstat(number))
                    head, payload = file.read(2 * _KEY_BYTES), file.read()
        except OSError as error:
            _log.debug("%s is not read from the cache: %s", name, error)
            return None
        return payload if head == key + _digest(payload) else None

    def _write(self, name: str, key: bytes, payload: bytes) -> None:
        try:
            with _own_folder(self.folder, make=True) as folder:
                _replace(folder, self._path(name), key + _digest(payload) + payload)
        except OSError as error:
            _log.debug("%s is not kept in the cache: %s", name, error)


def _usual_folder() -> Path:
    from platformdirs import user_cache_path

    return user_cache_path("understudy", appauthor=False)


@contextmanager
def _own_folder(path: Path | None, *, make: bool = False) -> Iterator[int]:
    """The folder as a file descriptor, so that it stays the one that was looked at; raises OSError."""
    if path is None:
        raise FileNotFoundError("there is no cache")
    if make:
        path.mkdir(mode=0o700, parents=True, exist_ok=True)
    folder = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        _require_own(os.fstat(folder))
        yield folder
    finally:
        os.close(folder)


def _require_own(status: os.stat_result) -> None:
    """Raises PermissionError for what is another user's, or where another can write."""
    if status.st_uid != os.geteuid() or status.st_mode & _OTHERS_MAY_WRITE:
        raise PermissionError("it is another user's, or others may write to it")


def _replace(folder: int, name: str, content: bytes) -> None:
    beside = f".{name}.{os.getpid()}.{os.urandom(4).hex()}"
    number = os.open(beside, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600, dir_fd=folder)
    try:
        with open(number, "wb") as file:
            file.write(content)
        os.replace(beside, name, src_dir_fd=folder, dst_dir_fd=folder)
    except OSError:
        os.unlink(beside, dir_fd=folder)
        raise


def _key(name: str, files: Iterable[Path], made_with: str) -> bytes:
    """Over all that the thing follows from: the files' names and content, the code, and what it ran on."""
    key = blake2b(digest_size=_KEY_BYTES)
    for part in (name, __version__, sys.version, made_with, *_code()):
        key.update(part.encode() + b"\0")
    for path in files:
        try:
            content = path.read_bytes()
        except OSError as error:
            content = str(error).encode()
        key.update(os.fsencode(path) + b"\0" + _digest(content))
    return key.digest()


def _code() -> Iterator[str]:
    """Every file of the package's code, with its size and when it was written, which is what Python goes by as well."""
    folders = [str(_PACKAGE)]
    found = []
    while folders:
        with os.scandir(folders.pop()) as entries:
            for entry in entries:
                if entry.name.endswith(_CODE_SUFFIXES):
                    status = entry.stat()
                    found.append(f"{entry.path} {status.st_size} {status.st_mtime_ns}")
                elif entry.name != "__pycache__" and entry.is_dir():
                    folders.append(entry.path)
    return iter(sorted(found))


def _digest(content: bytes) -> bytes:
    return blake2b(content, digest_size=_KEY_BYTES).digest()


def _pickled(value: object) -> bytes:
    stream = io.BytesIO()
    _Pickler(stream, pickle.HIGHEST_PROTOCOL).dump(value)
    return stream.getvalue()


def _read_only(content: dict[object, object]) -> MappingProxyType[object, object]:
    return MappingProxyType(content)


def _as_read_only(content: Any) -> tuple[Callable[..., object], tuple[object, ...]]:  # noqa: ANN401  # what pickle asks for
    return _read_only, (dict(content),)


def _is_frozen(kind: Any) -> bool:  # noqa: ANN401  # typeshed does not know the attribute
    return bool(kind.__dataclass_params__.frozen)


class _Pickler(pickle.Pickler):
    """Pickles read-only mappings too, and frozen dataclasses as the call that makes them of all their fields in order:
    that is read three times as fast as what dataclasses do by themselves."""

    dispatch_table = MappingProxyType({MappingProxyType: _as_read_only})

    def reducer_override(self, value: object) -> Any:  # noqa: ANN401  # what pickle asks for
        if not is_dataclass(value) or isinstance(value, type) or not _is_frozen(type(value)):
            return NotImplemented
        return type(value), tuple(getattr(value, part.name) for part in fields(value))


class _Unpickler(pickle.Unpickler):
    """Finds no class but our own and those that they are made of."""

    def find_class(self, module: str, name: str) -> object:
        if (module, name) in _FOREIGN_CLASSES:
            return super().find_class(module, name)
        if module.split(".", maxsplit=1)[0] == __package__ and "." not in name:
            found = super().find_class(module, name)
            if found.__module__ == module:  # not what the module itself imported
                return found
        raise pickle.UnpicklingError(f"{module}.{name} is nothing that is kept")

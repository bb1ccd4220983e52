"""Caches on disk what is slow to compute and depends on files alone (compiled rules, filters), across processes.

Each value is a file in a folder of the user's own: `UNDERSTUDY_CACHE`, or the platform's cache folder. The file begins
with a hash of the content of all source files, the code that computed the value and the versions used, and is called by
the value's name and some of that hash; where there is none of that hash, the value is computed again. Of each name the
last `GENERATIONS` that were used are kept: those of the bundled files and of an author's own do not take each other's
place. So files may be deleted at any time, and there are never many. A process writes to a temporary name and renames,
so that readers see a complete file, old or new.

Files are pickles, and unpickling can run code. A file is read only if it and its folder belong to the user and nobody
else can write to them, and it may name only our own classes and a few of Python's and numpy's. Where that is not
possible (a folder that others can write to, a read-only file system, a platform without file owners) nothing is cached,
which only costs time; the reason is logged at debug level.
"""

from __future__ import annotations

import io
import logging
import os
import pickle
import stat
import sys
import time
from collections.abc import Callable, Hashable, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, fields, is_dataclass
from functools import cache
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
GENERATIONS = 3
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
"""The classes other than our own that a cached value may contain, by module and name."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Cache:
    """A folder of cached values; with `folder` None nothing is cached."""

    folder: Path | None

    @classmethod
    def of_environment(cls) -> Self:
        """The folder that `UNDERSTUDY_CACHE` names, none if it is "off", the platform's cache folder if it is unset."""
        value = os.environ.get(VARIABLE, "")
        if value.lower() == OFF or not hasattr(os, "geteuid"):
            return cls(None)
        return cls(Path(value) if value else _usual_folder())

    def kept(self, name: str, files: Iterable[Path], make: Callable[[], Value], *, made_with: str = "") -> Value:
        """The value that `make` computes from the content of `files`: from the cache if nothing has changed, else
        computed now.

        `files` are those that `make` reads; one that cannot be read counts as changed content, and `make` reports it.
        `made_with` is anything else that the result depends on, as text. Raises what `make` raises.
        """
        if self.folder is None:
            return make()
        key = _key(name, files, made_with)
        payload = self._read(name, key)
        if payload is not None:
            try:
                kept: Value = _unpickled(payload)
            except (AttributeError, ImportError, TypeError) as error:
                # A process that ran while its code was replaced wrote its old classes under the new code's key.
                _log.debug("%s was cached by other code than this: %s", name, error)
            else:
                return kept
        made = make()
        self._write(name, key, _pickled(made))
        return made

    def _read(self, name: str, key: bytes) -> bytes | None:
        """The cached pickle; None if there is none that is complete, has the same key, and can be written by the user
        alone."""
        try:
            with _own_folder(self.folder) as folder:
                number = os.open(_file_name(name, key), os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC, dir_fd=folder)
                with open(number, "rb") as file:
                    _require_own(os.fstat(number))
                    _note_use(number)
                    head, payload = file.read(2 * _KEY_BYTES), file.read()
        except OSError as error:
            _log.debug("%s is not read from the cache: %s", name, error)
            return None
        return payload if head == key + _digest(payload) else None

    def _write(self, name: str, key: bytes, payload: bytes) -> None:
        try:
            with _own_folder(self.folder, make=True) as folder:
                _replace(folder, _file_name(name, key), key + _digest(payload) + payload)
                _discard_old(folder, _beginning(name))
        except OSError as error:
            _log.debug("%s is not kept in the cache: %s", name, error)


def _file_name(name: str, key: bytes) -> str:
    return f"{_beginning(name)}-{key.hex()[:12]}.{sys.implementation.cache_tag}"


def _beginning(name: str) -> str:
    """It differs for each place of installation, so that two versions do not discard each other's files."""
    return f"{name}-{blake2b(os.fsencode(_PACKAGE), digest_size=6).hexdigest()}"


def _note_use(file: int) -> None:
    """Dates a file, more exactly than its file system would; where nothing can be written, nothing is discarded either,
    and the date does not matter."""
    now_ns = time.time_ns()
    with suppress(OSError):
        os.utime(file, ns=(now_ns, now_ns))


def _discard_old(folder: int, beginning: str) -> None:
    """Deletes the files with this beginning that were not used for longest."""
    used_ns: dict[str, int] = {}
    for name in os.listdir(folder):
        if name.startswith(beginning):
            with suppress(FileNotFoundError):  # another process deletes it, too
                used_ns[name] = os.stat(name, dir_fd=folder, follow_symlinks=False).st_mtime_ns
    for name in sorted(used_ns, key=used_ns.__getitem__)[:-GENERATIONS]:
        with suppress(FileNotFoundError):
            os.unlink(name, dir_fd=folder)


def _usual_folder() -> Path:
    from platformdirs import user_cache_path

    return user_cache_path("understudy", appauthor=False)


@contextmanager
def _own_folder(path: Path | None, *, make: bool = False) -> Iterator[int]:
    """The folder as a file descriptor, so that the folder checked is the one used; raises OSError."""
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
    """Raises PermissionError for what belongs to another user or can be written by one."""
    if status.st_uid != os.geteuid() or status.st_mode & _OTHERS_MAY_WRITE:
        raise PermissionError("it is another user's, or others may write to it")


def _replace(folder: int, name: str, content: bytes) -> None:
    beside = f".{name}.{os.getpid()}.{os.urandom(4).hex()}"
    number = os.open(beside, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600, dir_fd=folder)
    try:
        with open(number, "wb") as file:
            file.write(content)
            file.flush()
            _note_use(number)
        os.replace(beside, name, src_dir_fd=folder, dst_dir_fd=folder)
    except OSError:
        os.unlink(beside, dir_fd=folder)
        raise


def _key(name: str, files: Iterable[Path], made_with: str) -> bytes:
    """A hash of all that the value depends on: the files' names and content, the code, and the version of Python."""
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


@cache
def _code() -> tuple[str, ...]:
    """Every file of the package's code with its size and modification time, by which Python too decides what is out of
    date, as this process first saw them."""
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
    return tuple(sorted(found))


def _digest(content: bytes) -> bytes:
    return blake2b(content, digest_size=_KEY_BYTES).digest()


def _pickled(value: object) -> bytes:
    stream = io.BytesIO()
    _Pickler(stream, pickle.HIGHEST_PROTOCOL).dump(value)
    return stream.getvalue()


def _unpickled(payload: bytes) -> Any:  # noqa: ANN401  # what was pickled
    return _Unpickler(io.BytesIO(payload)).load()


def _read_only(content: dict[object, object]) -> MappingProxyType[object, object]:
    return MappingProxyType(content)


def _as_read_only(content: Any) -> tuple[Callable[..., object], tuple[object, ...]]:  # noqa: ANN401  # what pickle asks for
    return _read_only, (dict(content),)


@cache
def _names_if_frozen(kind: Hashable) -> tuple[str, ...] | None:
    """The fields of a frozen dataclass; None of any other class."""
    if not isinstance(kind, type) or not is_dataclass(kind) or not _is_frozen(kind):
        return None
    return tuple(part.name for part in fields(kind))


def _is_frozen(kind: Any) -> bool:  # noqa: ANN401  # typeshed does not know the attribute
    return bool(kind.__dataclass_params__.frozen)


class _Pickler(pickle.Pickler):
    """Pickles read-only mappings too, and frozen dataclasses as the constructor call with all their fields in order,
    which is read three times as fast as the dataclasses' own pickles."""

    dispatch_table = MappingProxyType({MappingProxyType: _as_read_only})

    def reducer_override(self, value: object) -> Any:  # noqa: ANN401  # what pickle asks for
        kind: Any = type(value)
        names = _names_if_frozen(kind)
        if names is None:
            return NotImplemented
        return kind, tuple([getattr(value, name) for name in names])


class _Unpickler(pickle.Unpickler):
    """Loads only our own classes and `_FOREIGN_CLASSES`."""

    def find_class(self, module: str, name: str) -> object:
        if (module, name) in _FOREIGN_CLASSES:
            return super().find_class(module, name)
        if module.split(".", maxsplit=1)[0] == __package__ and "." not in name:
            found = super().find_class(module, name)
            if found.__module__ == module:  # not what the module itself imported
                return found
        raise pickle.UnpicklingError(f"{module}.{name} may not be in a cached value")

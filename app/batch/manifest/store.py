"""The manifest's file: SQLite in WAL mode, so that a killed process leaves it consistent. Used by one command at a
time.

Files may come from elsewhere with the folder that they are in: what a row says is checked, and files that it names must
lie in the output folder, because files of former versions are removed.
"""

import errno
import os
import sqlite3
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path, PurePath
from typing import Self

from ...errors import InputError, shown
from ..work.files import unwritable
from .entries import COLUMNS, ManifestEntry, of_row, to_row
from .hashes import KnownRecording

FILE = "manifest.sqlite"
VERSION = 1
"""The version of the file's tables, its `user_version`; older files have 0, and the same tables."""

_LOCK = ".lock"

_PRIMARY = 0xFF
"""The part of SQLite's extended error codes that says what kind of error it is."""

_IN_USE = frozenset({sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED})
_NOT_WRITABLE = frozenset(
    {sqlite3.SQLITE_READONLY, sqlite3.SQLITE_IOERR, sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_PERM, sqlite3.SQLITE_AUTH}
)

_SCHEMA = Path(__file__).with_name("schema.sql")
_WRITE = f"INSERT OR REPLACE INTO lines ({', '.join(COLUMNS)}) VALUES ({', '.join('?' * len(COLUMNS))})"
_SELECT = f"SELECT {', '.join(COLUMNS)} FROM lines ORDER BY place"


class Manifest:
    """The rows of a batch. Every change is saved at once. Use it in a `with` block, or `close` it."""

    def __init__(self, folder: Path) -> None:
        """Opens or creates the manifest in `folder`. Raises InputError `out_in_use` while another command has it open,
        `manifest_unreadable`, `manifest_newer`, `file_unwritable` and `disk_full`, as every method does."""
        self._folder = folder
        self._lock = _locked(folder)
        try:
            with _translated_errors(folder):
                self._connection = sqlite3.connect(folder / FILE, isolation_level=None)
                _require_readable_version(self._connection, folder)
                _require_tables_alone(self._connection)
                self._connection.execute("PRAGMA journal_mode = WAL")
                self._connection.execute("PRAGMA synchronous = NORMAL")
                self._connection.executescript(_SCHEMA.read_text(encoding="utf-8"))
                self._connection.execute(f"PRAGMA user_version = {VERSION}")
                self._connection.execute(f"{_SELECT} LIMIT 1").fetchall()
        except InputError:
            self._lock.close()
            raise

    def entries(self) -> dict[str, ManifestEntry]:
        """All rows by id, in the script's order."""
        with _translated_errors(self._folder):
            rows = self._connection.execute(_SELECT).fetchall()
        folders: dict[PurePath, bool] = {}
        return {row[0]: _checked(row, self._folder, folders) for row in rows}

    def put(self, entries: Iterable[ManifestEntry]) -> None:
        """Writes rows in one transaction, replacing those with the same ids."""
        with self._written():
            self._connection.executemany(_WRITE, map(to_row, entries))

    def remove(self, ids: Iterable[str]) -> None:
        """Removes rows in one transaction."""
        with self._written():
            self._connection.executemany("DELETE FROM lines WHERE id = ?", ((name,) for name in ids))

    def known_recordings(self) -> dict[str, KnownRecording]:
        """The hashes of recordings, by path."""
        with _translated_errors(self._folder):
            rows = self._connection.execute("SELECT path, size, modified_ns, hash FROM recordings").fetchall()
            return dict(map(_recording, rows))

    def know_recordings(self, known: Iterable[tuple[str, KnownRecording]]) -> None:
        """Saves the hashes of recordings."""
        rows = ((path, each.size, each.modified_ns, each.hash) for path, each in known)
        with self._written():
            self._connection.executemany("INSERT OR REPLACE INTO recordings VALUES (?, ?, ?, ?)", rows)

    @contextmanager
    def _written(self) -> Iterator[None]:
        """A transaction, which is undone where it fails."""
        with _translated_errors(self._folder), self._connection:
            self._connection.execute("BEGIN")
            yield

    def close(self) -> None:
        """Closes the file and merges SQLite's journal into it."""
        with suppress(sqlite3.Error):
            self._connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        self._connection.close()
        self._lock.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()


def _locked(folder: Path) -> sqlite3.Connection:
    """A lock on the folder that ends with this process, however it ends. It is SQLite's own lock, which works on every
    platform, on a file beside the manifest, so that others may read the manifest meanwhile."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unwritable(error, folder) from None
    try:
        lock = sqlite3.connect(folder / _LOCK, isolation_level=None, timeout=0)
        lock.execute("BEGIN EXCLUSIVE")
    except sqlite3.OperationalError as error:
        raise _input_error(error, folder) from None
    return lock


@contextmanager
def _translated_errors(folder: Path) -> Iterator[None]:
    """Translates SQLite's errors: a full disk, for instance, is not a broken manifest."""
    try:
        yield
    except (sqlite3.Error, TypeError, ValueError) as error:
        raise _input_error(error, folder) from None


def _input_error(error: Exception, folder: Path) -> InputError:
    code = getattr(error, "sqlite_errorcode", None)
    primary = None if code is None else code & _PRIMARY
    if primary == sqlite3.SQLITE_FULL:
        return unwritable(OSError(errno.ENOSPC, str(error)), folder)
    if primary in _IN_USE:
        message = f"{folder}: another understudy batch is writing there; wait for it, or give another --out"
        return InputError("out_in_use", message, field="out")
    if primary in _NOT_WRITABLE:
        message = f"{folder}: cannot be written to: {error}; fix that and run the same command again: nothing is lost"
        return InputError("file_unwritable", message, field="out")
    return _unreadable(folder, str(error))


def _unreadable(folder: Path, why: str) -> InputError:
    message = f"{folder / FILE}: not a manifest of this version ({why}); remove it to perform everything again"
    return InputError("manifest_unreadable", message, field="out")


def _require_readable_version(connection: sqlite3.Connection, folder: Path) -> None:
    """Raises InputError `manifest_newer`."""
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    if version > VERSION:
        connection.close()
        message = f"{folder / FILE}: written by a later version of understudy; use that one, or give another --out"
        raise InputError("manifest_newer", message, field="out")


def _require_tables_alone(connection: sqlite3.Connection) -> None:
    """Raises ValueError for what runs when it is read or written, perhaps for ever."""
    found = connection.execute("SELECT type, name FROM sqlite_master WHERE type IN ('view', 'trigger')").fetchone()
    if found:
        kind, name = found
        raise ValueError(f"it has a {kind}, {shown(name)}")


def _checked(row: tuple[object, ...], folder: Path, folders: dict[PurePath, bool]) -> ManifestEntry:
    """The entry of a row. `folders` keeps of each folder whether it is in the output folder. Raises InputError
    `manifest_unreadable` for a row that is not ours."""
    try:
        entry = of_row(row)
    except ValueError as error:
        raise _unreadable(folder, f"line {row[0]!r}: {str(error).splitlines()[0]}") from None
    for file in entry.outputs:
        path = PurePath(file.path)
        if path.parent not in folders:
            folders[path.parent] = _lies_inside(folder, path.parent)
        if path.name in {"", ".."} or "\0" in path.name or not folders[path.parent]:
            raise _unreadable(folder, f"line {shown(entry.id)} names {shown(file.path)}, which is not in the folder")
        if path.name == _LOCK or path.name.startswith(FILE):
            raise _unreadable(folder, f"line {shown(entry.id)} names {shown(file.path)}, which is not an output")
    return entry


def _recording(row: tuple[object, ...]) -> tuple[str, KnownRecording]:
    """The path and hash of a recording. Raises ValueError for a row that is not ours."""
    match row:
        case (str(path), int(size), int(modified_ns), str(digest)):
            return path, KnownRecording(size, modified_ns, digest)
    raise ValueError(f"recording {row[0]!r}")


def _lies_inside(folder: Path, parent: PurePath) -> bool:
    """Whether a folder, links followed, is the output folder or in it."""
    try:
        whole = Path(os.path.realpath(folder / parent))
    except ValueError:
        return False
    return whole.is_relative_to(os.path.realpath(folder))

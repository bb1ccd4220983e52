"""The manifest's file: SQLite in WAL mode, so that a killed process leaves it consistent. Used by one command at a
time."""

import sqlite3
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import Self

from ...errors import InputError
from .entries import COLUMNS, Entry, of_row, to_row
from .hashes import KnownRecording

FILE = "manifest.sqlite"
_LOCK = ".lock"
_SCHEMA = Path(__file__).with_name("schema.sql")
_WRITE = f"INSERT OR REPLACE INTO lines ({', '.join(COLUMNS)}) VALUES ({', '.join('?' * len(COLUMNS))})"
_SELECT = f"SELECT {', '.join(COLUMNS)} FROM lines ORDER BY place"


class Manifest:
    """The rows of a batch. Every change is saved at once. Use it in a `with` block, or `close` it."""

    def __init__(self, folder: Path) -> None:
        """Opens or creates the manifest in `folder`. Raises InputError `out_in_use` while another command has it open,
        `manifest_unreadable` and `file_unwritable`."""
        self._lock = _locked(folder)
        try:
            self._connection = sqlite3.connect(folder / FILE, isolation_level=None)
            self._connection.execute("PRAGMA journal_mode = WAL")
            self._connection.execute("PRAGMA synchronous = NORMAL")
            self._connection.executescript(_SCHEMA.read_text(encoding="utf-8"))
            self._connection.execute(f"{_SELECT} LIMIT 1").fetchall()
        except (sqlite3.Error, TypeError, ValueError) as error:
            self._lock.close()
            message = f"{folder / FILE}: no manifest of this version ({error}); remove it, and all is performed again"
            raise InputError("manifest_unreadable", message, field="out") from None

    def entries(self) -> dict[str, Entry]:
        """All rows by id, in the script's order."""
        return {row[0]: of_row(row) for row in self._connection.execute(_SELECT)}

    def put(self, entries: Iterable[Entry]) -> None:
        """Writes rows in one transaction, replacing those with the same ids."""
        with self._connection:
            self._connection.execute("BEGIN")
            self._connection.executemany(_WRITE, map(to_row, entries))

    def remove(self, ids: Iterable[str]) -> None:
        """Removes rows in one transaction."""
        with self._connection:
            self._connection.execute("BEGIN")
            self._connection.executemany("DELETE FROM lines WHERE id = ?", ((name,) for name in ids))

    def known_recordings(self) -> dict[str, KnownRecording]:
        """The hashes of recordings, by path."""
        rows = self._connection.execute("SELECT path, size, modified_ns, hash FROM recordings")
        return {path: KnownRecording(size, modified_ns, told) for path, size, modified_ns, told in rows}

    def know_recordings(self, known: Iterable[tuple[str, KnownRecording]]) -> None:
        """Saves the hashes of recordings."""
        rows = ((path, each.size, each.modified_ns, each.hash) for path, each in known)
        with self._connection:
            self._connection.execute("BEGIN")
            self._connection.executemany("INSERT OR REPLACE INTO recordings VALUES (?, ?, ?, ?)", rows)

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
        message = f"{folder}: cannot be written to: {error.strerror}"
        raise InputError("file_unwritable", message, field="out") from None
    try:
        lock = sqlite3.connect(folder / _LOCK, isolation_level=None, timeout=0)
        lock.execute("BEGIN EXCLUSIVE")
    except sqlite3.OperationalError as error:
        if error.sqlite_errorcode == sqlite3.SQLITE_BUSY:
            message = f"{folder}: another understudy batch is writing there; wait for it, or give another --out"
            raise InputError("out_in_use", message, field="out") from None
        message = f"{folder}: cannot be written to: {error}"
        raise InputError("file_unwritable", message, field="out") from None
    return lock

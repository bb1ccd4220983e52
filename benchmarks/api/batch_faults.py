"""Batches whose files cannot be used: a locked manifest, an output that is a file or read-only, a script that is a pipe
or a zip bomb. Each is refused with its code, within seconds of processor time.
"""

import io
import os
import sqlite3
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from pathlib import Path
from types import MappingProxyType
from zipfile import ZIP_DEFLATED, ZipFile

from understudy.batch.manifest.store import FILE, Manifest
from understudy.batch.scripts.reading import read_script
from understudy.errors import UnderstudyError

from .bars import Bar

LONGEST_S = 10.0
BOMB_MB = 200
READ_ONLY = "/proc/understudy"
"""Where nobody may write, root neither."""


def _locked(folder: Path) -> None:
    Manifest(folder).close()
    with closing(sqlite3.connect(folder / FILE, isolation_level=None)) as other:
        other.execute("PRAGMA journal_mode = DELETE")
        other.execute("BEGIN EXCLUSIVE")
        Manifest(folder).close()


def _used(folder: Path) -> None:
    with Manifest(folder), Manifest(folder):
        pass


def _file(folder: Path) -> None:
    (folder / "out").write_text("a file")
    Manifest(folder / "out").close()


def _read_only(_folder: Path) -> None:
    Manifest(Path(READ_ONLY)).close()


def _pipe(folder: Path) -> None:
    os.mkfifo(folder / "lines.csv")
    read_script(folder / "lines.csv", {})


def _bomb(folder: Path) -> None:
    content = io.BytesIO()
    with ZipFile(content, "w", ZIP_DEFLATED) as packed, packed.open("xl/workbook.xml", "w") as part:
        for _ in range(BOMB_MB):
            part.write(bytes(1 << 20))
    (folder / "lines.xlsx").write_bytes(content.getvalue())
    read_script(folder / "lines.xlsx", {})


FAULTS: Mapping[str, tuple[Callable[[Path], None], str]] = MappingProxyType(
    {
        "a manifest that another program locks": (_locked, "out_in_use"),
        "an output that another batch uses": (_used, "out_in_use"),
        "an output that is a file": (_file, "file_unwritable"),
        "a read-only output": (_read_only, "file_unwritable"),
        "a script that is a pipe": (_pipe, "file_unreadable"),
        "a workbook that is a zip bomb": (_bomb, "sheet_too_large"),
    }
)
"""What is done in an empty folder, and the code with which it has to end."""


def batch_faults() -> Iterator[Bar]:
    """Each fault, in a folder of its own."""
    for name, (fault, code) in FAULTS.items():
        began_s = time.process_time()
        with tempfile.TemporaryDirectory() as folder:
            ended = _ended(fault, Path(folder))
        took_s = time.process_time() - began_s
        yield Bar(name, f"{ended}, {took_s:.1f} s", code, ended == code and took_s <= LONGEST_S)


def _ended(fault: Callable[[Path], None], folder: Path) -> str:
    try:
        fault(folder)
    except UnderstudyError as error:
        return error.code
    except Exception as error:  # noqa: BLE001 - the faults that are looked for
        return f"{type(error).__name__}: {error}"[:200]
    return "used"

"""Finds the data files that ship with the code, reads files that authors write, and replaces files atomically.

In a checkout the data files are beside the package, in a wheel inside it. While a file is replaced, readers see either
its old content or the new, and a killed process leaves the old one.
"""

import errno
import os
import shutil
from pathlib import Path

from .errors import Mistake, ServiceError

_PACKAGE = Path(__file__).resolve().parent

RULES = _PACKAGE / "rules"
"""The rule files, which are inside the package."""


LARGEST_READ_BYTES = 32 << 20


def resource_folder(name: str) -> Path:
    """The folder `name` ("lexicon", "models", "examples"), wherever the package is installed.

    Raises ServiceError with code `installation_incomplete` when it is in neither place.
    """
    for parent in (_PACKAGE, _PACKAGE.parent):
        if (parent / name).is_dir():
            return parent / name
    raise ServiceError(
        "installation_incomplete", f"the folder {name!r} is missing beside {_PACKAGE}; reinstall understudy"
    )


def require_regular(path: Path, most_bytes: int = LARGEST_READ_BYTES) -> None:
    """Raises OSError for a pipe or a device, which might be read for ever, and for a file that is larger."""
    if path.exists() and not path.is_file() and not path.is_dir():
        raise OSError(errno.EINVAL, "it is not a regular file")
    if path.stat().st_size > most_bytes:
        raise OSError(errno.EFBIG, f"it is larger than {most_bytes >> 20} MB")


def read_regular(path: Path) -> bytes:
    """The content of a file that another one names. Raises OSError, also as `require_regular` does."""
    require_regular(path)
    return path.read_bytes()


def read_source(path: Path) -> str | Mistake:
    """The text of a file that an author writes, or why there is none."""
    try:
        return path.read_text(encoding="utf-8-sig")
    except OSError as error:
        return Mistake(path, 1, 1, f"cannot be read: {error.strerror}")
    except UnicodeDecodeError as error:
        return Mistake(path, 1, 1, f"not UTF-8 text at byte {error.start}")


def replace_file(target: Path, content: bytes, *, unfinished: Path | None = None) -> None:
    """Writes a file under another name, beside it or as `unfinished` on the same disk, and renames that. A file that is
    replaced keeps its mode. Raises OSError; then there is nothing under the other name."""
    unfinished = unfinished or target.with_name(f".{target.name}.{os.getpid()}")
    try:
        unfinished.write_bytes(content)
        if target.exists():
            shutil.copymode(target, unfinished)
        os.replace(unfinished, target)
    finally:
        unfinished.unlink(missing_ok=True)

"""Writes files whole: readers see the old content or the new, never a part, and a killed process leaves the old one."""

import os
import shutil
from pathlib import Path


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

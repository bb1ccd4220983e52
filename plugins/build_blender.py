"""Builds the Blender extension: `dist/understudy-blender-VERSION.zip`, the same bytes from the same files.

Run by `make plugin`; needs nothing but Python. Blender's own `blender_ext.py validate` accepts it.
"""

import os
import tomllib
import zipfile
from pathlib import Path

SOURCE = Path(__file__).parent / "blender"
OUTPUT = Path(__file__).parents[1] / "dist"
_ENDINGS = {".py", ".toml"}
_EARLIEST = (1980, 1, 1, 0, 0, 0)


def build(folder: Path = OUTPUT) -> Path:
    """The zip, written into a folder."""
    manifest = tomllib.loads((SOURCE / "blender_manifest.toml").read_text(encoding="utf-8"))
    target = folder / f"understudy-blender-{manifest['version']}.zip"
    folder.mkdir(parents=True, exist_ok=True)
    unfinished = target.with_suffix(".part")
    with zipfile.ZipFile(unfinished, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(SOURCE.rglob("*")):
            if path.suffix in _ENDINGS or path.name == "LICENSE":
                entry = zipfile.ZipInfo(path.relative_to(SOURCE).as_posix(), _EARLIEST)
                entry.compress_type = zipfile.ZIP_DEFLATED
                archive.writestr(entry, path.read_bytes())
    os.replace(unfinished, target)
    return target


if __name__ == "__main__":
    build()

"""The scene with which the page was opened: the folder of a batch, of which the files that its index names are sent."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..errors import InputError

INDEX = "index.json"


@dataclass(frozen=True, slots=True)
class OpenedScene:
    """A batch's output folder, and the names of the files that the page may have."""

    folder: Path
    names: frozenset[str]

    @classmethod
    def of(cls, folder: Path) -> "OpenedScene":
        """Raises InputError `file_unreadable` and `scene_wrong` where there is no index of a batch."""
        path = folder / INDEX
        try:
            index = json.loads(path.read_bytes())
            return cls(folder.resolve(), frozenset([INDEX, *_named(index)]))
        except OSError as error:
            message = f"{path}: cannot be read: {error.strerror}; give the folder that understudy batch wrote to"
            raise InputError("file_unreadable", message, field="scene") from None
        except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
            raise InputError(
                "scene_wrong", f"{path}: not an index that understudy batch wrote", field="scene"
            ) from None

    def file(self, name: str) -> Path | None:
        """The file of that name; None where the index does not name it, or it is not in the folder."""
        return file_inside(self.folder, name) if name in self.names else None


def file_inside(folder: Path, name: str) -> Path | None:
    """The file of that name in a resolved folder; None where there is none, whatever the name, even one that no file
    can have (too long, a null character in it)."""
    try:
        path = (folder / name).resolve()
        return path if path.is_relative_to(folder) and path.is_file() else None
    except (OSError, ValueError):
        return None


def _named(index: Mapping[str, Any]) -> Iterator[str]:
    for line in index["lines"]:
        for files in (line["files"], *line.get("listeners", {}).values()):
            yield from map(str, files.values())

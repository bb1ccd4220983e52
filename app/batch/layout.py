"""The paths of outputs, relative to the output folder: `{character}/{id}.{ext}`, for every line and format."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath

from ..errors import InputError, did_you_mean
from .model import Take
from .work.formats import OutputFormat, extension_of
from .work.jobs import OutputTarget

PLACES = ("id", "character", "scene", "take", "row", "ext")
USUAL = "{id}.{ext}"
OURS = frozenset({"manifest.sqlite", "report.csv", "report.html", "index.json"})
"""The batch's own files."""

_FORBIDDEN = re.compile(r'[\x00-\x1f<>:"/\\|?*]+')
_LONGEST = 120


@dataclass(frozen=True, slots=True)
class Layout:
    """A checked layout."""

    text: str = USUAL

    def __post_init__(self) -> None:
        """Raises InputError `layout_wrong`."""
        named = re.findall(r"\{([^{}]*)\}", self.text)
        unknown = [name for name in named if name not in PLACES]
        if unknown or re.search(r"[{}]", re.sub(r"\{[^{}]*\}", "", self.text)):
            hint = did_you_mean(unknown[0], PLACES) if unknown else ""
            self._refuse(f"places are {', '.join(f'{{{name}}}' for name in PLACES)}{hint}")
        if "id" not in named and "row" not in named:
            self._refuse("every line would get the same name; put {id} in it")
        if not self.text.endswith(".{ext}"):
            self._refuse("end it in .{ext}, which is the format")
        if PurePosixPath(self.text).is_absolute() or ".." in PurePosixPath(self.text).parts:
            self._refuse("it lies in the output folder; give no / before it and no .. in it")

    def targets(self, take: Take, formats: Sequence[OutputFormat]) -> tuple[OutputTarget, ...]:
        """The files of a line."""
        line = take.line
        values = {
            "id": take.id,
            "character": line.character or "nobody",
            "scene": line.scene or "0",
            "take": str(take.number or 0),
            "row": str(line.row),
        }
        return tuple(OutputTarget(form, self._path(values, extension_of(form))) for form in formats)

    def _path(self, values: Mapping[str, str], ending: str) -> str:
        stem = self.text.removesuffix(".{ext}")
        for name, value in values.items():
            stem = stem.replace(f"{{{name}}}", file_name(value))
        return f"{stem.replace('{ext}', ending)}.{ending}"

    def _refuse(self, why: str) -> None:
        raise InputError("layout_wrong", f"--layout {self.text!r}: {why}", field="layout")


def file_name(value: str) -> str:
    """A value as part of a file name that is valid on every file system."""
    return _FORBIDDEN.sub("_", value).strip(" .")[:_LONGEST] or "_"


def require_apart(targets: Iterable[tuple[str, OutputTarget]]) -> None:
    """Raises InputError `layout_wrong` when two lines would be written to the same file, or one to a file of the batch
    itself. Names are compared without case, as some file systems do."""
    owners: dict[str, str] = {}
    for name, target in targets:
        key = target.path.casefold()
        if key in OURS:
            message = (
                f"line {name!r} would be written to {target.path}, which is the batch's own; give another --layout"
            )
            raise InputError("layout_wrong", message, field="layout")
        owner = owners.setdefault(key, name)
        if owner != name:
            message = f"lines {owner!r} and {name!r} would both be written to {target.path}; put {{id}} in --layout"
            raise InputError("layout_wrong", message, field="layout")

"""Finds an author's edits for the lines of a batch: those named in the script, else the file `ID.edits.json` beside the
recording, ID being that of the take, that of the line or the recording's own name."""

from collections.abc import Iterable, Mapping
from pathlib import Path

from ..errors import InputError
from ..model.edits import Edits
from ..schemas.edits import read_edits
from .layout import file_name
from .model import Problem, Take

ENDING = ".edits.json"


def edits_of_takes(takes: Iterable[Take]) -> tuple[Mapping[str, Edits], tuple[Problem, ...]]:
    """The edits by the id of the take, for takes that have any, and the problems with files of edits."""
    found, problems = dict[str, Edits](), list[Problem]()
    for take in takes:
        path = _path(take)
        try:
            if take.line.edits is not None:
                found[take.id] = take.line.edits
            elif path is not None:
                found[take.id] = read_edits(path.read_bytes())
        except InputError as error:
            problems.append(Problem(take.line.row, "", error.code, f"{path}: {error.message}", take.id))
        except OSError as error:
            message = f"{path}: cannot be read: {error.strerror}"
            problems.append(Problem(take.line.row, "", "file_unreadable", message, take.id))
    return found, tuple(problems)


def _path(take: Take) -> Path | None:
    folder, names = take.recording.path.parent, (take.id, take.line.id, take.recording.path.stem)
    paths = (folder / f"{file_name(name)}{ENDING}" for name in names)
    return next((path for path in paths if path.is_file()), None)

"""A line of the manifest as a value, and as a row of its table."""

import json
from dataclasses import asdict, dataclass
from enum import StrEnum
from typing import Any

from pydantic import TypeAdapter

from ...model import Notice
from ..work.jobs import Failure, Measures


class State(StrEnum):
    """The state of a line."""

    WAITING = "waiting"
    DONE = "done"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class WrittenFile:
    """A file written for a line: its format, the listener whose it is ("" is the speaker), its path relative to the
    output folder, its size in bytes."""

    form: str
    listener: str
    path: str
    size: int


@dataclass(frozen=True, slots=True)
class ManifestEntry:
    """A line of the batch, the hashes of its input, and its result."""

    id: str
    place: int
    row: int
    character: str
    performer: str
    text: str
    comment: str
    audio: str
    start_s: float | None
    end_s: float | None
    input_hash: str
    settings_hash: str
    state: State = State.WAITING
    outputs: tuple[WrittenFile, ...] = ()
    warnings: tuple[Notice, ...] = ()
    measures: Measures | None = None
    failure: Failure | None = None
    seconds: float | None = None

    def is_made_of_the_same(self, other: "ManifestEntry") -> bool:
        return (self.input_hash, self.settings_hash) == (other.input_hash, other.settings_hash)


COLUMNS = (
    "id",
    "place",
    "row",
    "character",
    "performer",
    "text",
    "comment",
    "audio",
    "start_s",
    "end_s",
    "input_hash",
    "settings_hash",
    "state",
    "outputs",
    "warnings",
    "measures",
    "error_code",
    "error",
    "seconds",
)

_OF_A_FILE = ("form", "listener", "path", "size")
_OF_A_NOTICE = ("code", "message")
_ENTRY = TypeAdapter(ManifestEntry)


def to_row(entry: ManifestEntry) -> tuple[object, ...]:
    """The values of `COLUMNS`."""
    plain = [getattr(entry, name) for name in COLUMNS[:12]]
    return (
        *plain,
        entry.state.value,
        json.dumps([[file.form, file.listener, file.path, file.size] for file in entry.outputs]),
        json.dumps([[notice.code, notice.message] for notice in entry.warnings], ensure_ascii=False),
        None if entry.measures is None else json.dumps(asdict(entry.measures)),
        entry.failure.code if entry.failure else None,
        entry.failure.message if entry.failure else None,
        entry.seconds,
    )


def of_row(row: tuple[Any, ...]) -> ManifestEntry:
    """The entry that `to_row` stored. Raises ValueError for a row that it cannot have stored."""
    state, outputs, warnings, measures, error_code, error, seconds = row[12:]
    try:
        files = [dict(zip(_OF_A_FILE, file, strict=True)) for file in _read(outputs)]
        notices = [dict(zip(_OF_A_NOTICE, notice, strict=True)) for notice in _read(warnings)]
        measured = None if measures is None else _read(measures)
    except (TypeError, RecursionError) as wrong:
        raise ValueError(str(wrong)) from None
    values = dict(zip(COLUMNS[:12], row[:12], strict=True)) | {
        "state": state,
        "outputs": files,
        "warnings": notices,
        "measures": measured,
        "failure": None if error_code is None else {"code": error_code, "message": error},
        "seconds": seconds,
    }
    return _ENTRY.validate_python(values)


def _read(column: str) -> Any:  # noqa: ANN401 - JSON
    """What a column holds. Raises ValueError where it is not JSON, or has text that could not be written anywhere."""
    found = json.loads(column)
    json.dumps(found, ensure_ascii=False).encode()
    return found

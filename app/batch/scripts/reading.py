"""Reads a script of any supported format, chosen by the file's extension."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

from ...errors import InputError, TooLargeError, UnsupportedFormatError
from ..model import Script
from .delimited import read_delimited, read_json_lines
from .screenplays import read_fdx, read_fountain
from .subtitles import read_srt, read_webvtt
from .workbooks import read_workbook

LARGEST_SCRIPT_BYTES = 256 << 20

Reader = Callable[[bytes, Path, Mapping[str, str]], Script]

READERS: Mapping[str, Reader] = MappingProxyType(
    {
        ".csv": read_delimited,
        ".tsv": read_delimited,
        ".tab": read_delimited,
        ".xlsx": read_workbook,
        ".jsonl": read_json_lines,
        ".fountain": read_fountain,
        ".fdx": read_fdx,
        ".srt": read_srt,
        ".vtt": read_webvtt,
    }
)
"""The readers by extension; they take content, path, and the headings of columns that the caller named."""


_UNITS: Mapping[str, str] = MappingProxyType(
    {".fountain": "line", ".fdx": "line", ".jsonl": "line", ".srt": "cue", ".vtt": "cue"}
)
"""What rows are called in formats that are no sheets."""


def read_script(path: Path, named: Mapping[str, str], sheets: Sequence[str] = ()) -> Script:
    """The script in a file; `sheets` are the chosen worksheets of a workbook.

    Raises UnsupportedFormatError `script_format`, InputError `file_unreadable`, `script_empty` and as the format's
    reader does; problems of single lines are part of the script.
    """
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        message = f"{path}: scripts are {', '.join(READERS)}; save it as one of them"
        raise UnsupportedFormatError("script_format", message, field="script")
    if sheets and reader is not read_workbook:
        raise InputError("usage", f"--sheet: {path} has no worksheets; leave it out", field="sheet")
    content = _content(path)
    script = read_workbook(content, path, named, chosen=sheets) if sheets else reader(content, path, named)
    if not script.lines and not script.problems:
        raise InputError("script_empty", f"{path}: it has no lines", field="script")
    unit = _UNITS.get(path.suffix.lower(), "row")
    return replace(script, unit=unit, problems=tuple(replace(each, unit=unit) for each in script.problems))


def _content(path: Path) -> bytes:
    try:
        if path.exists() and not path.is_file():
            raise InputError("file_unreadable", f"{path}: not a regular file; save the script as one", field="script")
        if path.stat().st_size > LARGEST_SCRIPT_BYTES:
            message = f"{path}: larger than {LARGEST_SCRIPT_BYTES >> 20} MB; divide it"
            raise TooLargeError("file_too_large", message, field="script")
        return path.read_bytes()
    except OSError as error:
        raise InputError("file_unreadable", f"{path}: cannot be read: {error.strerror}", field="script") from None

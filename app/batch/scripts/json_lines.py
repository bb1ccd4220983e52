"""Reads JSON lines: one object per line of the file, its keys as the columns of a sheet."""

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from ..model import Problem, Script
from .columns import ColumnNames, find_columns
from .sheets import read_lines
from .text_files import decode_text


def read_json_lines(content: bytes, path: Path, named: Mapping[str, str]) -> Script:
    """The script in a file of JSON lines; a line that is not an object is a problem of its own. Raises UndecodableError
    `text_not_utf8`, InputError `columns_missing`."""
    file = decode_text(content, str(path))
    objects: dict[int, dict[str, object]] = {}
    problems = []
    for number, line in enumerate(file.text.splitlines(), start=1):
        if line.strip():
            try:
                objects[number] = _object(line)
            except ValueError as error:
                problems.append(Problem(number, "", "not_json", str(error)))
    keys = list(dict.fromkeys(key for each in objects.values() for key in each))
    if not objects:
        return Script(path, (), tuple(problems))
    columns = replace(find_columns(keys, ColumnNames.load(), named, file=str(path)), has_letters=False)
    rows = ((number, [_told(each.get(key)) for key in keys]) for number, each in objects.items())
    script = read_lines(rows, columns, path, [file.remark] if file.remark else [])
    return replace(script, problems=tuple(sorted([*problems, *script.problems], key=lambda each: each.row)))


def _object(line: str) -> dict[str, object]:
    try:
        value = json.loads(line)
    except RecursionError:
        raise ValueError("nested too deeply") from None
    if not isinstance(value, dict):
        raise ValueError("no JSON object in braces")
    return value


def _told(value: object) -> str:
    """A value as a sheet would have it: lists of names with commas, a director's notes as JSON."""
    if value is None:
        return ""
    if isinstance(value, list) and all(isinstance(each, str) for each in value):
        return ", ".join(value)
    return value if isinstance(value, str) else json.dumps(value)

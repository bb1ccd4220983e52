"""Writes `index.json`: the performed lines and the paths of their files, for game engines."""

import json
from collections.abc import Iterable

from ..manifest.entries import Entry, State


def to_index(script: str, entries: Iterable[Entry]) -> bytes:
    """The lines that are done, in the script's order; paths are relative to the output folder."""
    lines = [_line(entry) for entry in sorted(entries, key=lambda one: one.place) if entry.state is State.DONE]
    return json.dumps({"script": script, "lines": lines}, indent=1, ensure_ascii=False).encode() + b"\n"


def _line(entry: Entry) -> dict[str, object]:
    listeners: dict[str, dict[str, str]] = {}
    for file in entry.outputs:
        if file.listener:
            listeners.setdefault(file.listener, {})[file.form] = file.path
    return {
        "id": entry.id,
        "character": entry.character,
        "performer": entry.performer,
        "text": entry.text,
        "audio": entry.audio,
        **({} if entry.start_s is None else {"start_s": entry.start_s, "end_s": entry.end_s}),
        "duration_s": entry.measures.duration_s if entry.measures else None,
        "agitation": entry.measures.agitation if entry.measures else None,
        "files": {file.form: file.path for file in entry.outputs if not file.listener},
        **({"listeners": listeners} if listeners else {}),
    }

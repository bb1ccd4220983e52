"""Reads and writes annotations as CSV and JSON (docs/profiles.md has both schemas).

CSV has one row per span: `track,start_s,end_s,label` and, for phrases, a column for each attribute. JSON is one object,
`{"tracks": {"phrases": [{"start_s", "end_s", "lexeme", "hand", …}]}}`. The key of a span's label depends on the track
(`text`, `tag`, `phase`, `lexeme`, `rest`), or is `label`.
"""

import csv
import json
from collections.abc import Iterable, Iterator, Sequence
from math import isfinite, nan
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from ...errors import did_you_mean
from .model import AnnotationError, AnnotationMistake
from .tracks import LABELS, PHRASE_ATTRIBUTES, Track, TrackSpan, decoded, track_name, track_of

COLUMNS = ("track", "start_s", "end_s", "label")
DELIMITERS = (",", ";", "\t")
"""The delimiters of spreadsheets, which depend on the locale."""


def read_csv(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tracks of a table; raises AnnotationError with every invalid column and row."""
    lines = decoded(content, path).splitlines(keepends=True)
    delimiter = max(DELIMITERS, key=(lines or [""])[0].count)
    rows = csv.reader(lines, delimiter=delimiter, strict=True)
    wrong: list[AnnotationMistake] = []
    by_track: dict[str, list[TrackSpan]] = {}
    try:
        columns = _columns(next(rows, []), path)
        for cells in filter(any, rows):
            try:
                name, span = _row(columns, cells)
                by_track.setdefault(name, []).append(span)
            except ValueError as error:
                track = dict(zip(columns, cells, strict=False)).get("track", "")
                wrong.append(AnnotationMistake(path, f"line {rows.line_num}: {error}", track))
    except csv.Error as error:
        wrong.append(AnnotationMistake(path, f"line {rows.line_num}: {error}"))
    if wrong:
        raise AnnotationError(wrong)
    return tuple(track_of(name, spans) for name, spans in by_track.items())


def _columns(header: Iterable[str], path: Path) -> list[str]:
    """The names of the columns; raises AnnotationError with those that are missing, unknown or duplicated."""
    columns = [name.strip().lower() for name in header]
    known = (*COLUMNS, *PHRASE_ATTRIBUTES)
    wrong = [f"the column {name} is missing" for name in COLUMNS if name not in columns]
    unknown = sorted({*columns} - {*known})
    wrong += [f"no column may be called {name!r}{did_you_mean(name, known)}" for name in unknown]
    wrong += [f"two columns are called {name}" for name in known if columns.count(name) > 1]
    if wrong:
        raise AnnotationError(AnnotationMistake(path, f"line 1: {each}") for each in wrong)
    return columns


def _row(columns: Sequence[str], cells: Sequence[str]) -> tuple[str, TrackSpan]:
    """The track and the span of a row; raises ValueError with the row's mistake."""
    if len(cells) != len(columns):
        raise ValueError(f"{len(cells)} cells; the header has {len(columns)}")
    row = {name: cell.strip() for name, cell in zip(columns, cells, strict=True)}
    if not row["track"]:
        raise ValueError("no track")
    start_s, end_s = (_seconds(row[name], name) for name in ("start_s", "end_s"))
    attributes = {name: cell for name, cell in row.items() if cell and name not in COLUMNS}
    return row["track"], TrackSpan(start_s, end_s, row["label"], attributes)


def _seconds(said: str, name: str) -> float:
    try:
        seconds = float(said.replace(",", "."))
    except ValueError:
        seconds = nan
    if not isfinite(seconds):
        raise ValueError(f"{name} {said!r}; give seconds")
    return seconds


class _SpanForm(BaseModel):
    model_config = ConfigDict(defer_build=True, extra="allow", frozen=True)
    __pydantic_extra__: dict[str, str | int | None]

    start_s: Annotated[float, Field(allow_inf_nan=False)]
    end_s: Annotated[float, Field(allow_inf_nan=False)]


class _TracksFile(BaseModel):
    model_config = ConfigDict(defer_build=True, frozen=True)

    tracks: dict[str, list[_SpanForm]]


def read_json(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tracks of an object; raises AnnotationError with every invalid span."""
    try:
        file = _TracksFile.model_validate_json(decoded(content, path))
    except ValidationError as error:
        raise AnnotationError(_mistakes(path, error)) from None
    return tuple(
        track_of(name, (_span(track_name(name), span) for span in spans)) for name, spans in file.tracks.items()
    )


def write_json_tracks(tracks: Iterable[Track]) -> bytes:
    """The tracks in the format of `read_json`, one span per line."""
    parts = []
    for track in tracks:
        lines = ",\n".join(f"   {json.dumps(_form(track.name, span), ensure_ascii=False)}" for span in track.spans)
        parts.append(f"  {json.dumps(track.name)}: [\n{lines}\n  ]" if lines else f"  {json.dumps(track.name)}: []")
    return ('{\n "tracks": {\n' + ",\n".join(parts) + "\n }\n}\n").encode()


def _form(track: str, span: TrackSpan) -> dict[str, object]:
    times: dict[str, object] = {"start_s": round(span.start_s, 3), "end_s": round(span.end_s, 3)}
    return {**times, LABELS.get(track, "label"): span.label, **span.attributes}


def _span(track: str, span: _SpanForm) -> TrackSpan:
    said = {name: str(value) for name, value in (span.__pydantic_extra__ or {}).items() if value is not None}
    names = (LABELS.get(track, "label"), "label")
    label = next((said.pop(name) for name in names if name in said), "")
    return TrackSpan(span.start_s, span.end_s, label, said)


def _mistakes(path: Path, error: ValidationError) -> Iterator[AnnotationMistake]:
    """One mistake per location; pydantic reports one for each type of a union."""
    by_place = {tuple(map(str, found["loc"][:4])): found["msg"] for found in reversed(error.errors())}
    for place, message in reversed(by_place.items()):
        track, number, key = (*place[1:], "", "", "")[:3]
        where = " ".join(filter(None, (number and f"span {number}:", key or (not track and place and place[0]) or "")))
        yield AnnotationMistake(path, f"{where} {message}".strip(), track)

"""Reads and writes annotations as CSV and JSON (docs/profiles.md has both schemas).

CSV has a row a span: `track,start_s,end_s,label` and, for phrases, a column for each attribute. JSON is one object,
`{"tracks": {"phrases": [{"start_s", "end_s", "lexeme", "hand", …}]}}`, whose spans have their label under the track's
own word (`text`, `tag`, `phase`, `lexeme`, `rest`) or `label`.
"""

import csv
import io
import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from .mistakes import AnnotationError, AnnotationMistake
from .tracks import LABELS, PHRASE_ATTRIBUTES, Span, Track, track_name, track_of

COLUMNS = ("track", "start_s", "end_s", "label")


def read_csv(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tracks of a table; raises AnnotationError with every row that has no track or time."""
    rows = csv.DictReader(io.StringIO(_text(content, path)))
    missing = [name for name in COLUMNS if name not in (rows.fieldnames or ())]
    if missing:
        raise AnnotationError([AnnotationMistake(path, f"no column is called {', '.join(missing)}")])
    wrong: list[AnnotationMistake] = []
    by_track: dict[str, list[Span]] = {}
    for row in rows:
        try:
            times = float(row["start_s"]), float(row["end_s"])
        except (TypeError, ValueError):
            wrong.append(
                AnnotationMistake(path, f"line {rows.line_num}: start_s and end_s are seconds", row["track"] or "")
            )
            continue
        attributes = {name: row[name].strip() for name in PHRASE_ATTRIBUTES if row.get(name)}
        by_track.setdefault(row["track"], []).append(Span(*times, (row["label"] or "").strip(), attributes))
    if wrong:
        raise AnnotationError(wrong)
    return tuple(track_of(name, spans) for name, spans in by_track.items())


class _SpanForm(BaseModel):
    model_config = ConfigDict(extra="allow", frozen=True)
    __pydantic_extra__: dict[str, str | int | None]

    start_s: Annotated[float, Field(allow_inf_nan=False)]
    end_s: Annotated[float, Field(allow_inf_nan=False)]


class _File(BaseModel):
    model_config = ConfigDict(frozen=True)

    tracks: dict[str, list[_SpanForm]]


def read_json(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tracks of an object; raises AnnotationError with every span that is none."""
    try:
        file = _File.model_validate_json(content)
    except ValidationError as error:
        raise AnnotationError(_mistakes(path, error)) from None
    return tuple(
        track_of(name, (_span(track_name(name), span) for span in spans)) for name, spans in file.tracks.items()
    )


def write_json_tracks(tracks: Iterable[Track]) -> bytes:
    """The tracks as `read_json` reads them, a span a line."""
    parts = []
    for track in tracks:
        lines = ",\n".join(f"   {json.dumps(_form(track.name, span), ensure_ascii=False)}" for span in track.spans)
        parts.append(f"  {json.dumps(track.name)}: [\n{lines}\n  ]" if lines else f"  {json.dumps(track.name)}: []")
    return ('{\n "tracks": {\n' + ",\n".join(parts) + "\n }\n}\n").encode()


def _form(track: str, span: Span) -> dict[str, object]:
    times: dict[str, object] = {"start_s": round(span.start_s, 3), "end_s": round(span.end_s, 3)}
    return {**times, LABELS.get(track, "label"): span.label, **span.attributes}


def _span(track: str, span: _SpanForm) -> Span:
    said = {name: str(value) for name, value in (span.__pydantic_extra__ or {}).items() if value is not None}
    names = (LABELS.get(track, "label"), "label")
    label = next((said.pop(name) for name in names if name in said), "")
    return Span(span.start_s, span.end_s, label, said)


def _mistakes(path: Path, error: ValidationError) -> Iterator[AnnotationMistake]:
    for found in error.errors():
        _tracks, track, *place = (*map(str, found["loc"]), "", "")[:4]
        where = f"span {place[0]}: " if place and place[0] else ""
        yield AnnotationMistake(path, f"{where}{' '.join(place[1:])} {found['msg']}".replace("  ", " "), track)


def _text(content: bytes, path: Path) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise AnnotationError([AnnotationMistake(path, f"not UTF-8 at byte {error.start}; save it as UTF-8")]) from None

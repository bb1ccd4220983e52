"""Writes `report.html`: every line in one file, the most urgent to check first, with its recording to listen to.

Pictures are in the page, among them one of the distributions of the lines' measures, if matplotlib is installed (the
extra `plot`); recordings and a line's files are linked, relative to the folder of the report.
"""

from __future__ import annotations

import base64
import io
import os
import shlex
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING
from urllib.parse import quote

from ..manifest.entries import ManifestEntry, State
from ..work.jobs import Measures
from .attention import attention, plain_words, reasons

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_TEMPLATE = Path(__file__).with_name("report.html")
_COLUMNS = ("line", "words", "look at", "seconds", "agitation", "gestures")


@dataclass(frozen=True, slots=True)
class Heading:
    """The script's name, and what its rows are called."""

    script: str
    unit: str = "row"


@dataclass(frozen=True, slots=True)
class Thumbnail:
    """A contact sheet: its path relative to the output folder, and a smaller PNG of it."""

    path: str
    content: bytes


def to_html(
    heading: Heading, entries: Sequence[ManifestEntry], thumbnails: Mapping[str, Thumbnail], out: Path
) -> bytes:
    """The report for the folder `out`, in the order of `entries`; `thumbnails` are by the lines' ids."""
    template = Template(_TEMPLATE.read_text(encoding="utf-8"))
    return template.substitute(
        title=f"{escape(heading.script)}: performed",
        summary=_summary(entries),
        histograms=_histograms(entries),
        headings="".join(f'<th scope="col"><button>{told}</button></th>' for told in (heading.unit, *_COLUMNS)),
        rows="\n".join(_row(entry, thumbnails.get(entry.id), out) for entry in entries),
    ).encode()


def _summary(entries: Sequence[ManifestEntry]) -> str:
    states = Counter(entry.state for entry in entries)
    hours = sum(entry.measures.duration_s for entry in entries if entry.measures) / 3600
    looks = sum(attention(entry) > 0 for entry in entries)
    return (
        f"{states[State.DONE]} lines performed, {hours:.2f} hours of speech; {states[State.FAILED]} failed; "
        f"{looks} need attention and are listed first."
    )


def _histograms(entries: Sequence[ManifestEntry]) -> str:
    measures = [entry.measures for entry in entries if entry.measures is not None and entry.measures.duration_s > 0]
    picture = draw_histograms(measures) if measures else b""
    if picture is None:
        return "<p>Histograms need matplotlib: <code>pip install '.[plot]'</code></p>"
    return _picture(picture, "histograms", "how the lines are distributed") if picture else ""


def _picture(png: bytes, kind: str, told: str) -> str:
    content = base64.b64encode(png).decode()
    return f'<img class="{kind}" alt="{escape(told)}" src="data:image/png;base64,{content}">'


def _row(entry: ManifestEntry, thumbnail: Thumbnail | None, out: Path) -> str:
    kind = "failed" if entry.state is State.FAILED else "look" if attention(entry) else "fine"
    return f'<tr class="{kind}">{"".join(_cells(entry, thumbnail, out))}</tr>'


def _cells(entry: ManifestEntry, thumbnail: Thumbnail | None, out: Path) -> Iterator[str]:
    measures = entry.measures
    yield _number(entry.row)
    played = f" <small>by {escape(entry.performer)}</small>" if entry.performer else ""
    yield f'<td><strong class="id">{escape(entry.id)}</strong><div>{escape(entry.character)}{played}</div></td>'
    comment = f'<div class="comment">{escape(entry.comment)}</div>' if entry.comment else ""
    picture = _enlarging(thumbnail, entry.id) if thumbnail else ""
    yield f'<td><p class="words">{escape(entry.text)}</p>{comment}{_player(entry, out)}{_links(entry)}{picture}</td>'
    yield f'<td data-value="{attention(entry)}">{"".join(_looks(entry))}</td>'
    yield _number(f"{measures.duration_s:.2f}" if measures else "")
    yield f"<td>{measures.agitation if measures else ''}</td>"
    yield _gestures(entry)


def _number(value: object) -> str:
    return f'<td class="number">{value}</td>'


def _gestures(entry: ManifestEntry) -> str:
    """How many gestures there are, how many gave way, and what the words do."""
    measures = entry.measures
    if measures is None:
        return "<td></td>"
    dropped = f" <small>{measures.gestures_dropped}\u00a0gave\u00a0way</small>" if measures.gestures_dropped else ""
    counted = ", ".join(
        name.replace("_", " ") if count == 1 else f"{count}\u00a0{name.replace('_', ' ')}"
        for name, count in measures.functions.items()
    )
    why = f"<details><summary>functions</summary>{escape(counted)}</details>" if counted else ""
    return f'<td data-value="{measures.gestures}">{measures.gestures}{dropped}{why}</td>'


def _looks(entry: ManifestEntry) -> Iterator[str]:
    """What somebody should look at and what can be done, then the messages."""
    for weight, code in reasons(entry):
        meaning, advice = plain_words(code)
        kind = "reason" if weight else "reason mild"
        yield f'<div class="{kind}"><b>{escape(meaning)}</b><span>{escape(advice)}</span></div>'
    if entry.failure:
        yield f'<p class="error">{escape(entry.failure.message)}</p>'
    listed = "".join(f"<p>{escape(notice.message)}</p>" for notice in entry.warnings)
    if listed:
        yield f'<details class="messages"><summary>messages</summary>{listed}</details>'


def _player(entry: ManifestEntry, out: Path) -> str:
    if not entry.audio:
        return ""
    cut = "" if entry.start_s is None or entry.end_s is None else f"#t={entry.start_s:.3f},{entry.end_s:.3f}"
    address = f"{_relative(Path(entry.audio), out)}{cut}"
    return f'<audio controls preload="none" src="{address}" aria-label="{escape(entry.id)}"></audio>'


def _relative(path: Path, out: Path) -> str:
    """The address of a file for a page in `out`; on another drive there is only an absolute one."""
    try:
        return f"./{quote(Path(os.path.relpath(path, out)).as_posix())}"
    except ValueError:
        return path.absolute().as_uri()


def _links(entry: ManifestEntry) -> str:
    """The line's files, and the command that opens it in the studio."""
    links = [
        f'<a href="./{quote(file.path)}">{escape(f"{file.listener}: " if file.listener else "")}{escape(file.form)}</a>'
        for file in entry.outputs
    ]
    if entry.audio and entry.start_s is None:
        command = shlex.join(["understudy", "studio", entry.audio, "--text", entry.text])
        links.append(f'<button class="studio" data-command="{escape(command)}">studio</button>')
    return f'<div class="links">{" ".join(links)}</div>' if links else ""


def _enlarging(thumbnail: Thumbnail, name: str) -> str:
    picture = _picture(thumbnail.content, "thumbnail", f"key poses of {name}")
    return f'<a class="enlarge" href="./{quote(thumbnail.path)}">{picture}</a>'


INCHES = (12.0, 5.2)
DOTS_PER_INCH = 80
BINS = 30
MOST_FUNCTIONS = 14
COLOUR = "#1f4e79"


def draw_histograms(measures: Sequence[Measures]) -> bytes | None:
    """The picture as PNG; None where matplotlib is not installed."""
    try:
        from matplotlib.figure import Figure
    except ModuleNotFoundError:
        return None
    figure = Figure(figsize=INCHES, layout="constrained")
    rows = figure.subplots(2, 3)
    _histogram(rows[0][0], [each.duration_s for each in measures], "seconds a line")
    _histogram(rows[0][1], [60 * each.gestures / each.duration_s for each in measures], "gestures a minute")
    spreads = [each.pitch_spread_st for each in measures if each.pitch_spread_st is not None]
    _histogram(rows[0][2], spreads, "deviation of the pitch, semitones")
    _bars(rows[1][0], Counter(each.agitation for each in measures), "agitation", order=("low", "medium", "high"))
    _histogram(rows[1][1], [each.gestures_dropped for each in measures], "gestures that gave way")
    functions: Counter[str] = Counter()
    for each in measures:
        functions.update(each.functions)
    _bars(rows[1][2], functions, "functions", order=tuple(sorted(functions, key=lambda name: (-functions[name], name))))
    content = io.BytesIO()
    figure.savefig(content, format="png", dpi=DOTS_PER_INCH)
    return content.getvalue()


def _histogram(row: Axes, values: Sequence[float], label: str) -> None:
    row.hist(values, bins=BINS, color=COLOUR)
    _label(row, label)


def _bars(row: Axes, counts: Counter[str], label: str, *, order: Sequence[str]) -> None:
    shown = order[:MOST_FUNCTIONS]
    row.barh(range(len(shown)), [counts[name] for name in shown], color=COLOUR)
    row.set_yticks(range(len(shown)), shown, fontsize=7)
    row.invert_yaxis()
    _label(row, label)


def _label(row: Axes, label: str) -> None:
    row.set_title(label, fontsize=10)
    row.tick_params(labelsize=8)
    row.spines[["top", "right"]].set_visible(False)

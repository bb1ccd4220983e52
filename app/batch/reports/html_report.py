"""Writes `report.html`: every line in one self-contained file, the most urgent to check first."""

import base64
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from pathlib import Path
from string import Template

from ..manifest.entries import Entry, State
from .attention import attention, reasons
from .histograms import draw_histograms

HEADINGS = (
    "row",
    "line",
    "who",
    "words",
    "seconds",
    "agitation",
    "functions",
    "gestures",
    "gave way",
    "look at",
    "warnings and errors",
)
_TEMPLATE = Path(__file__).with_name("report.html")


def to_html(script: str, entries: Sequence[Entry], thumbnails: Mapping[str, bytes]) -> bytes:
    """The report, in the order of `entries`; `thumbnails` are PNG by the lines' ids."""
    template = Template(_TEMPLATE.read_text(encoding="utf-8"))
    return template.substitute(
        title=f"{escape(script)}: performed",
        summary=_summary(entries),
        histograms=_histograms(entries),
        headings="".join(f"<th>{heading}</th>" for heading in HEADINGS),
        rows="\n".join(_row(entry, thumbnails.get(entry.id)) for entry in entries),
    ).encode()


def _summary(entries: Sequence[Entry]) -> str:
    states = Counter(entry.state for entry in entries)
    hours = sum(entry.measures.duration_s for entry in entries if entry.measures) / 3600
    looks = sum(attention(entry) > 0 for entry in entries)
    return (
        f"{states[State.DONE]} lines performed, {hours:.2f} hours of speech; {states[State.FAILED]} failed; "
        f"{looks} want a look, and stand first."
    )


def _histograms(entries: Sequence[Entry]) -> str:
    measures = [entry.measures for entry in entries if entry.measures is not None and entry.measures.duration_s > 0]
    picture = draw_histograms(measures) if measures else b""
    if picture is None:
        return "<p>Histograms need matplotlib: <code>pip install 'understudy[plot]'</code></p>"
    return _picture(picture, "histograms", "how the lines are distributed") if picture else ""


def _picture(png: bytes, kind: str, told: str) -> str:
    content = base64.b64encode(png).decode()
    return f'<img class="{kind}" alt="{escape(told)}" src="data:image/png;base64,{content}">'


def _row(entry: Entry, thumbnail: bytes | None) -> str:
    kind = "failed" if entry.state is State.FAILED else "look" if attention(entry) else "fine"
    return f'<tr class="{kind}">{"".join(_cells(entry, thumbnail))}</tr>'


def _cells(entry: Entry, thumbnail: bytes | None) -> Iterator[str]:
    measures = entry.measures
    yield _number(entry.row)
    yield f"<td>{escape(entry.id)}</td>"
    played = f'<div class="comment">{escape(entry.performer)}</div>' if entry.performer else ""
    yield f"<td>{escape(entry.character)}{played}</td>"
    comment = f'<div class="comment">{escape(entry.comment)}</div>' if entry.comment else ""
    picture = _picture(thumbnail, "thumbnail", f"key poses of {entry.id}") if thumbnail else ""
    yield f"<td>{escape(entry.text)}{comment}{picture}</td>"
    yield _number(f"{measures.duration_s:.2f}" if measures else "")
    yield f"<td>{measures.agitation if measures else ''}</td>"
    functions = measures.functions if measures else {}
    yield f"<td>{escape(', '.join(f'{count} × {name}' for name, count in functions.items()))}</td>"
    yield _number(measures.gestures if measures else "")
    yield _number(measures.gestures_dropped if measures else "")
    told = "".join(f'<span class="reason">{escape(reason)}</span>' for _weight, reason in reasons(entry))
    yield f'<td data-value="{attention(entry)}">{told}</td>'
    yield f"<td>{_messages(entry)}</td>"


def _number(value: object) -> str:
    return f'<td class="number">{value}</td>'


def _messages(entry: Entry) -> str:
    error = f'<div class="error">{escape(entry.failure.message)}</div>' if entry.failure else ""
    return error + "".join(f'<div class="warning">{escape(notice.message)}</div>' for notice in entry.warnings)

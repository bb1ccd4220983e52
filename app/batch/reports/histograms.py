"""Draws the distributions of a batch's lines as one picture, with matplotlib (the extra `plot`)."""

from __future__ import annotations

import io
from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..work.jobs import Measures

if TYPE_CHECKING:
    from matplotlib.axes import Axes

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

"""A picture of an analysis, to judge by eye: what was measured in the signal, and what was made of it.

From top to bottom, over one time axis: the words and phones, the waveform, f0 and energy with the thresholds above
which a frame is stressed (paper §3.1.5), each word's stressed ratio and prominence, and beneath it all the memberships
of agitation. Emphasised words are marked throughout. matplotlib draws it; it is an extra, `pip install
'understudy[plot]'`.
"""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from app.errors import InputError, ServiceError
from app.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Agitation, Contours, FloatArray, Interval, StressThresholds, Word
from app.performance import Analysis, Heard

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FORMAT = ".png"
INCHES_PER_S = 1.7
NARROWEST_INCHES, WIDEST_INCHES = 11.0, 200.0
HEIGHT_INCHES = 9.0
DOTS_PER_INCH = 100
LINE, THRESHOLD, EMPHASIS, FAINT = "#1f4e79", "#c0392b", "#f2c078", "#9aa5b1"
MEMBERSHIPS = {"low": "#7fb3d5", "medium": "#a9cf9e", "high": "#e59866"}


def require_plot(name: str) -> None:
    """Raises InputError `plot_format` and ServiceError `plot_unavailable`, so that no work is done in vain."""
    if Path(name).suffix.lower() != FORMAT:
        raise InputError("plot_format", f"{name}: pictures are PNG; end the name in {FORMAT}", field="plot")
    try:
        import matplotlib.figure  # noqa: F401
    except ModuleNotFoundError:
        raise ServiceError(
            "plot_unavailable", "pictures need matplotlib, which is not installed: pip install 'understudy[plot]'"
        ) from None


def plot(analysis: Analysis, heard: Heard) -> bytes:
    """The picture, as PNG; matplotlib must be there (`require_plot`)."""
    from matplotlib.figure import Figure

    width = float(np.clip(INCHES_PER_S * heard.audio.duration_s, NARROWEST_INCHES, WIDEST_INCHES))
    figure = Figure(figsize=(width, HEIGHT_INCHES), layout="constrained")
    rows = figure.subplots(6, 1, height_ratios=(1.1, 1.3, 2, 2, 1.5, 0.4))
    for row in rows[1:5]:
        row.sharex(rows[0])
    _draw(rows, analysis, heard)
    _mark_emphasis(rows[:5], analysis)
    rows[0].set_xlim(0, heard.audio.duration_s)
    content = io.BytesIO()
    figure.savefig(content, format="png", dpi=DOTS_PER_INCH)
    return content.getvalue()


def _draw(rows: list[Axes], analysis: Analysis, heard: Heard) -> None:
    utterance = analysis.utterance
    _draw_words(rows[0], utterance.words)
    _draw_waveform(rows[1], heard.audio.samples)
    _draw_f0(rows[2], heard.contours, utterance.thresholds)
    _draw_energy(rows[3], heard.contours, utterance.thresholds)
    _draw_stress(rows[4], utterance.words)
    _draw_memberships(rows[5], utterance.agitation)
    for row in rows[:4]:
        row.tick_params(labelbottom=False)
    rows[4].set_xlabel("seconds")
    for row in rows:
        row.spines[["top", "right"]].set_visible(False)


def _draw_words(row: Axes, words: tuple[Word, ...]) -> None:
    """A box for each word, and under it one for each phone; neighbours' labels at two heights, lest they touch."""
    for word in words:
        if word.interval is not None:
            _draw_box(row, word.interval, 1, word.text, raised=word.index % 2 == 0)
        for place, phone in enumerate(word.phones):
            _draw_box(row, phone.interval, 0, phone.label, raised=place % 2 == 0)
    row.set_ylim(0, 2)
    row.set_yticks([0.5, 1.5], ["phones", "words"])


def _draw_box(row: Axes, interval: Interval, floor: int, label: str, *, raised: bool) -> None:
    row.broken_barh(
        [(interval.start_s, interval.duration_s)], (floor, 1), facecolor="none", edgecolor=FAINT, linewidth=0.6
    )
    middle_s, height = interval.start_s + interval.duration_s / 2, floor + (0.7 if raised else 0.3)
    size = 9 if floor else 6.5
    row.text(middle_s, height, label, ha="center", va="center", fontsize=size, clip_on=True)


def _draw_waveform(row: Axes, samples: FloatArray) -> None:
    """The range of the samples in each frame: as much as the eye can see, and fast for a long line."""
    hop = round(FRAME_SHIFT_S * SAMPLE_RATE_HZ) // 4
    frames = np.resize(np.pad(samples, (0, -len(samples) % hop)), (-(-len(samples) // hop), hop))
    times_s = (np.arange(len(frames)) + 0.5) * hop / SAMPLE_RATE_HZ
    row.fill_between(times_s, frames.min(axis=1), frames.max(axis=1), color=LINE, linewidth=0)
    row.set_ylabel("waveform")


def _draw_f0(row: Axes, contours: Contours, thresholds: StressThresholds | None) -> None:
    voiced_hz = np.where(contours.f0_hz > 0, contours.f0_hz, np.nan)
    row.plot(_times_s(contours), voiced_hz, color=LINE, marker=".", markersize=3, linewidth=1)
    if thresholds is not None and thresholds.f0_hz is not None:
        _draw_threshold(row, thresholds.f0_hz, f"{thresholds.f0_hz:.0f} Hz")
    row.set_ylabel("f0, Hz")


def _draw_energy(row: Axes, contours: Contours, thresholds: StressThresholds | None) -> None:
    row.plot(_times_s(contours), contours.energy_db, color=LINE, linewidth=1)
    if thresholds is not None:
        _draw_threshold(row, thresholds.energy_db, f"{thresholds.energy_db:.1f} dB")
    row.set_ylabel("energy, dB")


def _draw_threshold(row: Axes, height: float, label: str) -> None:
    row.axhline(height, color=THRESHOLD, linewidth=1, linestyle="--")
    row.annotate(label, (1, height), xycoords=("axes fraction", "data"), ha="right", va="bottom", color=THRESHOLD)


def _draw_stress(row: Axes, words: tuple[Word, ...]) -> None:
    """Two bars a word."""
    measures = (("stressed ratio", THRESHOLD, 0.05), ("prominence", LINE, 0.5))
    for name, colour, left in measures:
        pairs = [(word.interval, getattr(word, name.replace(" ", "_"))) for word in words]
        known = [(interval, value) for interval, value in pairs if interval is not None and value is not None]
        starts_s = [interval.start_s + left * interval.duration_s for interval, _ in known]
        widths_s = [0.45 * interval.duration_s for interval, _ in known]
        row.bar(starts_s, [value for _, value in known], widths_s, align="edge", color=colour, label=name)
    row.set_ylim(0, 1)
    row.legend(loc="upper right", fontsize=8, ncols=2, frameon=False)
    row.set_ylabel("of the word")


def _draw_memberships(row: Axes, agitation: Agitation | None) -> None:
    """One bar, cut in three."""
    left = 0.0
    for level, colour in MEMBERSHIPS.items():
        share = float(getattr(agitation, level)) if agitation is not None else 0.0
        row.barh(0, share, left=left, color=colour, label=f"{level} {share:.2f}")
        left += share
    row.set_xlim(0, 1)
    row.set_xticks([])
    row.set_yticks([0], ["agitation"])
    row.legend(loc="upper center", bbox_to_anchor=(0.5, -0.05), ncols=3, fontsize=9, frameon=False)


def _mark_emphasis(rows: list[Axes], analysis: Analysis) -> None:
    """A band behind every emphasised word."""
    emphases = (each for each in analysis.functions if each.class_name == "emphasis" and each.kept)
    intervals = (analysis.utterance.words[each.first].interval for each in emphases)
    for interval in {interval for interval in intervals if interval is not None}:
        for row in rows:
            row.axvspan(interval.start_s, interval.end_s, color=EMPHASIS, alpha=0.6, linewidth=0, zorder=0)


def _times_s(contours: Contours) -> FloatArray:
    times_s: FloatArray = np.arange(len(contours.f0_hz), dtype=np.float64) * FRAME_SHIFT_S
    return times_s

"""Draws an analysis for visual inspection: the measurements of the signal, and the values derived from them.

From top to bottom, on one time axis: the words and phones, the waveform, f0 and energy with the thresholds above which
a frame is stressed (paper §3.1.5), and each word's stressed ratio, prominence and emphasis; at the bottom, for the
whole line, the memberships of agitation. Stressed frames are red, words that are emphasised by the chosen measure are
on a band. Needs matplotlib, an extra: `pip install '.[plot]'`.
"""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...errors import InputError, ServiceError
from ...model import (
    EMPHASISED,
    FRAME_SHIFT_S,
    SAMPLE_RATE_HZ,
    Agitation,
    Contours,
    FloatArray,
    Interval,
    StressThresholds,
    Word,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ...model import Analysis, SignalAnalysis

FORMAT = ".png"
INCHES_PER_S = 1.7
NARROWEST_INCHES, WIDEST_INCHES = 11.0, 200.0
HEIGHT_INCHES = 9.0
DOTS_PER_INCH = 100
LINE, THRESHOLD, EMPHASIS, FAINT = "#1f4e79", "#c0392b", "#f2c078", "#9aa5b1"
BAND = "#d68910"
"""The colour of emphasis as a bar, darker than as a band."""
ENERGY_RANGE_DB = 70.0
"""The range shown below the loudest frame; with fainter frames the rest would look flat."""

BAR_S = 0.05
MEMBERSHIP_INCHES = 4.0
"""The length of a membership of 1."""

MEMBERSHIPS = {"low": "#7fb3d5", "medium": "#a9cf9e", "high": "#e59866"}


def require_plot(name: str) -> None:
    """Raises InputError `plot_format` and ServiceError `plot_unavailable`, so that no work is wasted."""
    if Path(name).suffix.lower() != FORMAT:
        raise InputError("plot_format", f"{name}: pictures are PNG; end the name in {FORMAT}", field="plot")
    try:
        import matplotlib.figure  # noqa: F401
    except ModuleNotFoundError:
        raise ServiceError(
            "plot_unavailable", "pictures need matplotlib, which is not installed: pip install '.[plot]'"
        ) from None


def plot(analysis: Analysis, heard: SignalAnalysis) -> bytes:
    """The picture, as PNG; matplotlib must be installed (`require_plot`)."""
    from matplotlib.figure import Figure

    width = float(np.clip(INCHES_PER_S * heard.audio.duration_s, NARROWEST_INCHES, WIDEST_INCHES))
    figure = Figure(figsize=(width, HEIGHT_INCHES), layout="constrained")
    rows = figure.subplots(6, 1, height_ratios=(1.1, 1.3, 2, 2, 1.5, 0.6))
    for row in rows[1:5]:
        row.sharex(rows[0])
    _draw(rows, analysis, heard)
    _mark_emphasis(rows[:5], analysis.utterance.words)
    rows[0].set_xlim(0, heard.audio.duration_s)
    rows[5].set_xlim(0, width / MEMBERSHIP_INCHES)
    content = io.BytesIO()
    figure.savefig(content, format="png", dpi=DOTS_PER_INCH)
    return content.getvalue()


def _draw(rows: list[Axes], analysis: Analysis, heard: SignalAnalysis) -> None:
    utterance = analysis.utterance
    _draw_words(rows[0], utterance.words)
    _draw_waveform(rows[1], heard.audio.samples)
    _draw_f0(rows[2], heard.contours, utterance.thresholds)
    _draw_energy(rows[3], heard.contours, utterance.thresholds)
    _draw_measures(rows[4], utterance.words)
    _draw_memberships(rows[5], utterance.agitation)
    for row in rows[:4]:
        row.tick_params(labelbottom=False)
    rows[4].set_xlabel("seconds")
    for row in rows:
        row.spines[["top", "right"]].set_visible(False)


def _draw_words(row: Axes, words: tuple[Word, ...]) -> None:
    """A box for each word, and below it one for each phone; labels alternate between two heights so that they do not
    touch."""
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
    """The range of the samples in each frame: as much as can be seen, and quick for a long line."""
    hop = round(FRAME_SHIFT_S * SAMPLE_RATE_HZ) // 4
    frames = np.resize(np.pad(samples, (0, -len(samples) % hop)), (-(-len(samples) // hop), hop))
    times_s = (np.arange(len(frames)) + 0.5) * hop / SAMPLE_RATE_HZ
    row.fill_between(times_s, frames.min(axis=1), frames.max(axis=1), color=LINE, linewidth=0)
    row.set_ylabel("waveform")


def _draw_f0(row: Axes, contours: Contours, thresholds: StressThresholds | None) -> None:
    voiced_hz = np.where(contours.f0_hz > 0, contours.f0_hz, np.nan)
    row.plot(_times_s(contours.f0_hz), voiced_hz, color=LINE, marker=".", markersize=3, linewidth=1)
    if thresholds is not None and thresholds.f0_hz is not None:
        _draw_stressed(row, voiced_hz, thresholds.f0_hz, f"{thresholds.f0_hz:.0f} Hz")
    row.set_ylabel("f0, Hz")


def _draw_energy(row: Axes, contours: Contours, thresholds: StressThresholds | None) -> None:
    row.plot(_times_s(contours.f0_hz), contours.energy_db, color=LINE, linewidth=1)
    if thresholds is not None:
        _draw_stressed(row, contours.energy_db, thresholds.energy_db, f"{thresholds.energy_db:.1f} dB")
    loudest_db = float(contours.energy_db.max())
    row.set_ylim(max(float(contours.energy_db.min()), loudest_db - ENERGY_RANGE_DB) - 3, loudest_db + 6)
    row.set_ylabel("energy, dB")


def _draw_stressed(row: Axes, contour: FloatArray, height: float, label: str) -> None:
    """The threshold, and the part of the contour above it."""
    row.plot(_times_s(contour), np.where(contour > height, contour, np.nan), color=THRESHOLD, linewidth=2)
    row.axhline(height, color=THRESHOLD, linewidth=1, linestyle="--")
    row.annotate(label, (1, height), xycoords=("axes fraction", "data"), ha="right", va="bottom", color=THRESHOLD)


def _draw_measures(row: Axes, words: tuple[Word, ...]) -> None:
    """Three bars a word, and the threshold of emphasis."""
    measures = (("stressed ratio", THRESHOLD), ("prominence", LINE), ("emphasis", BAND))
    for place, (name, colour) in enumerate(measures):
        pairs = [(word.interval, getattr(word, name.replace(" ", "_"))) for word in words]
        known = [(interval, value) for interval, value in pairs if interval is not None and value is not None]
        widths_s = np.array([min(BAR_S, interval.duration_s / len(measures)) for interval, _ in known])
        middles_s = np.array([(interval.start_s + interval.end_s) / 2 for interval, _ in known])
        row.bar(middles_s + (place - 1) * widths_s, [value for _, value in known], widths_s, color=colour, label=name)
    row.axhline(EMPHASISED, color=BAND, linewidth=1, linestyle="--")
    row.set_ylim(0, 1)
    row.legend(loc="lower right", bbox_to_anchor=(1, 0.98), fontsize=9, ncols=3, frameon=False, borderaxespad=0)
    row.set_ylabel("of the word")


def _draw_memberships(row: Axes, agitation: Agitation | None) -> None:
    """A bar for each level, the highest on top, with its value."""
    if agitation is not None:
        for height, (level, colour) in enumerate(MEMBERSHIPS.items()):
            share = float(getattr(agitation, level))
            row.barh(height, share, color=colour)
            row.text(share, height, f" {share:.2f}", va="center", fontsize=9)
    row.spines["bottom"].set_visible(False)
    row.set_xticks([])
    row.set_yticks(range(len(MEMBERSHIPS)), [f"agitation {level}" for level in MEMBERSHIPS], fontsize=9)


def _mark_emphasis(rows: list[Axes], words: tuple[Word, ...]) -> None:
    """A band behind every emphasised word."""
    for interval in [word.interval for word in words if word.interval is not None and word.is_emphasised]:
        for row in rows:
            row.axvspan(interval.start_s, interval.end_s, color=EMPHASIS, alpha=0.6, linewidth=0, zorder=0)


def _times_s(contour: FloatArray) -> FloatArray:
    times_s: FloatArray = np.arange(len(contour), dtype=np.float64) * FRAME_SHIFT_S
    return times_s

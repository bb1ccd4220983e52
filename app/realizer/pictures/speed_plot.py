"""Plots wrist speeds of both hands with gesture phases and words, to judge gestures by eye.

Conventions: speeds are metres per second in the world, low-pass filtered at 6 Hz like the recordings they are compared
with (docs/references.md). Needs matplotlib, the extra `understudy[plot]`; command line and HTTP API check for it.
"""

from __future__ import annotations

import io
from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from ...model import Channel, FloatArray, Hand, Schedule, SyncPoints
from ..body.motion import Motion
from ..body.skeleton import SIDES, Skeleton, forward

if TYPE_CHECKING:
    from matplotlib.axes import Axes

INCHES_PER_S = 1.4
NARROWEST_INCHES, WIDEST_INCHES = 9.0, 200.0
HEIGHT_INCHES = 5.2
DOTS_PER_INCH = 100
LOW_PASS_HZ = 6.0
HIGHEST_USUAL_M_S = 2.0
"""The 99th percentile of people's wrist speeds (docs/references.md), drawn as a line."""

PHASES: Mapping[str, tuple[str, str, str]] = MappingProxyType(
    {
        "preparation": ("start", "stroke_start", "#cfe3f2"),
        "stroke": ("stroke_start", "stroke_end", "#f5b971"),
        "hold": ("stroke_end", "relax", "#d8e8c8"),
        "retraction": ("relax", "end", "#e4e4e4"),
    }
)
LINE, LIMIT, WORD = "#1f4e79", "#c0392b", "#9aa5b1"


def draw_speeds(motion: Motion, skeleton: Skeleton, schedule: Schedule) -> bytes:
    """The plot as PNG: a row for each hand above a row of words."""
    from matplotlib.figure import Figure
    from matplotlib.patches import Patch

    width = float(np.clip(INCHES_PER_S * motion.duration_s, NARROWEST_INCHES, WIDEST_INCHES))
    figure = Figure(figsize=(width, HEIGHT_INCHES), layout="constrained")
    rows = figure.subplots(3, 1, sharex=True, height_ratios=(3, 3, 0.7))
    speeds = wrist_speeds_m_s(motion, skeleton)
    highest = max(HIGHEST_USUAL_M_S * 1.1, float(speeds.max()) * 1.05)
    patches = [Patch(color=colour, label=phase) for phase, (_start, _end, colour) in PHASES.items()]
    figure.legend(handles=patches, loc="outside upper right", ncols=len(patches), fontsize=8, frameon=False)
    for row, side, speed in zip(rows, SIDES, speeds.T, strict=False):
        _draw_phases(row, motion, schedule, Hand(side))
        row.plot(motion.body.times_s, speed, color=LINE, linewidth=1.2)
        row.axhline(HIGHEST_USUAL_M_S, color=LIMIT, linewidth=0.8, linestyle="--")
        row.set_ylim(0, highest)
        row.set_ylabel(f"{side} wrist, m/s")
    _draw_words(rows[2], schedule)
    rows[2].set_xlim(motion.body.times_s[0], motion.body.times_s[-1])
    content = io.BytesIO()
    figure.savefig(content, format="png", dpi=DOTS_PER_INCH)
    return content.getvalue()


def wrist_speeds_m_s(motion: Motion, skeleton: Skeleton) -> FloatArray:
    """The speeds (T, 2) of the left and the right wrist."""
    wrists = [skeleton.index[f"{side}Hand"] for side in SIDES]
    above = frozenset(joint for wrist in wrists for joint in _up_from(skeleton, wrist))
    places, _turns = forward(skeleton, motion.body.rotations, motion.body.hips_m, above)
    smoothed = _low_passed(places[:, wrists], motion.frame_rate_hz)
    velocities = np.gradient(smoothed, 1 / motion.frame_rate_hz, axis=0) if len(smoothed) > 1 else 0 * smoothed
    return np.asarray(np.linalg.norm(velocities, axis=-1))


def _up_from(skeleton: Skeleton, joint: int) -> list[int]:
    return [] if joint < 0 else [joint, *_up_from(skeleton, skeleton.parents[joint])]


def _low_passed(places_m: FloatArray, frame_rate_hz: int) -> FloatArray:
    """Second-order Butterworth low-pass, forward and backward; motions that are too short are returned unfiltered."""
    from scipy.signal import butter, sosfiltfilt

    if len(places_m) <= 9 or frame_rate_hz <= 2 * LOW_PASS_HZ:
        return places_m
    return np.asarray(sosfiltfilt(butter(2, LOW_PASS_HZ, fs=frame_rate_hz, output="sos"), places_m, axis=0))


def _draw_phases(row: Axes, motion: Motion, schedule: Schedule, hand: Hand) -> None:
    """The realized phases of this hand's gestures, each with its lexeme."""
    for behavior in schedule.behaviors:
        sync = motion.realized.get(behavior.id)
        if behavior.kind is not Channel.GESTURE or sync is None or behavior.hand not in {hand, Hand.BOTH, None}:
            continue
        for start, end, colour in PHASES.values():
            start_s, end_s = _point_s(sync, start), _point_s(sync, end)
            if start_s is not None and end_s is not None:
                row.axvspan(start_s, end_s, color=colour, linewidth=0)
        stroke_s = _point_s(sync, "stroke")
        if stroke_s is not None:
            row.axvline(stroke_s, color=LIMIT, linewidth=0.6)
            row.text(stroke_s, 0.97, behavior.lexeme, transform=row.get_xaxis_transform(), fontsize=7, va="top")


def _point_s(sync: SyncPoints, point: str) -> float | None:
    found: float | None = getattr(sync, point)
    return found


def _draw_words(row: Axes, schedule: Schedule) -> None:
    """A box for each word; labels alternate between two heights so that neighbours do not touch."""
    for word in schedule.words:
        if word.interval is None:
            continue
        row.broken_barh(
            [(word.interval.start_s, word.interval.duration_s)], (0, 1), facecolor="none", edgecolor=WORD, linewidth=0.6
        )
        middle_s = (word.interval.start_s + word.interval.end_s) / 2
        height = 0.7 if word.index % 2 == 0 else 0.3
        row.text(middle_s, height, word.text, ha="center", va="center", fontsize=8, clip_on=True)
    row.set_ylim(0, 1)
    row.set_yticks([])
    row.set_xlabel("seconds")

"""Makes clips from gesture definitions: one level of agitation, one hand or both, times in seconds.

The seven markers (paper §3.8, Table 3) come from the frames. Missing ones are derived: without `ready` there is no
pre-stroke hold; without `stroke` the emphasis is at `EMPHASIS` of the stroke; without `relax` the post-stroke hold
lasts until the last `hold` frame, or there is none.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ...model import Hand, Level
from ...model.figure import GestureManner
from .gesture import ArmKey, Clip, ClipKey, Definition, Expressivity, Frame, FrameType, Markers
from .gesture_space import sector_m

EMPHASIS = 0.61
"""Where speakers put the emphasis within a stroke, as a share of its duration (docs/references.md)."""

LEADING = Hand.RIGHT
"""The leading hand of a two-handed gesture, whose keys come first in its file."""


def clip(definition: Definition, level: Level, hand: Hand, category: str) -> Clip:
    """The gesture as made by `hand`. One-handed definitions are mirrored for the left or for both hands; of two-handed
    ones, a single hand plays the leading hand's part. Raises KeyError for a level that the definition does not suit."""
    expressivity = _in_manner(definition.levels[level], definition.manner)
    scale_s = definition.duration_s / expressivity.tempo
    markers = relative_markers(definition.frames)
    in_seconds = Markers(*(scale_s * getattr(markers, name) for name in Markers.__slots__))
    return Clip(
        name=definition.name,
        category=category,
        level=level,
        hand=hand,
        markers=in_seconds,
        keys=tuple(_key(frame, hand, scale_s) for frame in definition.frames),
        expressivity=expressivity,
        stroke_speed_m_s=_stroke_speed_m_s(definition.frames, markers, expressivity, scale_s),
        aimed=definition.aimed,
        tracks=definition.tracks,
        manner=definition.manner,
    )


def _in_manner(expressivity: Expressivity, manner: GestureManner) -> Expressivity:
    return replace(
        expressivity, amplitude=expressivity.amplitude * manner.space, tempo=expressivity.tempo * manner.pace
    )


def relative_markers(frames: Sequence[Frame]) -> Markers:
    """The markers as fractions 0 … 1 of the gesture; `frames` must have passed the checks."""
    at: dict[FrameType, float] = {frame.type: frame.time for frame in frames}
    strokes = [frame.time for frame in frames if frame.type is FrameType.STROKE]
    stroke_end = at.get(FrameType.STROKE_END, strokes[-1] if strokes else 1.0)
    stroke_start = at.get(FrameType.STROKE_START, _before_the_stroke(frames))
    emphasis = stroke_start + EMPHASIS * (stroke_end - stroke_start)
    last = frames[-1].time
    return Markers(
        start=0.0,
        ready=at.get(FrameType.READY, stroke_start),
        stroke_start=stroke_start,
        stroke=min(strokes, key=lambda time: abs(time - emphasis), default=emphasis),
        stroke_end=stroke_end,
        relax=at.get(FrameType.RELAX, at.get(FrameType.HOLD, stroke_end)),
        end=at.get(FrameType.END, last),
    )


def _before_the_stroke(frames: Sequence[Frame]) -> float:
    """The start of the stroke when no frame marks it: the last frame before the stroke's poses."""
    poses = {FrameType.STROKE, FrameType.STROKE_END}
    first = next(position for position, frame in enumerate(frames) if frame.type in poses)
    return frames[max(first - 1, 0)].time


def _key(frame: Frame, hand: Hand, scale_s: float) -> ClipKey:
    """Keys are relative to their own arm, so the mirror image is the same key on the other side."""
    arms: dict[Hand, ArmKey] = {LEADING: frame.leading, Hand.LEFT: frame.other or frame.leading}
    if hand is not Hand.BOTH:
        arms = {hand: frame.leading}
    return ClipKey(
        frame.time * scale_s, frame.type, arms.get(Hand.LEFT), arms.get(Hand.RIGHT), frame.noise, frame.curve
    )


def _stroke_speed_m_s(frames: Sequence[Frame], markers: Markers, expressivity: Expressivity, scale_s: float) -> float:
    """The mean speed of the leading hand along straight lines between its places. A frame without a place is
    interpolated between its neighbours."""
    placed = [(frame.time, frame.leading.place) for frame in frames if frame.leading.place is not None]
    if not placed:
        return 0.0
    known = np.array([sector_m(place, expressivity.amplitude) for _, place in placed if place is not None])
    inner = [time for time, _ in placed if markers.stroke_start < time < markers.stroke_end]
    times = [markers.stroke_start, *inner, markers.stroke_end]
    way = np.stack([np.interp(times, [time for time, _ in placed], known[:, axis]) for axis in range(3)], axis=-1)
    length_m = sum(float(np.linalg.norm(after - before)) for before, after in pairwise(way))
    return length_m / ((markers.stroke_end - markers.stroke_start) * scale_s)

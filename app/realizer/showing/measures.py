"""The key poses that show a height, a size or a number as it is: a palm at that height, palms that far apart, fingers.

Conventions: metres from the hips of the upright body, x to the arm's own side, y up, z away
(`understudy.realizer.gestures.gesture_space`); heights and lengths of things as the words have them.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Hand, Manner
from ...model.slots import Side, Slots
from ..body.skeleton import HIPS_HEIGHT_M
from ..gestures.gesture import (
    ArmKey,
    Bend,
    Clip,
    ClipKey,
    Depth,
    Finger,
    FrameType,
    HandDirection,
    HandForm,
    HandShape,
    HeightSector,
    SectorPlace,
    Sideways,
    Thumb,
    Wrist,
)
from ..gestures.gesture_plan import USUAL_MANNER
from ..gestures.gesture_space import offset_from_centre_m, sector_m

Point = tuple[float, float, float]

TINY_M = 0.03
"""The greatest size that is shown between two fingers of one hand."""

_CENTRE = SectorPlace(Sideways.C, HeightSector.CC, Depth.MIDDLE)

_PALM_M = 0.02
"""A flat hand's palm is so far below the wrist's joint, and two palms that face each other before theirs."""
_LEAST_APART_M, _MOST_APART_M = 0.074, 1.10
"""Between two wrists, with the hands' thickness and the arms' length."""
_LOWEST_M, _HIGHEST_M = -0.06, 0.96
"""The wrist's height, of a hand beside the thigh and of one stretched up."""
_MOST_M_S = 1.0
"""The fastest mean speed of a stroke to a place."""
_NEAREST_M: FloatArray = np.array([0.02, -0.02, 0.19])
_NEAREST_M.setflags(write=False)
"""A hand that draws back stays on its side, above the hips and in front of the body."""
_STROKE_M = 0.16
"""The way of the stroke to a height."""
_HEIGHTS_M = (-0.1, 0.25, 0.60, 0.95)
_ASIDE_M, _AHEAD_M = (0.34, 0.32, 0.30, 0.22), (0.22, 0.30, 0.28, 0.14)
"""How far aside and ahead a palm is that shows each of these heights."""

_SPREAD = HandShape(HandForm.SPREAD, Thumb.ACROSS)
SHAPES: Mapping[int, tuple[HandShape, tuple[tuple[Finger, Bend], ...]]] = MappingProxyType(
    {
        1: (HandShape(HandForm.INDEX), ()),
        2: (HandShape(HandForm.TWO_APART), ()),
        3: (HandShape(HandForm.TWO_APART), ((Finger.RING, Bend.STRAIGHT),)),
        4: (_SPREAD, ()),
        5: (HandShape(HandForm.SPREAD, Thumb.OUT), ()),
    }
)
"""The hand that shows each number."""


@dataclass(frozen=True, slots=True)
class StrokeEnds:
    """Where a hand is at the start and the end of a stroke, and how it is held."""

    start_m: Point
    end_m: Point
    hand: HandShape
    wrist: Wrist


def at_height(height_m: float) -> StrokeEnds:
    """A palm, face down, so high above the floor as far as the arm reaches; lower than the elbow it comes from above,
    else from below."""
    up_m = min(max(height_m - HIPS_HEIGHT_M + _PALM_M, _LOWEST_M), _HIGHEST_M)
    aside_m, ahead_m = (float(np.interp(up_m, _HEIGHTS_M, table)) for table in (_ASIDE_M, _AHEAD_M))
    from_m = up_m + (_STROKE_M if up_m < _HEIGHTS_M[1] else -_STROKE_M)
    held = Wrist(frozenset({HandDirection.AWAY}), frozenset({HandDirection.DOWN}))
    return StrokeEnds((aside_m, from_m, ahead_m), (aside_m, up_m, ahead_m), HandShape(HandForm.FLAT), held)


def apart(size_m: float) -> StrokeEnds:
    """Either of two palms that face each other so far apart. Palms that show something small come from near by, not
    from a wide opening."""
    out_m = min(max(size_m + 2 * _PALM_M, _LEAST_APART_M), _MOST_APART_M) / 2
    from_m = out_m + 0.10 if out_m < 0.15 else 0.4 * out_m
    ahead_m = float(np.interp(out_m, (0.1, 0.55), (0.34, 0.20)))
    held = Wrist(frozenset({HandDirection.AWAY}), frozenset({HandDirection.INWARDS}))
    hand = HandShape(HandForm.FLAT, Thumb.OPEN)
    return StrokeEnds((from_m, 0.20, ahead_m - 0.02), (out_m, 0.25, ahead_m), hand, held)


def between_fingers() -> StrokeEnds:
    """Something tiny between thumb and index finger, held up where it is seen."""
    held = Wrist(frozenset({HandDirection.AWAY, HandDirection.UP}), frozenset({HandDirection.INWARDS}))
    return StrokeEnds((0.24, 0.20, 0.26), (0.19, 0.36, 0.33), HandShape(HandForm.PINCH_OPEN), held)


def measuring(clip: Clip, slots: Slots) -> Clip:
    """The clip with the poses that show the height or the size of the slots, at its own times; unchanged where they
    say neither."""
    pose = _pose(slots, both=clip.hand is Hand.BOTH)
    if pose is None:
        return clip
    start_s, end_s = clip.markers.stroke_start, clip.markers.stroke_end
    keys = (
        _key(clip, start_s, FrameType.STROKE_START, ArmKey(_place(pose.start_m), pose.hand, wrist=pose.wrist)),
        _key(clip, end_s, FrameType.STROKE_END, ArmKey(_place(pose.end_m), pose.hand, wrist=pose.wrist)),
        _key(clip, clip.markers.end, FrameType.END, ArmKey()),
    )
    way_m = float(np.linalg.norm(np.subtract(pose.end_m, pose.start_m)))
    as_it_is = replace(clip.expressivity, amplitude=1.0)
    return replace(clip, keys=keys, expressivity=as_it_is, stroke_speed_m_s=way_m / (end_s - start_s), tracks=())


def _pose(slots: Slots, *, both: bool) -> StrokeEnds | None:
    if slots.height_m is not None and not both:
        return at_height(slots.height_m)
    if slots.size_m is not None and both:
        return apart(slots.size_m)
    if slots.size_m is not None and slots.size_m <= TINY_M:
        return between_fingers()
    return None


def counting(clip: Clip, count: int) -> Clip:
    """The clip with as many fingers at the end of its stroke; from six on, five on the leading hand and the rest on the
    other."""
    leading, other = min(count, 5), max(count - 5, 1)
    keys = tuple(
        replace(
            key,
            right=_with_fingers(key.right, leading),
            left=_with_fingers(key.left, other if clip.hand is Hand.BOTH else leading),
        )
        if clip.markers.stroke_end <= key.time_s < clip.markers.end
        else key
        for key in clip.keys
    )
    return replace(clip, keys=keys)


def _with_fingers(arm: ArmKey | None, count: int) -> ArmKey | None:
    if arm is None or arm.hand is None:
        return arm
    hand, fingers = SHAPES[count]
    return replace(arm, hand=hand, fingers=fingers)


def _key(clip: Clip, time_s: float, kind: FrameType, arm: ArmKey) -> ClipKey:
    left, right = (arm if clip.hand in (side, Hand.BOTH) else None for side in (Hand.LEFT, Hand.RIGHT))
    return ClipKey(time_s, kind, left, right)


def _place(point_m: Point) -> SectorPlace:
    return replace(_CENTRE, offset_m=offset_from_centre_m(np.asarray(point_m), 1.0))


def stretched(clip: Clip, amplitude: float) -> Clip:
    """A pointing clip whose stroke ends with a nearly straight arm at that amplitude."""
    return replace(clip, keys=_at_the_end(clip, lambda arm: _moved(arm, lambda _point_m: _STRETCHED_M, amplitude)))


_STRETCHED_M: FloatArray = np.array([0.17, 0.43, 0.56])
"""Farther from the shoulder of an arm at rest than it is long: the shoulder goes forward with the arm."""


def placed_aside(clip: Clip, side: Side, amplitude: float, manner: Manner = USUAL_MANNER) -> Clip:
    """The clip of one hand with its stroke ending on that side of the body: far enough aside that what is put on the
    one side and what on the other are apart. It comes from as far as the `manner` has it."""
    own = (clip.hand is Hand.LEFT) == (side is Side.LEFT)
    if side not in (Side.LEFT, Side.RIGHT):
        return clip

    def aside(point_m: FloatArray) -> FloatArray:
        x, y, z = point_m
        return np.array([max(x, 0.40), y, min(z, 0.30)] if own else [min(x, -0.08), y, min(z, 0.32)])

    keys = _at_the_end(clip, lambda arm: _moved(arm, aside, amplitude))
    moved = replace(clip, keys=keys)
    ends_m = _ends_m(moved, amplitude)
    return begun_in_time(moved, ends_m, amplitude, manner)


def begun_in_time(
    clip: Clip, ends_m: Mapping[Hand, FloatArray], amplitude: float, manner: Manner = USUAL_MANNER
) -> Clip:
    """The clip with its stroke begun as near to where it ends, `ends_m` by arm, as it must be not to be too fast. Where
    the end is as the words say, a bigger voice has the hand come from as much farther, and a smaller one from nearer:
    the `manner` in which the clip is already but for its size."""
    most_m = _MOST_M_S * manner.speed * (clip.markers.stroke_end - clip.markers.stroke_start)

    def begun(point_m: FloatArray, end_m: FloatArray) -> FloatArray:
        from_m = end_m + manner.amplitude * _at_most(point_m - end_m, most_m)
        return np.maximum(from_m, np.minimum(point_m, _NEAREST_M)) if manner.amplitude > 1 else from_m

    def nearer(arm: ArmKey | None, side: Hand) -> ArmKey | None:
        end_m = ends_m.get(side)
        return arm if end_m is None else _moved(arm, lambda point_m: begun(point_m, end_m), amplitude)

    begins = clip.markers.ready, clip.markers.stroke_end
    keys = tuple(
        key.of(nearer(key.left, Hand.LEFT), nearer(key.right, Hand.RIGHT))
        if begins[0] <= key.time_s < begins[1]
        else key
        for key in clip.keys
    )
    return replace(clip, keys=keys)


def _ends_m(clip: Clip, amplitude: float) -> Mapping[Hand, FloatArray]:
    """Where the stroke of each arm ends."""
    found: dict[Hand, FloatArray] = {}
    for key in clip.keys:
        for side, arm in ((Hand.LEFT, key.left), (Hand.RIGHT, key.right)):
            if key.time_s <= clip.markers.stroke_end and arm is not None and arm.place is not None:
                found[side] = sector_m(arm.place, amplitude)
    return found


def _at_the_end(clip: Clip, made: Callable[[ArmKey | None], ArmKey | None]) -> tuple[ClipKey, ...]:
    """The keys of a clip, those from the end of its stroke until it relaxes as `made`."""
    ends = clip.markers.stroke_end, clip.markers.end
    return tuple(
        key.of(made(key.left), made(key.right)) if ends[0] <= key.time_s < ends[1] else key for key in clip.keys
    )


def _moved(arm: ArmKey | None, moved: Callable[[FloatArray], FloatArray], amplitude: float) -> ArmKey | None:
    """The key with its place moved, as it is at that amplitude."""
    if arm is None or arm.place is None:
        return arm
    offset_m = offset_from_centre_m(moved(sector_m(arm.place, amplitude)), amplitude)
    return arm.at(_CENTRE.offset_by(offset_m))


def _at_most(way_m: FloatArray, longest_m: float) -> FloatArray:
    return np.asarray(way_m * min(1.0, longest_m / max(float(np.linalg.norm(way_m)), 1e-6)))

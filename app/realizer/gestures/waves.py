"""Waves: strokes of a raised hand that swing to and fro, and go on swinging while the hand is up.

A wave that is made smaller and faster, as other strokes are where there is no time, is no wave any more. It is made
shorter by whole swings instead, and the swings that are missing follow in the hold.
"""

from dataclasses import replace

from .gesture import ArmKey, Clip, ClipKey, FrameType

_WAVED = frozenset({"GREETING", "FAREWELL"})
_LEAST_TURNS = 2
"""Keys inside the stroke of a wave, at which the hand turns back; a stroke that goes one way in an arc has one."""


def waves(clip: Clip) -> bool:
    """Whether the stroke swings to and fro, or is the last swing of one that does."""
    return clip.cut_wave or (clip.category in _WAVED and len(_turns(clip)) >= _LEAST_TURNS)


def last_swing(clip: Clip) -> Clip:
    """A wave that begins with its last swing, with the hand raised."""
    marks, turn = clip.markers, _turns(clip)[-1]
    since_s = turn.time_s - marks.stroke_start
    first = next((key for key in clip.keys if key.type is FrameType.STROKE_START), turn)
    left, right = _shaped_as(first.left, turn.left), _shaped_as(first.right, turn.right)
    begins = ClipKey(marks.stroke_start, FrameType.STROKE_START, left, right, noise=turn.noise, curve=turn.curve)
    before = (key for key in clip.keys if key.time_s < marks.stroke_start)
    after = (replace(key, time_s=key.time_s - since_s) for key in clip.keys if key.time_s > turn.time_s)
    ends = {name: getattr(marks, name) - since_s for name in ("stroke_end", "relax", "end")}
    markers = replace(marks, stroke=max(marks.stroke_start, marks.stroke - since_s), **ends)
    return replace(clip, keys=(*before, begins, *after), markers=markers, cut_wave=True)


def _turns(clip: Clip) -> list[ClipKey]:
    begins_s, ends_s = clip.markers.stroke_start, clip.markers.stroke_end
    return [key for key in clip.keys if begins_s < key.time_s < ends_s]


def _shaped_as(first: ArmKey | None, later: ArmKey | None) -> ArmKey | None:
    """The later key of an arm with the hand of the first, which it does not say again."""
    if first is None or later is None or later.hand is not None:
        return later
    return replace(later, hand=first.hand, fingers=first.fingers)

"""Clips changed for a performance: made brief where there is no time for the whole stroke, and in the voice's manner.

The paper does not time-warp strokes and drops a gesture that has no time (§3.8). People whose ideas crowd make less of
each: here a brief stroke begins nearer to where it ends and is no faster, so that hands have no more to do than
in a whole one. How much is left is in `understudy.model.limits`, by which schedules are made. A waving hand
(lexicon/movement.yaml) would no longer wave then: its stroke is shortened by whole swings, which follow in the hold.

In a manner, speed shortens or lengthens the stroke and what goes before and after it alike; tension makes the stroke
stop sharply (power) and its path through the keys less smooth (Gesture Engine §5.2). The size is the request's.
"""

from dataclasses import replace

from ...model import Hand, Manner
from ...model.limits import brief_share
from .gesture import ArmKey, Clip, ClipKey, Expressivity, FrameType, Markers, SectorPlace
from .gesture_space import sector_m


def brief(clip: Clip) -> Clip:
    """The clip with the last part of its stroke's way only, in the same part of its time; what comes before and after
    lasts as long as before."""
    markers = clip.markers
    share = brief_share(markers.stroke_end - markers.stroke_start)
    ends = {side: _end(clip, side) for side in (Hand.LEFT, Hand.RIGHT)}
    keys = tuple(
        key.at(in_less_time(markers, key.time_s, share)).of(
            _nearer(key.left, ends[Hand.LEFT], share) if _is_before_the_end(markers, key) else key.left,
            _nearer(key.right, ends[Hand.RIGHT], share) if _is_before_the_end(markers, key) else key.right,
        )
        for key in clip.keys
    )
    times_s = (in_less_time(markers, getattr(markers, name), share) for name in Markers.__slots__)
    return replace(clip, markers=Markers(*times_s), keys=keys)


def in_less_time(markers: Markers, time_s: float, share: float) -> float:
    """A time in a clip, in the same clip with that share of its stroke's time."""
    in_stroke_s = min(max(time_s, markers.stroke_start), markers.stroke_end) - markers.stroke_start
    return time_s - (1 - share) * in_stroke_s


def _is_before_the_end(markers: Markers, key: ClipKey) -> bool:
    """Whether a key is where the hand waits for the stroke, or in the stroke."""
    return markers.ready <= key.time_s < markers.stroke_end


def _end(clip: Clip, side: Hand) -> SectorPlace | None:
    """Where a hand's stroke ends: its last place until then."""
    arms = (key.left if side is Hand.LEFT else key.right for key in clip.keys if key.time_s <= clip.markers.stroke_end)
    places = [arm.place for arm in arms if arm is not None and arm.place is not None]
    return places[-1] if places else None


def _nearer(arm: ArmKey | None, end: SectorPlace | None, share: float) -> ArmKey | None:
    """The key with its place that share of the way from the end."""
    if arm is None or arm.place is None or end is None:
        return arm
    x_m, y_m, z_m = end.offset_m + share * (sector_m(arm.place) - sector_m(end))
    return arm.at(end.offset_by((float(x_m), float(y_m), float(z_m))))


def last_swing(clip: Clip) -> Clip:
    """A wave that begins with its last swing, with the hand raised."""
    marks = clip.markers
    turn = [key for key in clip.keys if marks.stroke_start < key.time_s < marks.stroke_end][-1]
    since_s = turn.time_s - marks.stroke_start
    first = next((key for key in clip.keys if key.type is FrameType.STROKE_START), turn)
    left, right = _shaped_as(first.left, turn.left), _shaped_as(first.right, turn.right)
    begins = ClipKey(marks.stroke_start, FrameType.STROKE_START, left, right, noise=turn.noise, curve=turn.curve)
    before = (key for key in clip.keys if key.time_s < marks.stroke_start)
    after = (key.at(key.time_s - since_s) for key in clip.keys if key.time_s > turn.time_s)
    ends = {name: getattr(marks, name) - since_s for name in ("stroke_end", "relax", "end")}
    markers = replace(marks, stroke=max(marks.stroke_start, marks.stroke - since_s), **ends)
    return replace(clip, keys=(*before, begins, *after), markers=markers)


def _shaped_as(first: ArmKey | None, later: ArmKey | None) -> ArmKey | None:
    """The later key of an arm with the hand of the first, which it does not say again."""
    if first is None or later is None or later.hand is not None:
        return later
    return replace(later, hand=first.hand, fingers=first.fingers)


def mannered(clip: Clip, manner: Manner) -> Clip:
    """The clip in a manner, its amplitude apart."""
    if manner.speed == 1 and manner.tension == 1:
        return clip
    pace = 1 / manner.speed
    return replace(
        clip,
        markers=Markers(*(pace * getattr(clip.markers, name) for name in Markers.__slots__)),
        keys=tuple(key.at(pace * key.time_s) for key in clip.keys),
        expressivity=_tensed(clip.expressivity, manner.tension - 1),
        stroke_speed_m_s=clip.stroke_speed_m_s * manner.speed,
    )


def _tensed(expressivity: Expressivity, more: float) -> Expressivity:
    """With more power and less fluidity, both within their bounds."""
    return replace(
        expressivity,
        power=min(max(expressivity.power + 0.5 * more, 0.0), 1.0),
        fluidity=min(max(expressivity.fluidity - 0.3 * more, 0.0), 1.0),
    )

"""Selects clips for a schedule's gestures (paper §3.8, eq. 4 and 5).

A clip fits if the time from its stroke to its relax time is no longer than the request's (eq. 5). The paper's clips are
recordings, whose post-stroke hold can be extended but not cut. Ours hold a pose between two keys, so a clip whose hold
alone is too long is used if no other fits, with its hold cut; eq. 5 then requires only that the stroke ends by the
relax time. A clip whose stroke is longer than the schedule's is made with a brief one (`brief_strokes`). `TOLERANCE_S`
more is accepted, since schedules are made before the clip is known, end strokes on stressed vowels to the millisecond,
and may have no hold at all.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from math import inf, sqrt
from typing import Protocol

import numpy as np

from ...model import Behavior, Channel, Hand, Level, Schedule, SyncPoints
from ...model.limits import LATEST_S, is_brief, size_of
from ..body.motion import Decision
from ..gestures.brief_strokes import brief, last_swing, mannered
from ..gestures.gesture import Clip
from ..gestures.gesture_plan import USUAL_MANNER, AskedTimes, GestureRequest, PlacedGesture

_ROUNDING_S = 0.002
"""A stroke that is before the first frame by no more is not late: times of schedules are whole milliseconds."""
TOLERANCE_S = 0.1

_ASKED_BY_US = frozenset({"start"})
_STROKE = frozenset({"stroke_start", "stroke_end"})


class Clips(Protocol):
    """The interface that selection needs from the gesture library (`understudy.realizer.gestures.library`)."""

    def clips(self, category: str, level: Level, hand: Hand) -> tuple[Clip, ...]: ...

    def nearest(self, lexeme: str) -> str | None: ...


def requests_of(schedule: Schedule) -> tuple[GestureRequest, ...]:
    """The requests G_i for a schedule's kept gestures (eq. 4), in order of their strokes."""
    gestures = (each for each in schedule.behaviors if each.kept and each.kind is Channel.GESTURE)
    requests = (_request(gesture, schedule) for gesture in gestures)
    return tuple(sorted(requests, key=lambda request: (request.stroke_s, request.behavior)))


def _request(gesture: Behavior, schedule: Schedule) -> GestureRequest:
    """BML sync points are optional: without a stroke it is where the stroke ends, or where the gesture begins. The
    amount of a still body's gesture is that for which the schedule was made, times how little still the body is."""
    sync, lively, asked = gesture.sync, 1 - schedule.stillness, schedule.asked.get(gesture.id, _ASKED_BY_US)
    stroke_s = next((point for point in (sync.stroke, sync.stroke_end, sync.stroke_start) if point is not None), None)
    stroke_s = sync.start if stroke_s is None else stroke_s
    manner = gesture.manner or USUAL_MANNER
    relax_s = next((point for point in (sync.relax, sync.stroke_end) if point is not None), sync.end)
    return GestureRequest(
        behavior=gesture.id,
        category=gesture.lexeme,
        stroke_s=stroke_s,
        relax_s=max(relax_s, stroke_s),
        priority=gesture.priority,
        hand=gesture.hand or Hand.RIGHT,
        level=schedule.agitation,
        size=size_of(lively and gesture.amount and gesture.amount / lively) * manner.amplitude,
        scale=sqrt(lively),
        curved=gesture.curved,
        target=gesture.target,
        longest_stroke_s=_longest_stroke_s(sync),
        after_strokes_s=gesture.after_strokes_s,
        manner=manner,
        slots=gesture.slots,
        way=gesture.way,
        asked=_asked_times(sync, asked),
    )


def _asked_times(sync: SyncPoints, asked: frozenset[str]) -> AskedTimes:
    times_s = dict(sync.in_order())
    points = {f"{name}_s": times_s.get(name) for name in ("start", "ready", "relax", "end") if name in asked}
    return AskedTimes(stroke_s=_longest_stroke_s(sync) if asked >= _STROKE else None, **points)


def _longest_stroke_s(sync: SyncPoints) -> float:
    if sync.stroke_start is None or sync.stroke_end is None:
        return inf
    return sync.stroke_end - sync.stroke_start


def in_the_time(clip: Clip, request: GestureRequest) -> Clip:
    """The clip in the manner of the request, with a brief stroke where the schedule has no time for the whole. A slow
    manner is left out where there is no time for it."""
    slower = mannered(clip, request.manner)
    unhurried = slower.markers.stroke_end - slower.markers.stroke_start <= request.longest_stroke_s
    if request.manner.speed >= 1 or (unhurried and fits_without_hold(slower, request)):
        clip = slower
    else:
        clip = mannered(clip, replace(request.manner, speed=1.0))
    stroke_s = clip.markers.stroke_end - clip.markers.stroke_start
    if not is_brief(stroke_s, request.longest_stroke_s):
        return clip
    return last_swing(clip) if clip.waves else brief(clip)


def fits(clip: Clip, request: GestureRequest) -> bool:
    """Eq. 5: t_rl - t_st <= t_grl - t_gst."""
    return clip.markers.relax - clip.markers.stroke <= request.relax_s - request.stroke_s + TOLERANCE_S


def fits_without_hold(clip: Clip, request: GestureRequest) -> bool:
    """Eq. 5 with the clip's hold cut: t_se - t_st <= t_grl - t_gst."""
    return clip.markers.stroke_end - clip.markers.stroke <= request.relax_s - request.stroke_s + TOLERANCE_S


def place_clip(clip: Clip, request: GestureRequest) -> PlacedGesture:
    """The clip with its stroke at the desired time and its hold extended to the desired relax time, at least until the
    stroke's end."""
    stroke_end_s = request.stroke_s - clip.markers.stroke + clip.markers.stroke_end
    return PlacedGesture(request, clip, max(request.relax_s, stroke_end_s))


def in_time(placed: PlacedGesture, from_s: float = 0.0) -> PlacedGesture:
    """The gesture delayed until its stroke begins at `from_s`, by default with the first frame, the hand raised. A
    stroke that can begin with the first frame keeps its time; one that would be later than `LATEST_S` is unchanged,
    with its stroke before the first frame."""
    late_s = -placed.stroke_start_s
    if not 0 < late_s <= LATEST_S:
        return placed
    late_s = late_s if late_s <= _ROUNDING_S else min(late_s + from_s, LATEST_S)
    late = replace(placed, request=replace(placed.request, stroke_s=placed.request.stroke_s + late_s))
    return replace(late, relax_s=max(late.relax_s, late.stroke_end_s))


def candidate_clips(request: GestureRequest, library: Clips) -> tuple[tuple[Clip, ...], tuple[Decision, ...]]:
    """The clips that fit a request, none if it must be dropped, and the decisions made."""
    clips = tuple(in_the_time(clip, request) for clip in clips_of(request, library))
    decisions = tuple(_substitution(clips[0], request)) if clips else ()
    if not clips:
        reason = f"the library has no clip for {request.category}, nor a beat to replace it"
        return (), (Decision(request.behavior, "dropped", reason),)
    for allowed in (fits, fits_without_hold):
        found = tuple(clip for clip in clips if allowed(clip, request))
        if found:
            return found, decisions
    left_s = request.relax_s - request.stroke_s
    shortest_s = min(clip.markers.stroke_end - clip.markers.stroke for clip in clips)
    reason = f"{left_s:.2f} s from stroke to relax, and every clip of {request.category} needs {shortest_s:.2f} s"
    return (), (*decisions, Decision(request.behavior, "dropped", reason))


def shuffled(clips: tuple[Clip, ...], last_used: str | None, rng: np.random.Generator) -> tuple[Clip, ...]:
    """The clips in random order, with the variant used last at the end."""
    shuffled = [clips[number] for number in rng.permutation(len(clips))]
    return tuple(sorted(shuffled, key=lambda clip: clip.name == last_used))


def clips_of(request: GestureRequest, library: Clips) -> tuple[Clip, ...]:
    """The clips of the nearest category with the requested hand and level, or else with others; possibly none."""
    category = library.nearest(request.category)
    if category is None:
        return ()
    levels = (request.level, *(level for level in _LEVELS if level is not request.level))
    hands = (request.hand, *(hand for hand in Hand if hand is not request.hand))
    found = (library.clips(category, level, hand) for level, hand in product(levels, hands))
    return next((clips for clips in found if clips), ())


def _substitution(clip: Clip, request: GestureRequest) -> Iterator[Decision]:
    """A decision if the clips are not those that were requested."""
    changes = "; ".join(_changes(clip, request))
    if changes:
        yield Decision(request.behavior, "replaced", changes)


def _changes(clip: Clip, request: GestureRequest) -> Iterator[str]:
    """Differences between the clip and the request, in words."""
    category = clip.category
    if category != request.category:
        yield f"the library has no {request.category}: {category} replaces it"
    if clip.hand is not request.hand:
        yield f"{category} is made with {_NAMES[clip.hand]} instead of {_NAMES[request.hand]}"
    if clip.level is not request.level:
        yield f"{category} has no clip at {request.level} agitation: {clip.level} replaces it"


_LEVELS = (Level.MEDIUM, Level.LOW, Level.HIGH)
_NAMES = {Hand.LEFT: "the left hand", Hand.RIGHT: "the right hand", Hand.BOTH: "both hands"}

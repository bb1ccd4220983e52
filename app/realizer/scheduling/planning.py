"""The gesture scheduler (paper §3.8): from a schedule's gestures to clips on a timeline for each arm.

In order: each gesture gets a clip (`selection`), aligned by its stroke and not time-warped; conflicting neighbours are
replaced or pruned by priority (`pruning`); strokes are repeated on further emphases (`repetition`); gestures close
together blend into units, and units end at rest (`arm_timelines`). Whatever is not played as requested has a
`Decision`. docs/realizer-scheduling.md explains the rules.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, pairwise
from math import inf, isinf
from types import MappingProxyType

import numpy as np

from ...model import Hand, Schedule, SyncPoints
from ..body.motion import Decision
from ..body.movement_style import PLAIN, MovementStyle, Strokes
from ..dynamics.level_variants import varied
from ..dynamics.resting_beats import Habits
from ..dynamics.resting_beats import with_beats as riding
from ..dynamics.snapping import lifted, quickened, snapped, wound_up
from ..geometry.chance import generator_of
from ..gestures.gesture_plan import (
    ArmGesture,
    ArmRest,
    GesturePlan,
    GestureRequest,
    GestureUnit,
    PlacedGesture,
    Position,
    Transition,
    drawn,
)
from ..head_and_gaze.gaze_targets import unknown_target, with_target
from ..showing.directions import aims_m
from ..showing.slot_clips import as_shown, finger_first, in_its_place, showing, shown_decisions
from .arm_timelines import ArmTimeline, arm_timeline, rest_changes, units_of
from .pruning import KeptGestures, admit, obstacle
from .repetition import (
    beside_a_wave,
    is_held_long,
    let_go_in_time,
    repeats_until_s,
    told_repeats,
    with_beats,
    with_repeats,
)
from .rests import posture_changes
from .second_hand import HandHabits, led_by, of_arm
from .selection import Clips, candidate_clips, in_time, place_clip, requests_of, shuffled
from .transitions import TransitionContext, natural_preparation_s, way_m

SIDES = (Hand.LEFT, Hand.RIGHT)

_STILL = 0.5
"""The stillness above which a hand goes back to rest instead of beating time in a long hold."""
_PACE = 1
"""What is drawn for a stroke, beside what is drawn for its gesture's hands."""
_NOTICEABLE_S = 0.02
_SOONEST_SHARE = 0.4
"""Of the stroke that shows what the words say, if the way there takes longer than there is time for the whole."""
_NEXT = 3
"""A gesture and those after it that it may be in the way of, the next of either hand among them."""

_ON_TIME_S = 0.01
"""Differences from the schedule below this are not reported."""


def plan_gestures(
    library: Clips,
    schedule: Schedule,
    *,
    seed: int,
    targets_m: Mapping[str, Position] = MappingProxyType({}),
    leading: Hand = Hand.RIGHT,
    style: MovementStyle = PLAIN,
    open_ended: bool = False,
) -> GesturePlan:
    """What the arms do during a schedule. The stroke of every gesture that is played is at its time in the BML, except
    at the very start, where it may be late.

    `targets_m` has the world positions of pointing targets, as for the gaze; `leading` is the hand that the character
    prefers. In an `open_ended` take hands do not hurry to rest before the end.
    """
    setting = replace(_setting(schedule, style, seed), leading=leading)
    setting = replace(setting, end_s=inf) if open_ended else setting
    chosen = chosen_clips(library, schedule, setting, seed=seed, targets_m=targets_m)
    gestures = tuple(led_by(each, leading) for each in _repeated(chosen.kept, schedule, setting, style))
    units = units_of(gestures, setting)
    changes = rest_changes(units, setting)
    habits = HandHabits(leading, style, seed)
    timelines = [arm_timeline(side, of_arm(side, gestures, changes, habits), changes, setting) for side in SIDES]
    played = (each for line in timelines for each in line.gestures)
    made = sorted(_beating(played, gestures, schedule, habits), key=lambda each: each.markers.start)
    arms = tuple(each for each in made if not each.placed.follows)
    rests = tuple(_riding(_rests(timelines, schedule.duration_s), schedule, habits))
    aimed_at_nothing = (told for gesture in gestures for told in unknown_target(gesture))
    return GesturePlan(
        gestures=arms,
        rests=rests,
        transitions=tuple(transition for side in SIDES for transition in _transitions(side, made)),
        units=tuple(_unit(unit, arms) for unit in units),
        decisions=(*chosen.decisions, *aimed_at_nothing, *_decisions(arms)),
        realized={gesture.request.behavior: _realized(gesture, arms) for gesture in gestures},
        end_s=max(rest.end_s for rest in rests),
        following=tuple(each for each in made if each.placed.follows),
        style=style,
    )


def _setting(schedule: Schedule, style: MovementStyle, seed: int) -> TransitionContext:
    return TransitionContext(
        schedule.phrases,
        posture_changes(schedule),
        schedule.duration_s,
        singletons=schedule.singletons,
        style=style,
        level=schedule.agitation,
        seed=seed,
    )


def _riding(rests: Iterable[ArmRest], schedule: Schedule, habits: HandHabits) -> Iterator[ArmRest]:
    """The rests with beats on stressed words, unless the body is to be still."""
    own, emphases_s = Habits(habits.leading, habits.seed), sorted(schedule.emphases_s)
    for rest in rests:
        still = schedule.stillness > _STILL
        yield rest if still else riding(rest, emphases_s, schedule.phrases, habits.style.lap, own)


def _rests(timelines: Iterable[ArmTimeline], duration_s: float) -> tuple[ArmRest, ...]:
    """The rests of both arms, of which the last end with the plan: when both hands are back and the speech is over."""
    rests = [rest for line in timelines for rest in line.rests]
    end_s = max(duration_s, *(rest.start_s for rest in rests))
    return tuple(replace(rest, end_s=end_s) if isinf(rest.end_s) else rest for rest in rests)


def chosen_clips(
    library: Clips, schedule: Schedule, setting: TransitionContext, *, seed: int, targets_m: Mapping[str, Position]
) -> KeptGestures:
    """The gestures that are played with their clips, in order of their strokes, and the decisions about the others."""
    draw = Draw(library, generator_of(seed), targets_m, setting)
    kept: tuple[PlacedGesture, ...] = ()
    decisions: list[Decision] = []
    asked = requests_of(schedule)
    shown = tuple(as_shown(request, library.nearest, setting.leading) for request in asked)
    shown_m = aims_m(shown)
    for plain, with_its_hand in zip(asked, shown, strict=True):
        request, beside = beside_a_wave(with_its_hand, kept)
        decisions += beside
        options, told = draw.options(request, kept, shown_m)
        if request is not plain:
            others, told_plain = draw.options(plain, kept, {})
            options, told = [*options, *others], told if options else told_plain
        decisions += told
        if options:
            admission = admit(chain.from_iterable(options), kept, setting)
            kept = admission.kept
            decisions += (*admission.decisions, *_late(kept, request))
    return KeptGestures(_of_their_levels(kept, setting), (*decisions, *_shown(asked, kept)))


def _of_their_levels(kept: tuple[PlacedGesture, ...], setting: TransitionContext) -> tuple[PlacedGesture, ...]:
    """The gestures as they are at their levels of agitation, where hands still have the time for the way between each
    and its neighbours: the others stay as they are, for none is lost by it."""
    for number, gesture in enumerate(kept):
        other = varied(gesture, setting.style.variants)
        changed = (*kept[:number], other, *kept[number + 1 :])
        nearby = range(number, min(number + _NEXT, len(changed)))
        if other is not gesture and all(obstacle(changed[n], changed[:n], setting) is None for n in nearby):
            kept = changed
    return kept


@dataclass(frozen=True, slots=True)
class Draw:
    """How clips are drawn: from a library, by a generator, with the places of targets."""

    library: Clips
    rng: np.random.Generator
    targets_m: Mapping[str, Position]
    setting: TransitionContext

    def options(
        self, request: GestureRequest, kept: Iterable[PlacedGesture], shown_m: Mapping[str, Position]
    ) -> tuple[list[Iterator[PlacedGesture]], tuple[Decision, ...]]:
        """The gestures that fit a request in the order in which they are tried, made when they are, and decisions about
        it; nothing if there are none."""
        clips, told = candidate_clips(request, self.library)
        if not clips:
            return [], told
        before = [each.clip.name for each in kept if each.clip.category == clips[0].category]
        order = finger_first(shuffled(clips, before[-1] if before else None, self.rng), request)
        plain = [in_its_place(with_target(place_clip(clip, request), self.targets_m)) for clip in order]
        return [_late_ones_last(self._made(plain, shown_m))], told

    def _made(self, plain: Sequence[PlacedGesture], shown_m: Mapping[str, Position]) -> Iterator[PlacedGesture]:
        """The gestures as they are to be; then those that do not show what their words say, and those without the
        strength of the others."""
        shown: list[PlacedGesture] = []
        unsaid: list[PlacedGesture] = []
        weaker: list[PlacedGesture] = []
        for one in plain:
            each = showing(one, shown_m)
            if each is not one:
                shown.append(each)
                unsaid.append(one)
            strong = wound_up(lifted(each, self._strokes), self._strokes)
            weaker += [each] if strong is not each else []
            yield self._quick(strong)
        yield from map(self._quick, (*map(_later, shown), *unsaid, *weaker))

    def _quick(self, placed: PlacedGesture) -> PlacedGesture:
        quick = snapped(placed, self._strokes, drawn(self.setting.seed, placed, _PACE))
        return in_time(quick, self.setting.style.ends.still_s)

    @property
    def _strokes(self) -> Strokes:
        return self.setting.style.strokes


def _later(placed: PlacedGesture) -> PlacedGesture:
    """The gesture with a stroke that begins later: where the way to what its words say is long, that takes its time."""
    return replace(placed, clip=quickened(placed.clip, _SOONEST_SHARE))


def _late_ones_last(options: Iterable[PlacedGesture]) -> Iterator[PlacedGesture]:
    """The gestures, after the others those whose strokes would begin before the first frame."""
    late = []
    for each in options:
        if each.stroke_start_s < 0:
            late.append(each)
        else:
            yield each
    yield from late


def _shown(asked: Iterable[GestureRequest], kept: Iterable[PlacedGesture]) -> Iterator[Decision]:
    """The decisions about the gestures that show what their words say."""
    played = {gesture.request.behavior: gesture for gesture in kept}
    for request in asked:
        if request.behavior in played:
            yield from shown_decisions(request, played[request.behavior])


def _late(kept: Iterable[PlacedGesture], request: GestureRequest) -> Iterator[Decision]:
    for gesture in kept:
        late_s = gesture.request.stroke_s - request.stroke_s
        if gesture.request.behavior == request.behavior and late_s > _ON_TIME_S:
            yield Decision(request.behavior, "late", f"by {late_s:.2f} s: its stroke begins with the first frame")


def _repeated(
    gestures: tuple[PlacedGesture, ...], schedule: Schedule, setting: TransitionContext, style: MovementStyle
) -> Iterator[PlacedGesture]:
    for number, gesture in enumerate(gestures):
        until_s = min(schedule.duration_s, repeats_until_s(gesture, gestures[number + 1 :], setting))
        repeated = with_repeats(gesture, schedule.emphases_s, until_s)
        yield let_go_in_time(repeated, style.holds) if schedule.stillness > _STILL else repeated


def _beating(
    arms: Iterable[ArmGesture], gestures: Iterable[PlacedGesture], schedule: Schedule, habits: HandHabits
) -> Iterator[ArmGesture]:
    """The gestures of arms, with beats in long holds unless the body is to be still."""
    strokes_s = {each.request.behavior: each.request.stroke_s for each in gestures}
    still, holds = schedule.stillness > _STILL, habits.style.holds
    for arm in arms:
        if still or not is_held_long(arm, holds):
            yield arm
        else:
            lag_s = arm.placed.request.stroke_s - strokes_s[arm.behavior]
            yield with_beats(arm, schedule.emphases_s, holds, habits.drawn(arm.placed), lag_s=lag_s)


def _transitions(side: Hand, arms: Iterable[ArmGesture]) -> Iterator[Transition]:
    """The blends of one arm with their actual speeds."""
    own = (each for each in arms if each.side is side)
    for first, second in pairwise(own):
        if second.blended_from is not None and not (first.placed.follows or second.placed.follows):
            start_s, end_s = first.markers.relax, second.markers.stroke_start
            speed_m_s = way_m(first.placed, second.placed, side) / (end_s - start_s)
            yield Transition(side, first.behavior, second.behavior, start_s, end_s, speed_m_s)


def _of_behavior(gesture: PlacedGesture, arms: Iterable[ArmGesture]) -> list[ArmGesture]:
    return [each for each in arms if each.behavior == gesture.request.behavior]


def _unit(unit: tuple[PlacedGesture, ...], arms: tuple[ArmGesture, ...]) -> GestureUnit:
    own = [each for gesture in unit for each in _of_behavior(gesture, arms)]
    return GestureUnit(
        behaviors=tuple(gesture.request.behavior for gesture in unit),
        start_s=min(each.markers.start for each in own),
        end_s=max(each.markers.end for each in own),
    )


def _realized(gesture: PlacedGesture, arms: Iterable[ArmGesture]) -> SyncPoints:
    """The sync points of a gesture: the stroke of the hand that leads, the earliest start and the latest end of both
    arms."""
    own = [each.markers for each in _of_behavior(gesture, arms)]
    leads = min(own, key=lambda markers: markers.stroke)
    return SyncPoints(
        start=min(markers.start for markers in own),
        ready=min(leads.stroke_start, max(markers.ready for markers in own)),
        stroke_start=leads.stroke_start,
        stroke=leads.stroke,
        stroke_end=leads.stroke_end,
        relax=max(markers.relax for markers in own),
        end=max(markers.end for markers in own),
    )


def _decisions(arms: Iterable[ArmGesture]) -> Iterator[Decision]:
    """The decisions about gestures that are played; those that apply to both arms are reported once."""
    told = {(each.behavior, each.action): each for arm in arms for each in reversed(list(_told(arm)))}
    yield from told.values()


def _told(arm: ArmGesture) -> Iterator[Decision]:
    markers, gesture = arm.markers, arm.placed
    if arm.blended_from is not None:
        yield Decision(arm.behavior, "blended", f"straight from {arm.blended_from}, without rest between them")
    elif natural_preparation_s(gesture) - (markers.ready - markers.start) > _NOTICEABLE_S:
        natural_s = natural_preparation_s(gesture)
        reason = f"{markers.ready - markers.start:.2f} s of preparation instead of {natural_s:.2f} s"
        if arm.initial_progress > 0:
            reason += ", the hand raised in the first frame"
        yield Decision(arm.behavior, "shortened", reason)
    cut_s = gesture.clip.markers.relax - gesture.clip.markers.stroke - (markers.relax - markers.stroke)
    if cut_s > _NOTICEABLE_S:
        yield Decision(arm.behavior, "shortened", f"hold cut by {cut_s:.2f} s, to relax at the requested time")
    if repeated := tuple(told_repeats(arm)):
        yield Decision(arm.behavior, "repeated", "; ".join(repeated))
    if arm.beats:
        times = ", ".join(f"{beat.end_s:.2f}" for beat in arm.beats)
        yield Decision(arm.behavior, "repeated", f"beats instead of a long hold, at {times} s")
    if arm.blended_to is not None and markers.relax - gesture.relax_s > _NOTICEABLE_S:
        reason = f"{markers.relax - gesture.relax_s:.2f} s longer, to reach {arm.blended_to} at the speed of its stroke"
        yield Decision(arm.behavior, "held", reason)

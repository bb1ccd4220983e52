"""The motions of a line that a study compares, by comparison.

- units (NGS §4.1): U, with the units of a speaker's profile, and S, with single gestures. S is U with every hold
  between two gestures replaced by a retraction; after-strokes are removed only if the retraction needs their time. In
  both the hands rest at the side; everything else is the same. If there is still no time for a rest, the gesture is
  dropped from both, so that they have the same gestures; the paper does not mention this case.
- modes (the main paper, §5): they differ in their gestures only. Head, eyes, face and postures are those of the
  semantic mode; as in the paper, the position of the head still differs slightly, since the arms move the body.
- ways (RTS §3.2): a motion model driven in the three ways of the thesis.
- affect (AHG §3): a motion model driven by voice and affect, by the voice alone, or by affect alone (AHG §5 announces
  a test by raters).
- speakers (NGS §3.5): gestures by the profiles of several speakers.

With a motion model, head, eyes, face and legs are the same in all motions of a line, except for the parts that it
has learnt.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from ...behavior.speaker_profiles import scripted_behaviors
from ...errors import InputError
from ...library.motion import PreparedSchedule, RealizedSchedule
from ...library.motion_models import (
    MotionModel,
    moving_by,
    realize_moving,
    realize_played,
    scenario_named,
)
from ...library.performing import perform_analysis, perform_line
from ...model import Behavior, Channel, Interval, Mode, Performance, SyncPoints
from ...models import Understudy
from ...profiles.generation.phases import TimedStrokes, bounds_of
from ...profiles.generation.script import GestureScript, ScriptedGesture
from ...profiles.profile import Profile
from ...realizer.scheduling.rests import POSTURES
from ..comparison import AFFECT, BOTH, LIVE, OFFLINE, PROSODY, RANDOM, SINGLETONS, UNITS
from .lines import StudyLine
from .site import FRAME_RATE_HZ, TAIL_S, realized

ROOM_S = 1.0
"""In S after-strokes are removed to leave this time between the last stroke of a gesture and the first of the next."""

AT_SIDE = "HANDS_AT_SIDE"
_INSTANT_S = 0.1

WHOLE = "RTS"
DRIVEN_BY: Mapping[str, str] = {BOTH: "S1", PROSODY: "S3", AFFECT: "S5"}
"""The scenario of AHG Table 1 for each condition of `Comparison.AFFECT`."""


@dataclass(frozen=True, slots=True)
class UnitVersions:
    """The motions of both versions, the number of their gestures, the number of U's holds that are rests in S, and the
    number of gestures dropped for lack of time."""

    motions: Mapping[str, RealizedSchedule]
    gestures: int
    rests: int
    given_up: int


@dataclass(frozen=True, slots=True)
class _Member:
    """A gesture and the number of its unit."""

    gesture: ScriptedGesture
    unit: int


def in_units_and_singly(models: Understudy, study_line: StudyLine) -> UnitVersions:
    """The line's versions; raises as `PerformedLine.written_script` does."""
    line, options = study_line.line, study_line.options
    performed = perform_line(models, line, options)
    performance, script = performed.performance, performed.written_script()
    profile = models.behavior.profile(options.profile)
    if profile is None:
        raise InputError("value_wrong", "profile: gesture units need a profile; name one", field="profile")
    members = list(_members(script))
    while True:
        motions = {
            name: realized(models, _schedule(performance, _version(script, profile, members, name), name))
            for name in (UNITS, SINGLETONS)
        }
        unfit = _unfit(motions)
        kept = [each for each in members if each.gesture.id not in unfit]
        if len(kept) == len(members):
            break
        members = kept
    held = sum(each.action == "blended" for each in motions[UNITS].motion.decisions)
    return UnitVersions(motions, len(members), held, len(script.made) - len(members))


def _members(script: GestureScript) -> Iterator[_Member]:
    unit_of = {name: number for number, unit in enumerate(script.units) for name in unit.gestures}
    for gesture in script.made:
        yield _Member(gesture, unit_of[gesture.id])


def _joined(profile: Profile, members: Sequence[_Member]) -> list[bool]:
    """Whether each gesture is in one unit with the previous one. If a gesture between them was dropped, they may be too
    far apart."""
    near = [
        one.unit == other.unit
        and other.gesture.strokes[0].start_s - one.gesture.strokes[-1].end_s < profile.units.merge_within_s
        for one, other in pairwise(members)
    ]
    return [False, *near][: len(members)]


def _version(script: GestureScript, profile: Profile, members: Sequence[_Member], name: str) -> GestureScript:
    """The script with its gestures in units (U) or single (S)."""
    joined = _joined(profile, members)
    strokes = [each.gesture.strokes for each in members]
    if name == SINGLETONS:
        strokes = [*_trimmed(strokes, joined)]
        joined = [False] * len(members)
    timed = [TimedStrokes(own, each.gesture.held) for own, each in zip(strokes, members, strict=True)]
    bounds = bounds_of(profile.phases, timed, joined)
    gestures = tuple(
        replace(each.gesture, strokes=own, start_s=bound.start_s, relax_s=bound.relax_s, end_s=bound.end_s)
        for each, own, bound in zip(members, strokes, bounds, strict=True)
    )
    return replace(script, gestures=gestures, units=())


def _trimmed(strokes: Sequence[tuple[Interval, ...]], joined: Sequence[bool]) -> Iterator[tuple[Interval, ...]]:
    """The strokes of each gesture without the after-strokes that leave no time to rest before the next gesture."""
    for place, own in enumerate(strokes):
        kept = own
        if place + 1 < len(strokes) and joined[place + 1]:
            until_s = strokes[place + 1][0].start_s - ROOM_S
            kept = (own[0], *(stroke for stroke in own[1:] if stroke.end_s <= until_s))
        yield kept


def _schedule(performance: Performance, script: GestureScript, name: str) -> PreparedSchedule:
    """The schedule of a version: the script's gestures, rests at the side, and all other behaviours of the
    performance."""
    others = [each for each in performance.behaviors if each.rule != f"profile_{script.profile}"]
    made = scripted_behaviors(script, performance.functions, others)
    behaviors = (*_at_side(others), *(each for each in made if each.kind is Channel.GESTURE))
    prepared = PreparedSchedule.of(replace(performance, behaviors=behaviors))
    return replace(prepared, schedule=replace(prepared.schedule, singletons=name == SINGLETONS))


def _at_side(behaviors: Iterable[Behavior]) -> Iterator[Behavior]:
    """The behaviours with all rests of the hands at the side: from the first frame on, and again after each shift of
    weight, which would otherwise reset the rest."""
    yield _side_posture(0.0, 0)
    for number, each in enumerate(behaviors, start=1):
        is_posture = each.kind is Channel.POSTURE and each.lexeme in POSTURES
        if not is_posture or POSTURES[each.lexeme] is None:
            yield each
        if is_posture and each.kept:
            yield _side_posture(each.sync.start, number)


def _side_posture(start_s: float, number: int) -> Behavior:
    sync = SyncPoints(start=start_s, end=start_s + _INSTANT_S)
    return Behavior(f"study.rest.{number}", Channel.POSTURE, AT_SIDE, sync, 0, 0, 1.0)


def _unfit(motions: Mapping[str, RealizedSchedule]) -> set[str]:
    """The first gesture that has no rest before it in S, or is dropped in a version."""
    told = [each.behavior for each in motions[SINGLETONS].motion.decisions if each.action == "blended"]
    told += [each.behavior for found in motions.values() for each in found.motion.decisions if each.action == "dropped"]
    return {name for name in told[:1] if name.startswith("script.")}


def in_modes(models: Understudy, study_line: StudyLine) -> Mapping[str, Performance]:
    """The line's performances by mode; raises as `perform_line` does."""
    line, options = study_line.line, study_line.options
    performed = perform_line(models, line, options)
    analysis, meant = performed.analysis, performed.performance
    others = {
        mode: perform_analysis(models, analysis, replace(options, mode=mode), line.direction)
        for mode in (Mode.PROSODY, Mode.RANDOM)
    }
    return {Mode.SEMANTIC.value: meant} | {mode.value: with_gestures_of(other, meant) for mode, other in others.items()}


def with_gestures_of(gesturing: Performance, moving: Performance) -> Performance:
    """The performance `moving` with the gestures of `gesturing`; ids cannot clash, since they are numbered by
    channel."""

    def is_gesture(behavior: Behavior) -> bool:
        return behavior.kind is Channel.GESTURE

    gestures = [each for each in gesturing.behaviors if is_gesture(each)]
    rest = [each for each in moving.behaviors if not is_gesture(each)]
    return replace(moving, behaviors=tuple(sorted((*gestures, *rest), key=lambda each: (each.sync.start, each.id))))


def in_ways(models: Understudy, model: MotionModel, line: StudyLine, seed: int) -> Mapping[str, RealizedSchedule]:
    """The line's motion for the complete recording, for a live one, and with units drawn at random; raises as
    `perform_line` does."""
    performed = perform_line(models, line.line, line.options)
    prepared, analysis, realizer = PreparedSchedule.of(performed.performance), performed.analysis, models.realizer
    moving = moving_by(model, analysis, None, scenario_named(WHOLE))
    return {
        OFFLINE: realize_moving(realizer, prepared, moving, frame_rate_hz=FRAME_RATE_HZ, tail_s=TAIL_S),
        LIVE: realize_played(realizer, prepared, model, analysis, frame_rate_hz=FRAME_RATE_HZ, tail_s=TAIL_S),
        RANDOM: realize_played(
            realizer, prepared, model, analysis, drawn_by=seed, frame_rate_hz=FRAME_RATE_HZ, tail_s=TAIL_S
        ),
    }


def driven_by_affect(models: Understudy, model: MotionModel, line: StudyLine) -> Mapping[str, RealizedSchedule]:
    """The line's motion driven by voice and affect, by the voice alone, and by affect alone; raises as `perform_line`
    does."""
    performed = perform_line(models, line.line, line.options)
    prepared, analysis = PreparedSchedule.of(performed.performance), performed.analysis
    return {
        name: realize_moving(
            models.realizer,
            prepared,
            moving_by(model, analysis, line.options.affect, scenario_named(scenario)),
            frame_rate_hz=FRAME_RATE_HZ,
            tail_s=TAIL_S,
        )
        for name, scenario in DRIVEN_BY.items()
    }


def by_speakers(
    models: Understudy, speakers: Mapping[str, Profile | str], line: StudyLine
) -> Mapping[str, RealizedSchedule]:
    """The line's motion with the gestures of each speaker; raises as `perform_line` does."""
    performances = {
        name: perform_line(models, line.line, replace(line.options, profile=profile)).performance
        for name, profile in speakers.items()
    }
    return {name: realized(models, PreparedSchedule.of(each)) for name, each in performances.items()}

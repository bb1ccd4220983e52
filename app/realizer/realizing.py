"""Realizes a BML schedule as motion, with the paper's controllers (§3.8) in order: the idle body first, the face last.

Each controller changes the body's motion so far, in place, and returns it. Gestures and gaze override the joints that
they move, head movements are added to the current rotations, and a last pass resolves collisions of the arms with the
body.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from math import ceil
from pathlib import Path
from types import MappingProxyType

import numpy as np

from ..model import Behavior, Channel, FloatArray, Hand, Schedule, SyncPoints
from ..model.figure import PLAIN, Figure, Looks
from ..option_table import MOTION
from .arms.collisions import Collisions, kept_apart
from .body.motion import BodyMotion, Decision, Motion
from .body.movement_style import Ends, MovementStyle
from .body.proportions import Proportions
from .body.skeleton import Skeleton
from .dynamics.calming import calm_arms, calm_fingers, calm_head
from .dynamics.take_ends import ease_ends, eased_at_the_ends
from .exporting.retargeting import Rig, find_rig, load_rigs
from .face.blendshapes import face_weights
from .face.expressions import realized_faces, unknown_faces
from .face.face_tables import FaceTables
from .gestures.gesture_plan import GesturePlan, Position
from .gestures.library import Library
from .head_and_gaze.accompanying import accompanying_looks, with_looks
from .head_and_gaze.gaze import apply_gaze, eyes_in_t_pose_m
from .head_and_gaze.gaze_targets import LISTENER, LISTENER_M
from .head_and_gaze.head import apply_head_movements, realized_heads
from .physics.tracking import with_physics
from .scheduling.deviations import timing_deviations, unplayable_behaviors
from .scheduling.gesture_controller import accents_of, apply_gestures
from .scheduling.planning import plan_gestures
from .torso.idle import idle_motion
from .torso.steps import with_steps
from .torso.upper_body import (
    with_aimed_arms,
    with_hands_on_pelvis,
    with_hanging_arms,
    with_neck_reaching,
    with_shrugs,
)

_DECIMALS = 6
"""To which a number of frames is known: a recording of 2 s has 120 frames at 60 a second, not 121 by rounding."""

_NOTICEABLE_S = 0.02

_APART_ROUNDS = 4
"""How often limbs are calmed and kept apart again, if they have to be."""

_LARGEST_SEED = 2**64 - 1
"""NumPy's generators refuse negative ones."""


@dataclass(frozen=True, slots=True, eq=False)
class RealizedCharacter:
    """A character as it is realized: its body, its looks, the gestures of the library in its manner, the hand that
    leads in those of both, and how its body moves."""

    skeleton: Skeleton
    looks: Looks
    library: Library
    leading: Hand
    style: MovementStyle

    @classmethod
    def of(cls, figure: Figure, library: Library, style: MovementStyle) -> "RealizedCharacter":
        """The performer whose figure this is."""
        skeleton = Skeleton.standing(Proportions(figure.physique))
        gestures = library.in_manner(style.sex(figure).manner(figure.manner))
        return cls(skeleton, figure.looks, gestures, figure.leading, style.of(figure))


@dataclass(frozen=True, slots=True, eq=False)
class Realizer:
    """The resources that realization needs, loaded once: performers by the names of their characters, the average one
    for everybody else, gesture library, face tables and export rigs."""

    average: RealizedCharacter
    performers: Mapping[str, RealizedCharacter]
    library: Library
    face: FaceTables
    style: MovementStyle
    rigs: Mapping[str, Rig]

    @classmethod
    def load(cls, lexicon: Path, figures: Mapping[str, Figure] = MappingProxyType({})) -> "Realizer":
        """Load everything from a lexicon folder; `figures` are those of its characters.

        Raises AuthoringError with all mistakes of the first kind of file that has any.
        """
        return cls.with_library(Library.load(lexicon / "gestures"), lexicon, figures)

    @classmethod
    def with_library(
        cls, library: Library, lexicon: Path, figures: Mapping[str, Figure] = MappingProxyType({})
    ) -> "Realizer":
        """The same with gestures that are loaded already."""
        style = MovementStyle.load(lexicon / "movement.yaml", library.categories)
        library = library.with_waves(style.strokes.waving)
        average = RealizedCharacter.of(PLAIN, library, style)
        return cls(
            average=average,
            performers={name: RealizedCharacter.of(figure, library, style) for name, figure in figures.items()},
            library=library,
            face=FaceTables.load(lexicon / "face.yaml"),
            style=style,
            rigs=load_rigs(lexicon / "retarget", average.skeleton),
        )

    @property
    def skeleton(self) -> Skeleton:
        """The average body."""
        return self.average.skeleton

    def performer(self, character: str) -> RealizedCharacter:
        """Who performs as this character: the average performer where no file describes it."""
        return self.performers.get(character, self.average)

    def rig(self, name: str) -> Rig:
        """The rig of this name, with its joint names. Raises InputError `unknown_skeleton`."""
        return find_rig(self.rigs, name)


def realize(
    realizer: Realizer,
    schedule: Schedule,
    *,
    frame_rate_hz: int = 60,
    seed: int = 0,
    tail_s: float = 0.0,
    physics: bool = False,
    open_ended: bool = False,
) -> Motion:
    """The motion of a schedule, exactly as long as the schedule is, and `tail_s` more in which hands come to rest.
    Any integer is a seed; those that differ by a multiple of 2⁶⁴ are the same. With `physics` the body has mass.
    An `open_ended` take is a piece of a longer performance: what it does hangs on neither its beginning nor its end.

    Raises InputError `value_wrong` for a tail that is not from 0 to 10, ServiceError `physics_missing`.
    """
    MOTION["tail_s"].check(tail_s)
    seed &= _LARGEST_SEED
    schedule = replace(schedule, duration_s=schedule.duration_s + tail_s)
    performer = realizer.performer(schedule.character)
    skeleton, aims_m = performer.skeleton, _targets_m(schedule, performer.skeleton)
    style = replace(performer.style, ends=Ends()) if open_ended else performer.style
    plan = plan_gestures(
        performer.library,
        schedule,
        seed=seed,
        targets_m=aims_m,
        leading=performer.leading,
        style=style,
        open_ended=open_ended,
    )
    times_s = frame_times_s(schedule.duration_s, frame_rate_hz)
    body, told = _moving_body(skeleton, schedule, plan, times_s, style=style, targets_m=aims_m, seed=seed)
    body, moved = _apart(skeleton, body, style.ends, physics=physics)
    realized = _realized(schedule.behaviors, plan, frame_s=1 / frame_rate_hz, end_s=float(times_s[-1]))
    shapes = face_weights(realizer.face, schedule, body, skeleton, seed=seed)
    unknown = _unknown_body(realizer, schedule.character)
    decisions = (*_decided(realizer, schedule, plan, realized, aims_m), *told, *moved, *unknown)
    return Motion(frame_rate_hz, body, shapes, realized, decisions, lead_in_s=schedule.lead_in_s)


def _decided(
    realizer: Realizer,
    schedule: Schedule,
    plan: GesturePlan,
    realized: Mapping[str, SyncPoints],
    targets_m: Mapping[str, Position],
) -> tuple[Decision, ...]:
    """What is not played as it was asked for."""
    decisions = (
        *plan.decisions,
        *_cut(plan, schedule.duration_s),
        *unplayable_behaviors(schedule, targets_m=targets_m),
        *unknown_faces(realizer.face.lexemes, schedule.behaviors),
    )
    return (*decisions, *timing_deviations(schedule.behaviors, realized, decisions, schedule.asked))


def _moving_body(
    skeleton: Skeleton,
    schedule: Schedule,
    plan: GesturePlan,
    times_s: FloatArray,
    *,
    style: MovementStyle,
    targets_m: Mapping[str, Position],
    seed: int,
) -> tuple[BodyMotion, tuple[Decision, ...]]:
    """The body by the controllers in order, and the decisions about its looks with gestures and its steps."""
    lively = 1 - schedule.stillness
    eased_s = eased_at_the_ends(times_s, style.ends.eased_s)
    accents = accents_of(plan, eased_s, style.stroke, scale=lively)
    body = idle_motion(skeleton, eased_s, schedule, seed=seed, life=style.idle, with_limbs=False)
    body = replace(body, times_s=times_s)
    body = apply_gestures(skeleton, body, plan, seed=seed, noise_scale=lively, accents=accents, eased_s=eased_s)
    body = with_hanging_arms(skeleton, body)
    body = with_shrugs(skeleton, body, plan)
    body, stepped = with_steps(skeleton, body, schedule, seed=seed)
    body = with_hands_on_pelvis(skeleton, body, plan)
    body = with_aimed_arms(skeleton, body, plan.gestures)
    looks = accompanying_looks(skeleton, body, schedule, plan)
    seen_m = {**targets_m, **{str(look.gaze.target): look.at_m for look in looks}}
    body, at_m = apply_gaze(skeleton, body, with_looks(schedule, looks), targets_m=seen_m, seed=seed)
    body = apply_head_movements(skeleton, body, schedule, seed=seed, seen_m=at_m, trunk_s=eased_s)
    body = with_neck_reaching(skeleton, body, schedule, accents.neck, seed=seed, life=style.idle)
    return body, (*(look.decision for look in looks), *stepped)


def _apart(
    skeleton: Skeleton, body: BodyMotion, ends: Ends, *, physics: bool
) -> tuple[BodyMotion, tuple[Decision, ...]]:
    """The body, changed in place, with its limbs apart and its arms no faster than arms are, with `physics` also after
    its mass has swung; and at rest at both ends."""
    collisions = _keep_apart_and_calm(skeleton, body, ends)
    swung: tuple[Decision, ...] = ()
    if physics:
        body, swung = with_physics(skeleton, body)
        collisions = collisions.and_then(_keep_apart_and_calm(skeleton, body, ends))
    return body, (*collisions.decisions, *swung)


def _keep_apart_and_calm(skeleton: Skeleton, body: BodyMotion, ends: Ends) -> Collisions:
    """Limbs that are kept apart may be too fast or not at rest at the ends, and those that are calmed inside something:
    in turns, until they are neither. In place."""
    found, posed = kept_apart(skeleton, body)
    for _round in range(_APART_ROUNDS):
        eased = ease_ends(skeleton, body, ends.eased_s, posed)
        now = None if eased else posed
        calmed = calm_head(skeleton, body, now), calm_arms(skeleton, body, now)  # no wrist goes with a head
        if not eased and not any(calmed):
            break
        again, posed = kept_apart(skeleton, body)
        found = found.and_then(again)
    calm_fingers(skeleton, body)  # no limb is where it is because of them
    return found


def frame_times_s(end_s: float, frame_rate_hz: int) -> FloatArray:
    """Times (T,) of the frames that begin before `end_s`: as many as it has frames, at least two."""
    return np.arange(max(2, ceil(round(end_s * frame_rate_hz, _DECIMALS)))) / frame_rate_hz


def _realized(
    behaviors: tuple[Behavior, ...], plan: GesturePlan, *, frame_s: float, end_s: float
) -> dict[str, SyncPoints]:
    """The sync points as realized: gestures as planned, faces and head movements within their speed limits, everything
    else as scheduled, and nothing after the last frame."""
    others = {each.id: each.sync for each in behaviors if each.kind is not Channel.GESTURE}
    found = {**others, **realized_faces(behaviors, frame_s), **realized_heads(behaviors), **plan.realized}
    return {name: _until(sync, end_s) for name, sync in found.items()}


def _until(sync: SyncPoints, end_s: float) -> SyncPoints:
    """The sync points, those after the end at the end."""
    if sync.end <= end_s:
        return sync
    return replace(sync, **{name: min(time_s, end_s) for name, time_s in sync.in_order()})


def _cut(plan: GesturePlan, end_s: float) -> tuple[Decision, ...]:
    """The gestures whose retraction is cut off by the end of the motion."""
    late_s = {each.behavior: each.markers.end - end_s for each in plan.gestures if each.blended_to is None}
    return tuple(
        Decision(name, "cut", f"the hand would be at rest {over_s:.2f} s after the end; add a tail")
        for name, over_s in late_s.items()
        if over_s > _NOTICEABLE_S
    )


def _targets_m(schedule: Schedule, skeleton: Skeleton) -> dict[str, Position]:
    """Where the targets are; the listener whom nobody placed is at the height of the performer's eyes."""
    x, _y, z = LISTENER_M
    placed = {target.name: target.position_m for target in schedule.targets}
    return {LISTENER: (x, float(eyes_in_t_pose_m(skeleton)[1]), z), **placed}


def _unknown_body(realizer: Realizer, character: str) -> Iterator[Decision]:
    if realizer.performers and character not in realizer.performers:
        yield Decision("", "replaced", f"no character is called {character!r}: an average body is used")

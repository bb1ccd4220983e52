"""Performs a recording by a motion model: the best path of kinds, units for it, and their motion laid over a realized
one.

Units move the joints that the model has learnt; all others, eyes, face, lips, legs and breath among them, move as they
are realized. At the ends of the recording motion goes over from the realized one and back, so that lines can follow
each other. Hands and forearms are kept out of the body and each other, for people who were recorded have other bodies.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..model import Behavior, Channel, FloatArray, Schedule
from ..prosody_gestures.semi_markov import FRAME_S, Segment
from ..prosody_gestures.trellis import EVERYTHING, Search
from ..realizer.arms.collisions import resolve_collisions
from ..realizer.body.motion import BodyMotion, Decision, Motion
from ..realizer.body.skeleton import Skeleton
from ..realizer.geometry.rotations import nearest_sign, normalized, slerp
from .bodies import BodyTrack, resampled
from .model import MotionModel, Scenario
from .pairs import Voice
from .unit_selection import LEAD_OVER_S, MotionUnit, motion_of, select

_MOVED_BY = {Channel.HEAD: "head", Channel.POSTURE: "spine"}
"""The joint whose motion replaces a channel's behaviours; gestures are always replaced."""


@dataclass(frozen=True, slots=True, eq=False)
class UnitMotion:
    """The path of kinds, and the local `rotations` (frames × joints × 4) of its units, a row each `FRAME_S`."""

    path: tuple[Segment, ...]
    joints: tuple[str, ...]
    rotations: FloatArray


def move(model: MotionModel, voice: Voice, scenario: Scenario, search: Search = EVERYTHING) -> UnitMotion:
    """The motion of a whole recording (AHG §3.6, 3.7; RTS §2.3, 2.4)."""
    path = model.path(voice, scenario.features, search)
    wanted = np.array([voice.affect[each.start : each.end].mean(axis=0) for each in path]).reshape(-1, 3)
    units = select(path, wanted, model.pool(), scenario.weights)
    return UnitMotion(path, model.joints, motion_of(path, units))


def move_at_random(model: MotionModel, frames: int, seed: int) -> UnitMotion:
    """Units drawn from the pool one after the other, whatever is said (RTS §3.2's random animation)."""
    drawn, path, units = np.random.default_rng(seed), list[Segment](), list[MotionUnit]()
    while not path or path[-1].end < frames:
        unit, start = model.units[drawn.integers(len(model.units))], path[-1].end if path else 0
        units.append(unit)
        path.append(Segment(unit.state, start, start + len(unit.rotations)))
    return UnitMotion(tuple(path), model.joints, motion_of(path, units)[:frames])


def replaced_behaviors(model: MotionModel, schedule: Schedule) -> tuple[Schedule, tuple[Decision, ...]]:
    """The schedule without the behaviours of parts that the model moves, and what was left out."""
    dropped = [each for each in schedule.behaviors if _is_replaced(each, model.joints)]
    kept = tuple(each for each in schedule.behaviors if not _is_replaced(each, model.joints))
    message = "the motion model moves that part of the body"
    return replace(schedule, behaviors=kept), tuple(Decision(each.id, "replaced", message) for each in dropped)


def _is_replaced(behavior: Behavior, joints: Sequence[str]) -> bool:
    return behavior.kind is Channel.GESTURE or _MOVED_BY.get(behavior.kind) in joints


def laid_over(motion: Motion, moved: UnitMotion, skeleton: Skeleton) -> Motion:
    """The motion with that of the units, from the beginning of the recording to its end."""
    times_s = motion.body.times_s - motion.lead_in_s
    length_s = len(moved.rotations) * FRAME_S
    played = (times_s >= 0) & (times_s <= length_s)
    if not played.any():
        return motion
    track = BodyTrack(moved.joints, moved.rotations, np.arange(len(moved.rotations)) * FRAME_S)
    places, at = np.flatnonzero(played), np.array(skeleton.chain(*moved.joints))
    share = np.clip(np.minimum(times_s[places], length_s - times_s[places]) / LEAD_OVER_S, 0.0, 1.0)
    eased = np.broadcast_to((share * share * (3 - 2 * share))[:, None], (len(places), len(at)))
    rotations = motion.body.rotations.copy()
    usual = rotations[places[:, None], at]
    shown = nearest_sign(resampled(track, times_s[places]), usual)
    rotations[places[:, None], at] = normalized(slerp(usual, shown, eased))
    body = BodyMotion(motion.body.times_s, rotations, motion.body.hips_m)
    moved_out = resolve_collisions(skeleton, body)
    return replace(motion, body=body, decisions=(*motion.decisions, *moved_out.decisions))

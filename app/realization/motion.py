"""Realizes schedules (paper §3.8), and extracts the schedule from a performance."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from ..behavior.speech import emphases_s, phrases
from ..errors import did_you_mean
from ..model import Behavior, Channel, Notice, Performance, Schedule
from ..realizer.body.motion import Motion
from ..realizer.gestures.library import LAST_RESORT
from ..realizer.realizing import Realizer, realize


@dataclass(frozen=True, slots=True, eq=False)
class RealizedSchedule:
    """A schedule and its motion."""

    schedule: Schedule
    motion: Motion


@dataclass(frozen=True, slots=True)
class PreparedSchedule:
    """A schedule ready for the realizer, with notices of what was guessed or left out, and the random seed."""

    schedule: Schedule
    notices: tuple[Notice, ...]
    seed: int = 0

    @classmethod
    def of(cls, performance: Performance) -> PreparedSchedule:
        """The prepared schedule of a performance."""
        return cls(schedule_of(performance), performance.notices, performance.seed)


def schedule_of(performance: Performance) -> Schedule:
    """The realizer's input: the kept behaviours of a performance with its speech."""
    utterance = performance.utterance
    behaviors = tuple(behavior for behavior in performance.behaviors if behavior.kept)
    return Schedule(
        behaviors=behaviors,
        duration_s=utterance.duration_s or last_s(behaviors),
        words=utterance.words,
        visemes=performance.visemes,
        phrases=phrases(utterance.words),
        emphases_s=emphases_s(utterance.words),
        agitation=utterance.level,
        character=performance.character,
        lead_in_s=utterance.lead_in_s,
        stillness=performance.stillness,
        targets=performance.targets,
        functions=tuple(function for function in performance.functions if function.kept),
    )


def realize_prepared(
    realizer: Realizer,
    prepared: PreparedSchedule,
    *,
    frame_rate_hz: int = 60,
    tail_s: float = 0.0,
    physics: bool = False,
) -> RealizedSchedule:
    """The motion of a schedule; its notices also name gestures that were replaced or dropped."""
    schedule, seed = prepared.schedule, prepared.seed
    motion = realize(realizer, schedule, frame_rate_hz=frame_rate_hz, seed=seed, tail_s=tail_s, physics=physics)
    notices = (*prepared.notices, *_unknown_gestures(realizer, schedule), *_unplayed_gestures(motion, schedule))
    return RealizedSchedule(schedule, replace(motion, notices=notices))


def _unknown_gestures(realizer: Realizer, schedule: Schedule) -> Iterator[Notice]:
    library = realizer.library
    for gesture in _gestures(schedule):
        if library.category_of(gesture.lexeme) is None and library.nearest(gesture.lexeme):
            hint = did_you_mean(gesture.lexeme, library.categories)
            message = f"{gesture.id} is played as a {LAST_RESORT}: no gesture is called {gesture.lexeme!r}{hint}"
            yield Notice("gesture_unknown", message)


def _unplayed_gestures(motion: Motion, schedule: Schedule) -> Iterator[Notice]:
    names = {gesture.id for gesture in _gestures(schedule)}
    for told in motion.decisions:
        if told.behavior in names and told.action == "dropped":
            yield Notice("gesture_not_played", f"{told.behavior} is not played: {told.reason}")


def _gestures(schedule: Schedule) -> Iterator[Behavior]:
    return (each for each in schedule.behaviors if each.kept and each.kind is Channel.GESTURE)


def last_s(behaviors: tuple[Behavior, ...]) -> float:
    """The end of the last behaviour, in seconds; 0 if there is none."""
    return max((behavior.sync.end for behavior in behaviors), default=0.0)

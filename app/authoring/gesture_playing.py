"""Plays one gesture that is not in the library yet, alone and from rest to rest, as the realizer would play it in a
line."""

from dataclasses import dataclass, replace

from ..errors import InputError
from ..model import Behavior, Channel, Hand, Level, Schedule, SyncPoints
from ..model.figure import PLAIN_MANNER, Manner
from ..realization import PreparedSchedule
from ..realizer.gestures.clips import clip
from ..realizer.gestures.gesture import Definition
from ..realizer.gestures.library import Library
from ..realizer.realizing import Realizer

BEFORE_S, AFTER_S = 0.8, 1.2
"""How long the hands rest before the gesture, and how long the motion goes on after it."""

BEHAVIOR = "gesture"
"""The id of the gesture in the motion's events."""


@dataclass(frozen=True, slots=True)
class Playing:
    """How a gesture is to be played; by default with the hand it is defined for, or the right."""

    level: Level = Level.MEDIUM
    hand: Hand | None = None
    character: str = "default"
    manner: Manner = PLAIN_MANNER


def schedule_of_gesture(definition: Definition, playing: Playing) -> PreparedSchedule:
    """A schedule of only this gesture. Raises InputError `unfit_gesture` for a level it is not defined for."""
    if playing.level not in definition.levels:
        known = ", ".join(definition.levels)
        message = f"{definition.name} is not for {playing.level} agitation, but for {known}"
        raise InputError("unfit_gesture", message, field="level")
    made, hand = replace(definition, manner=playing.manner), playing.hand or definition.hand or Hand.RIGHT
    markers = clip(made, playing.level, hand, made.categories[0]).markers
    sync = SyncPoints(
        BEFORE_S, BEFORE_S + markers.end, stroke=BEFORE_S + markers.stroke, relax=BEFORE_S + markers.relax
    )
    asked = Behavior(BEHAVIOR, Channel.GESTURE, made.categories[0], sync, 0, 0, 1.0, hand=hand)
    duration_s = BEFORE_S + markers.end + AFTER_S
    return PreparedSchedule(Schedule((asked,), duration_s, agitation=playing.level, character=playing.character), ())


def with_only(realizer: Realizer, definition: Definition, playing: Playing) -> Realizer:
    """A realizer whose library has only this gesture."""
    library = Library.of((definition,))
    performer = replace(realizer.performer(playing.character), library=library.in_manner(playing.manner))
    return replace(realizer, average=performer, performers={playing.character: performer}, library=library)

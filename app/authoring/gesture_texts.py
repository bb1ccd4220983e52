"""Checks the text of a gesture as its author writes it (Gesture Engine §4.3): reports every mistake with its place, and
poses that the body cannot take; and plays it alone, from rest to rest, as the realizer would play it in a line, though
it is not in the library yet.
"""

from dataclasses import dataclass, replace
from pathlib import Path

from ..errors import AuthoringError, InputError, Mistake, did_you_mean
from ..model import Behavior, Channel, Hand, Level, Schedule, SyncPoints
from ..model.figure import PLAIN_MANNER, GestureManner
from ..realization import PreparedSchedule
from ..realizer.arms.plausibility import Doubt, doubts
from ..realizer.body.skeleton import Skeleton
from ..realizer.gestures.gesture import Definition
from ..realizer.gestures.library import Library, clip, parse_definitions
from ..realizer.realizing import Realizer

NAME = Path("gesture")
"""The name in messages of a text without a file."""

MOST_MISTAKES = 200
"""How many mistakes of a text are told: a text of half a megabyte can have 40,000."""


@dataclass(frozen=True, slots=True)
class CheckedText:
    """The gestures that a text defines, if it has no mistakes, and doubts about them."""

    text: str
    definitions: tuple[Definition, ...] = ()
    mistakes: tuple[Mistake, ...] = ()
    doubts: tuple[Doubt, ...] = ()


def check_text(text: str, skeleton: Skeleton) -> CheckedText:
    """The gestures of a text in the gesture language (docs/gesture-language.md), or the first `MOST_MISTAKES` of its
    mistakes."""
    try:
        definitions = parse_definitions(text, NAME)
    except AuthoringError as error:
        return CheckedText(text, mistakes=error.mistakes[:MOST_MISTAKES])
    found = tuple(doubt for definition in definitions for doubt in doubts(skeleton, definition))
    return CheckedText(text, definitions, doubts=found)


def one_gesture(text: str, name: str | None) -> Definition:
    """The gesture of that name in a text, or its first. Raises InputError `gesture_wrong`, `unknown_name`."""
    try:
        definitions = parse_definitions(text, NAME)
    except AuthoringError as error:
        first, *others = error.mistakes
        more = f"; and {len(others)} more mistakes" if others else ""
        message = f"{first.line}:{first.column}: {first.message}{more}"
        raise InputError("gesture_wrong", message, field="text") from None
    if not definitions:
        raise InputError("gesture_wrong", "the text defines no gesture; one begins with GESTURECLASS", field="text")
    named = {definition.name: definition for definition in definitions}
    if name is not None and name not in named:
        hint = did_you_mean(name, named)
        raise InputError("unknown_name", f"no gesture of the text is called {name!r}{hint}", field="name")
    return definitions[0] if name is None else named[name]


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
    manner: GestureManner = PLAIN_MANNER


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

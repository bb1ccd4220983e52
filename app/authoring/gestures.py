"""Gestures for their authors: the text of one is checked as it is written (Gesture Engine §4.3), with every mistake in
its place and the poses that the body cannot take, and played alone, from rest to rest, though it is not in the library
yet; those of the library are found by name, shown at each level, and drawn.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ..errors import AuthoringError, InputError, Mistake, did_you_mean
from ..model import Behavior, Channel, Hand, Level, Schedule, SyncPoints
from ..model.figure import PLAIN_MANNER, GestureManner
from ..realization import PreparedSchedule
from ..realizer.arms.plausibility import Doubt, doubts
from ..realizer.body.proportions import Proportions
from ..realizer.body.skeleton import Skeleton
from ..realizer.gestures.gesture import Clip, Definition
from ..realizer.gestures.library import SUFFIX, Library, clip, gesture_files, parse_definitions, read_definitions
from ..realizer.realizing import Realizer
from .catalogue import load_characters, load_gestures, shown_path

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


__all__ = ["Clip", "Definition", "Library"]


def gestures_named(name: str) -> Sequence[Definition]:
    """The gestures of a category or in a file, or the gesture of that name; raises InputError `unknown_name`,
    AuthoringError with every mistake in the file."""
    if name.endswith(SUFFIX):
        return read_definitions([Path(name)])
    library = load_gestures()
    return library.by_category.get(name) or (library.definition(name),)


def gestures_in(paths: Sequence[Path]) -> Sequence[Definition]:
    """The gestures of files and folders; raises AuthoringError with every mistake."""
    return read_definitions(gesture_files(paths))


def pose_doubts(definitions: Iterable[Definition]) -> Iterator[tuple[str, str]]:
    """The poses that the body cannot take: where each is, and what is wrong with it."""
    skeleton = Skeleton.standing()
    for definition in definitions:
        for doubt in doubts(skeleton, definition):
            where = f"{place_of(definition)}: {definition.name}, frame {doubt.time:g}, {doubt.level} agitation"
            yield where, doubt.message


def place_of(definition: Definition) -> str:
    """The gesture's file and line."""
    return f"{shown_path(definition.path)}:{definition.line}" if definition.path else ""


def clips_by_level(definition: Definition) -> Sequence[Clip]:
    """The gesture as it is made at each level that it is defined for."""
    return [clip(definition, level, definition.hand or Hand.RIGHT, definition.name) for level in definition.levels]


def draw_gestures(definitions: Iterable[Definition], level: Level, hand: Hand | None) -> tuple[bytes, int, int]:
    """A picture of the gestures' key poses at a level, and how many poses and gestures it has; by default with the hand
    that a gesture is defined for, or the right. Needs matplotlib.

    Raises InputError `unfit_gesture` where none is defined for the level.
    """
    from ..realizer.pictures.gesture_sheet import draw_gestures as drawn  # matplotlib, an extra

    fitting = [each for each in definitions if level in each.levels]
    if not fitting:
        raise InputError("unfit_gesture", f"none of these gestures is for {level} agitation", field="level")
    clips = [clip(each, level, hand or each.hand or Hand.RIGHT, each.categories[0]) for each in fitting]
    picture, poses = drawn(Skeleton.standing(), clips)
    return picture, poses, len(clips)


def draw_characters(names: Sequence[str]) -> tuple[bytes, int]:
    """A picture of the characters of these names, or of all, and how many it has. Needs matplotlib.

    Raises InputError `unknown_character`.
    """
    from ..realizer.pictures.contact_sheet import draw_characters as drawn  # matplotlib, an extra

    characters = load_characters()
    figures = {name: characters.named(name).figure for name in names or characters.by_name}
    bodies = {name: (Skeleton.standing(Proportions(each.physique)), each.looks) for name, each in figures.items()}
    return drawn(bodies), len(bodies)

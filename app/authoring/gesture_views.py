"""Gestures and bodies as authors look at them: by name, with poses that are out of reach, at each level, drawn."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from ..errors import InputError
from ..model import Hand, Level
from ..realizer.arms.plausibility import doubts
from ..realizer.body.proportions import Proportions
from ..realizer.body.skeleton import Skeleton
from ..realizer.gestures.gesture import Clip, Definition
from ..realizer.gestures.library import SUFFIX, Library, clip, gesture_files, read_definitions
from .catalogue import load_characters, load_gestures, shown_path

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

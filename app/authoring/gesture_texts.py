"""Checks the text of a gesture as its author writes it (Gesture Engine §4.3): reports every mistake with its place, and
poses that the body cannot take."""

from dataclasses import dataclass
from pathlib import Path

from ..errors import AuthoringError, InputError, Mistake
from ..realizer.arms.plausibility import Doubt, doubts
from ..realizer.body.skeleton import Skeleton
from ..realizer.gestures.gesture import Definition
from ..realizer.gestures.library import parse_definitions
from ..suggestions import did_you_mean

NAME = Path("gesture")
"""The name in messages of a text without a file."""


@dataclass(frozen=True, slots=True)
class CheckedText:
    """The gestures that a text defines, if it has no mistakes, and doubts about them."""

    text: str
    definitions: tuple[Definition, ...] = ()
    mistakes: tuple[Mistake, ...] = ()
    doubts: tuple[Doubt, ...] = ()


def check_text(text: str, skeleton: Skeleton) -> CheckedText:
    """The gestures of a text in the gesture language (docs/gesture-language.md), or all its mistakes."""
    try:
        definitions = parse_definitions(text, NAME)
    except AuthoringError as error:
        return CheckedText(text, mistakes=error.mistakes)
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

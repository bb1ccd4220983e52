"""Communicative functions as semantic tags (NGS §3.2): the thin layer between words and gestures."""

from collections.abc import Collection, Iterable, Mapping

from ..model import PLAIN, Function
from .annotation.model import TaggedWords


def tag_of(function: Function) -> str:
    """The tag of a function: its class, and its subtype where the class has several."""
    return function.class_name if function.subtype == PLAIN else f"{function.class_name}.{function.subtype}"


def tags_of(functions: Iterable[Function]) -> tuple[TaggedWords, ...]:
    """The tags of the functions that were kept."""
    return tuple(TaggedWords(tag_of(each), each.first, each.last) for each in functions if each.kept)


def every_tag(functions: Mapping[str, Collection[str]]) -> frozenset[str]:
    """The tags that functions can have, by class and subtype; a class alone stands for its subtypes."""
    subtypes = {f"{name}.{subtype}" for name, own in functions.items() for subtype in own if subtype != PLAIN}
    return frozenset({*functions, *subtypes})

"""Reads `aliases.yaml` in the gesture folder: lexemes of other BML dialects, by the category of ours that shows
them."""

import re
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

from ...errors import AuthoringError
from ...suggestions import did_you_mean
from ...yaml_files import Entry, Source

ALIASES = "aliases.yaml"

_LEXEME = re.compile(r"[A-Z][A-Z0-9]*(_[A-Z0-9]+)*")


class Aliases(Entry):
    """The file format: for each category, its aliases."""

    aliases: Mapping[str, tuple[str, ...]]


def read_aliases(path: Path, categories: Collection[str]) -> Mapping[str, str]:
    """Our category by foreign lexeme. Raises AuthoringError with all mistakes, such as categories without gestures."""
    source = Source(path)
    listed = source.validated(Aliases).aliases
    mistakes = [source.mistake(where, told) for where, told in _mistakes(listed, categories)]
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return {lexeme: category for category, lexemes in listed.items() for lexeme in lexemes}


def _mistakes(
    listed: Mapping[str, tuple[str, ...]], categories: Collection[str]
) -> Iterator[tuple[tuple[str | int, ...], str]]:
    seen: dict[str, str] = {}
    for category, lexemes in listed.items():
        if category not in categories:
            yield ("aliases", category), f"no gesture shows {category}{did_you_mean(category, categories)}"
        for position, lexeme in enumerate(lexemes):
            where = ("aliases", category, position)
            if not _LEXEME.fullmatch(lexeme):
                yield where, f"{lexeme!r}: lexemes are written in capitals, words joined by one underscore"
            elif lexeme in categories:
                yield where, f"{lexeme} has gestures of its own"
            elif lexeme in seen:
                yield where, f"{lexeme} is listed under {seen[lexeme]} already"
            seen.setdefault(lexeme, category)

"""A character who never does something does something else instead, where its file says what (docs/characters.md)."""

from collections.abc import Iterator
from dataclasses import replace
from types import MappingProxyType

from ...model import Channel, Demand
from ..candidates.demands import banned_by, meant
from ..reading.families import Families
from .overlays import Character

WHOLE_LINE = 1_000_000
"""A last word that no line has."""


def abstaining(character: Character, families: Families) -> Character:
    """The character with the behaviours it never shows replaced by those it shows instead; whatever asks for them
    (rules, the reading, targets) then has the others."""
    entries, stands_for = dict(character.entries), dict[str, str]()
    for what, instead in character.never.items():
        if instead is not None:
            for name in meant(what, families, character.entries):
                if character.entries[name].channel is character.entries[instead].channel:
                    entries[name] = replace(character.entries[instead], name=name)
                    stands_for[name] = character.entries[name].lexeme
    return replace(character, entries=MappingProxyType(entries), stands_for=stands_for) if stands_for else character


def forbidden(character: Character) -> Iterator[Demand]:
    """What the character never shows, on any word."""
    for what in character.never:
        yield Demand(what, 0, WHOLE_LINE, always=False, by=f"the character {character.name}")


def never_shown(character: Character, families: Families) -> Iterator[tuple[Channel, str]]:
    """The channels and lexemes of what the character never shows."""
    for ban in banned_by(forbidden(character), families, character.entries):
        yield from (character.lexemes[name] for name in ban.names)

"""Patterns of words, as authors write them in `lexicon/acting/slots.yaml`.

A pattern is a row of elements. An element is a word (in its form or as its lemma), several with `|` between them, a
named set of words in `<>`, a number `#`, or a part of speech or tag in capitals; `word/POS+TAG` wants the part of
speech too, `?` makes an element optional, `@` marks the word that names a thing, and `...` stands for up to four words.
Punctuation is a word of its own, so that a pattern crosses none that it does not name.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from ...model import Token

MOST_BETWEEN = 4
_GAP = "..."
_QUESTION_MARK = "?"
_ELEMENT = re.compile(r"(?P<at>@?)(?P<words>[^/?@\s]+)(?:/(?P<parts>[A-Z$]+(?:\+[A-Z$]+)*))?(?P<optional>\??)")
_PARTS = re.compile(r"[A-Z$]{2,}(\|[A-Z$]{2,})*")
_SET = re.compile(r"<([a-z_]+)>")
NUMBER = "#"


@dataclass(frozen=True, slots=True)
class PatternElement:
    """One element: words, parts of speech, or (`gap`) any words; `number` matches number words."""

    words: frozenset[str] = frozenset()
    parts: frozenset[str] = frozenset()
    number: bool = False
    optional: bool = False
    names: bool = False
    gap: bool = False

    def matches(self, token: Token, numbers: Mapping[str, float]) -> bool:
        """Whether it stands for this token."""
        if self.gap:
            return token.part_of_speech != "PUNCT"
        if self.parts and self.parts.isdisjoint((token.part_of_speech, token.tag)):
            return False
        if self.number:
            return number_of(token, numbers) is not None
        return not self.words or not self.words.isdisjoint((token.text.lower(), token.lemma.lower()))


@dataclass(frozen=True, slots=True)
class PatternMatch:
    """Tokens `first` to `last` that a pattern matches; `named` is the one that names a thing, `number` a number."""

    first: int
    last: int
    named: int | None = None
    number: int | None = None


def number_of(token: Token, numbers: Mapping[str, float]) -> float | None:
    """The value of a number word or of digits; None if it is neither."""
    text = token.text.lower()
    if text.isascii() and text.isdigit():
        return float(text)
    return numbers.get(text)


def read_pattern(text: str, sets: Mapping[str, Collection[str]]) -> tuple[PatternElement, ...]:
    """The elements of a pattern. Raises ValueError with a message for its author."""
    elements = tuple(_read_element(part, sets) for part in text.split())
    if not elements or all(each.optional or each.gap for each in elements):
        raise ValueError(f"{text!r} needs a word that is not optional")
    return elements


def _read_element(text: str, sets: Mapping[str, Collection[str]]) -> PatternElement:
    if text == _GAP:
        return PatternElement(gap=True)
    if text == _QUESTION_MARK:
        return PatternElement(frozenset({text}))
    found = _ELEMENT.fullmatch(text)
    if found is None:
        raise ValueError(f"{text!r} is not an element: write word, one|other, <set>, #, NOUN, word/NOUN, ... or ?")
    words, parts = found["words"], set((found["parts"] or "").split("+")) - {""}
    optional, names = bool(found["optional"]), bool(found["at"])
    if words == NUMBER:
        return PatternElement(parts=frozenset(parts), number=True, optional=optional, names=names)
    if _PARTS.fullmatch(words):
        return PatternElement(parts=frozenset(words.split("|")), optional=optional, names=names)
    return PatternElement(frozenset(_words(words, sets)), frozenset(parts), optional=optional, names=names)


def _words(text: str, sets: Mapping[str, Collection[str]]) -> Iterator[str]:
    for word in text.split("|"):
        named = _SET.fullmatch(word)
        if named and named[1] not in sets:
            raise ValueError(f"no set is called {named[1]!r}")
        yield from sets[named[1]] if named else (word,)


def vocabulary_of(tokens: Iterable[Token]) -> frozenset[str]:
    """All forms and lemmas of a line."""
    return frozenset(word for token in tokens for word in (token.text.lower(), token.lemma.lower()))


def possible(pattern: Iterable[PatternElement], vocabulary: frozenset[str]) -> bool:
    """Whether a line of this vocabulary has all words that a pattern cannot do without: most are told apart so."""
    for each in pattern:  # noqa: SIM110  # a generator takes twice as long
        if each.words and not each.optional and each.words.isdisjoint(vocabulary):
            return False
    return True


def find(
    pattern: Sequence[PatternElement], tokens: Sequence[Token], numbers: Mapping[str, float], start: int = 0
) -> Iterator[PatternMatch]:
    """The matches of a pattern from token `start` on, the longest at each place."""
    for first in range(start, len(tokens)):
        ends = list(_ends(pattern, tokens, numbers, first))
        if ends:
            last, taken = max(ends, key=lambda end: end[0])
            named = [at for at, element in taken if element.names]
            number = [at for at, element in taken if element.number]
            yield PatternMatch(first, last, named[-1] if named else None, number[0] if number else None)


def _ends(
    pattern: Sequence[PatternElement], tokens: Sequence[Token], numbers: Mapping[str, float], at: int
) -> Iterator[tuple[int, tuple[tuple[int, PatternElement], ...]]]:
    """The last tokens of all ways in which the pattern matches from `at` on, with which token each element took."""
    if not pattern:
        yield at - 1, ()
        return
    element, rest = pattern[0], pattern[1:]
    if element.optional or element.gap:
        yield from _ends(rest, tokens, numbers, at)
    for taken in range(1, (MOST_BETWEEN if element.gap else 1) + 1):
        if at + taken > len(tokens) or not element.matches(tokens[at + taken - 1], numbers):
            return
        for last, others in _ends(rest, tokens, numbers, at + taken):
            yield last, ((at + taken - 1, element), *others)

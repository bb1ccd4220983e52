"""Finds the words and phrases of `lexicon/en/` in an utterance, with a trie (paper §3.3, §3.7).

A file has one class in groups: words that share a subtype and conditions. A phrase's words match the transcript's
words, or the parts into which the parser splits them ("that" in "that's"); with `match: lemma` also their lemmas ("turn
into" finds "turning into"). `...` in a phrase stands for up to three words, or none. A file's exceptions are phrases in
which its words do not mean its class ("no wonder" is not a negation). Neither a phrase nor a condition extends across
punctuation. Among overlapping matches of one class the longest counts. The cost does not depend on the number of
entries.
"""

import re
from collections.abc import Iterable, Iterator, Set
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Literal

from pydantic import Field, field_validator

from ..errors import AuthoringError, Mistake, all_loaded
from ..model import Token, Utterance
from ..yaml_files import Entry, Source
from .chaining.facts import normalized_word

_HYPHENATED = re.compile(r"\w+(-\w+)+$")
"""One word of several parts, which mean nothing by themselves: "uh-huh" is not "uh"."""

CLOSING_MARKS = tuple(",.?!;:")
GAP = "..."
LONGEST_GAP = 3
SLOT = "{}"
"""The place in an example where each word of its group is inserted."""

PARTS_OF_SPEECH = frozenset(
    (
        "ADJ",
        "ADP",
        "ADV",
        "AUX",
        "CCONJ",
        "DET",
        "INTJ",
        "NOUN",
        "NUM",
        "PART",
        "PRON",
        "PROPN",
        "SCONJ",
        "SYM",
        "VERB",
        "X",
    )
)


class Conditions(Entry):
    """Words and the conditions on their context. Neighbours are tested by their form; the part of speech is that of the
    phrase's first word."""

    words: tuple[str, ...] = Field(min_length=1)
    match: Literal["form", "lemma"] = "form"
    part_of_speech: frozenset[str] = frozenset()
    after: frozenset[str] = frozenset()
    not_after: frozenset[str] = frozenset()
    before: frozenset[str] = frozenset()
    not_before: frozenset[str] = frozenset()

    @field_validator("part_of_speech")
    @classmethod
    def _known(cls, labels: frozenset[str]) -> frozenset[str]:
        unknown = ", ".join(sorted(labels - PARTS_OF_SPEECH))
        if unknown:
            raise ValueError(f"unknown part of speech {unknown}; known are {', '.join(sorted(PARTS_OF_SPEECH))}")
        return labels


class Group(Conditions):
    """Words of one subtype, with an example in which each of them must be found."""

    subtype: str = "plain"
    example: str

    @field_validator("example")
    @classmethod
    def _shows_the_words(cls, example: str) -> str:
        if SLOT not in example:
            raise ValueError(f"the example needs {SLOT} where the word stands")
        return example


class LexiconFile(Entry):
    """A file of `lexicon/en/`."""

    class_name: str = Field(alias="class")
    groups: tuple[Group, ...]
    exceptions: tuple[Conditions, ...] = ()


@dataclass(frozen=True, slots=True)
class LexicalEntry:
    """A word or phrase of the lexicon; `subtype` is None for an exception of its class."""

    phrase: str
    class_name: str
    subtype: str | None
    conditions: Conditions
    path: Path
    line: int
    example: str | None


@dataclass(frozen=True, slots=True)
class LexicalMatch:
    """An occurrence of `entry` in the words `first` to `last`, both included."""

    class_name: str
    subtype: str
    first: int
    last: int
    entry: LexicalEntry


@dataclass(slots=True)
class _Node:
    """A state of the trie, reached by the words of a phrase so far; mutable only while the lexicon loads."""

    forms: dict[str, "_Node"] = field(default_factory=dict)
    lemmas: dict[str, "_Node"] = field(default_factory=dict)
    gap: "_Node | None" = None
    entries: list[LexicalEntry] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class _Spelling:
    """The keys by which a word can be found: its text and its parts' texts, and its parts' lemmas, with their parts of
    speech. `closes` says that punctuation after it ends the phrase."""

    forms: dict[str, frozenset[str]]
    lemmas: dict[str, frozenset[str]]
    closes: bool


@dataclass(frozen=True, slots=True)
class _EntryMatch:
    entry: LexicalEntry
    words: tuple[int, ...]

    @property
    def length(self) -> int:
        return self.words[-1] - self.words[0] + 1


@dataclass(frozen=True, slots=True, eq=False)
class Lexicon:
    """All entries, and the trie that finds them; immutable and thread-safe."""

    entries: tuple[LexicalEntry, ...]
    root: _Node

    @classmethod
    def load(cls, folder: Path) -> "Lexicon":
        """The lexicon of every YAML file in `folder` that has a `class`; raises AuthoringError with all mistakes."""
        files = all_loaded(partial(_read, path) for path in sorted(folder.glob("*.yaml")))
        entries = tuple(entry for found in files for entry in found)
        return cls(entries, _trie(entries))

    def matches(self, utterance: Utterance) -> tuple[LexicalMatch, ...]:
        """The entries found, in order of their first words; per class the longest of overlapping ones."""
        spellings = _spellings(utterance)
        found = [match for start in range(len(spellings)) for match in _found_from(self.root, spellings, start)]
        return tuple(
            LexicalMatch(match.entry.class_name, match.entry.subtype, match.words[0], match.words[-1], match.entry)
            for match in _longest(found)
            if match.entry.subtype is not None
        )


def _read(path: Path) -> tuple[LexicalEntry, ...]:
    """The entries of a file; a file without `class` is not a file of words and has none. Raises AuthoringError."""
    source = Source(path)
    if not isinstance(source.value, dict) or "class" not in source.value:
        return ()
    entries = tuple(_entries(source, source.validated(LexiconFile)))
    if mistakes := tuple(_duplicates(source, entries)):
        raise AuthoringError(mistakes)
    return entries


def _entries(source: Source, content: LexiconFile) -> Iterator[LexicalEntry]:
    for kind, groups in (("groups", content.groups), ("exceptions", content.exceptions)):
        for position, group in enumerate(groups):
            subtype, example = (group.subtype, group.example) if isinstance(group, Group) else (None, None)
            for number, phrase in enumerate(group.words):
                line = source.mistake((kind, position, "words", number), "").line
                yield LexicalEntry(phrase, content.class_name, subtype, group, source.path, line, example)


def _duplicates(source: Source, entries: Iterable[LexicalEntry]) -> Iterator[Mistake]:
    """Entries that repeat an earlier one of the file: the same words under the same conditions."""
    seen: dict[tuple[str, object], int] = {}
    for entry in entries:
        key = (entry.phrase, entry.conditions.model_copy(update={"words": (), "subtype": "", "example": ""}))
        first = seen.setdefault(key, entry.line)
        if first != entry.line:
            text = source.lines[entry.line - 1]
            column = max(text.find(entry.phrase), 0) + 1
            yield Mistake(source.path, entry.line, column, f"{entry.phrase!r} is already in line {first}", text)


def _trie(entries: Iterable[LexicalEntry]) -> _Node:
    root = _Node()
    for entry in entries:
        node = root
        for word in entry.phrase.split():
            if word == GAP:
                node.gap = node.gap or _Node()
                node = node.gap
            else:
                edges = node.lemmas if entry.conditions.match == "lemma" else node.forms
                node = edges.setdefault(word.lower(), _Node())
        node.entries.append(entry)
    return root


def _spellings(utterance: Utterance) -> tuple[_Spelling, ...]:
    parts: list[list[Token]] = [[] for _ in utterance.words]
    for token in utterance.parse.tokens:
        parts[token.word].append(token)
    return tuple(_spelling(word.text, parts[word.index]) for word in utterance.words)


def _spelling(written: str, parts: list[Token]) -> _Spelling:
    text = normalized_word(written)
    parts = parts[-1:] if _HYPHENATED.match(text) else [part for part in parts if part.part_of_speech != "PUNCT"]
    forms = {normalized_word(part.text): frozenset((part.part_of_speech,)) for part in parts}
    lemmas = {part.lemma.lower(): frozenset((part.part_of_speech,)) for part in parts}
    forms[text] = frozenset(part.part_of_speech for part in parts)
    return _Spelling(forms, lemmas, closes=bool(text) and written.rstrip("\"')”’")[-1:] in CLOSING_MARKS)


def _found_from(root: _Node, spellings: tuple[_Spelling, ...], start: int) -> Iterator[_EntryMatch]:
    """Every entry whose words begin at `start` and whose conditions hold."""
    states: list[tuple[_Node, tuple[int, ...], frozenset[str]]] = [(root, (), frozenset())]
    while states:
        node, words, parts_of_speech = states.pop()
        here = words[-1] + 1 if words else start
        for entry in node.entries:
            if _holds(entry.conditions, spellings, words, parts_of_speech):
                yield _EntryMatch(entry, words)
        if words and spellings[words[-1]].closes:
            continue
        for edges, position in _edges(node, here):
            if position < len(spellings):
                for following, labels in _steps(edges, spellings[position]):
                    states.append((following, (*words, position), parts_of_speech if words else labels))


def _edges(node: _Node, here: int) -> Iterator[tuple[_Node, int]]:
    yield node, here
    if node.gap is not None:
        for skipped in range(LONGEST_GAP + 1):
            yield node.gap, here + skipped


def _steps(node: _Node, spelling: _Spelling) -> Iterator[tuple[_Node, frozenset[str]]]:
    for form, labels in spelling.forms.items():
        if form in node.forms:
            yield node.forms[form], labels
        if form in node.lemmas and form not in spelling.lemmas:
            yield node.lemmas[form], labels
    for lemma, labels in spelling.lemmas.items():
        if lemma in node.lemmas:
            yield node.lemmas[lemma], labels


def _holds(
    conditions: Conditions, spellings: tuple[_Spelling, ...], words: tuple[int, ...], parts_of_speech: frozenset[str]
) -> bool:
    before, after = _neighbours(spellings, words[0], words[-1])
    return (
        (not conditions.part_of_speech or bool(conditions.part_of_speech & parts_of_speech))
        and (not conditions.after or bool(conditions.after & before))
        and (not conditions.before or bool(conditions.before & after))
        and not conditions.not_after & before
        and not conditions.not_before & after
    )


def _neighbours(spellings: tuple[_Spelling, ...], first: int, last: int) -> tuple[Set[str], Set[str]]:
    """The forms of the words directly before and after, unless there is punctuation between."""
    beginning = first == 0 or spellings[first - 1].closes
    end = last + 1 == len(spellings) or spellings[last].closes
    before = frozenset[str]() if beginning else spellings[first - 1].forms.keys()
    return before, frozenset[str]() if end else spellings[last + 1].forms.keys()


def _longest(found: list[_EntryMatch]) -> list[_EntryMatch]:
    """The longest matches, such that no two of one class share a word."""
    taken: set[tuple[str, int]] = set()
    kept: list[_EntryMatch] = []
    for match in sorted(found, key=_rank):
        name = match.entry.class_name
        if any((name, word) in taken for word in match.words):
            continue
        taken.update((name, word) for word in match.words)
        kept.append(match)
    return sorted(kept, key=lambda match: (match.words[0], match.words[-1], match.entry.class_name))


def _rank(match: _EntryMatch) -> tuple[int, bool, int, int]:
    """Sort key: the longer match first, then exceptions, then the longer phrase ("could've" before "could")."""
    return -match.length, match.entry.subtype is not None, -len(match.entry.phrase), match.words[0]

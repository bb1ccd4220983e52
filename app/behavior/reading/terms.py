"""The named terms of each word of a line: the features of gesture choice besides the reading in context.

A term is a fact about a word that a rule, the parser or the voice has established: its function, the kind of sentence
it is in, its place in phrase and line, how it is said. Terms have names to which authors can give weights
(`lexicon/acting/weights.yaml`); their fitted weights are in models/acting/weights.json.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, TypeAlias

from pydantic import Field

from ...errors import AuthoringError, did_you_mean
from ...model import Function, Level, Token, Tone, Utterance
from ...yaml_files import Entry, Source

HEARD_TERMS = frozenset(
    {"voice(stressed)", *(f"agitation({level})" for level in Level), *(f"tone({tone})" for tone in Tone)}
)
"""The terms of the voice, which directed lines that are only read do not have."""

CLEAR_TONE = 0.4
"""The share from which a tone is a term of its words."""

_ENDS_SENTENCE = (".", "!", "?", "…")
_PERSONS = {
    "first": frozenset(("i", "me", "my", "mine", "myself", "we", "us", "our", "ours", "ourselves")),
    "second": frozenset(("you", "your", "yours", "yourself", "yourselves")),
}


Fact: TypeAlias = tuple[str, tuple[str | int | float, ...]]
"""A predicate of the rules and its arguments; spans are boundaries between words."""

Term: TypeAlias = tuple[str, int, int]
"""A term's name, and the first and last word that have it."""


class _TermLine(Entry):
    name: str
    span: Annotated[tuple[int, ...], Field(min_length=1, max_length=2)]


class _TermsFile(Entry):
    terms: dict[str, _TermLine]


def _mistakes(predicate: str, line: _TermLine, predicates: Mapping[str, int]) -> Iterator[str]:
    if predicate not in predicates:
        yield f"{predicate!r} is not a predicate of the rules{did_you_mean(predicate, predicates)}"
        return
    count = predicates[predicate]
    named = re.findall(r"\{(.*?)\}", line.name)
    for place in (*named, *map(str, line.span)):
        if place not in map(str, range(count)):
            yield f"{predicate} has the arguments 0 to {count - 1}, none called {place!r}"


@dataclass(frozen=True, slots=True)
class TermTable:
    """Which facts of the rules are terms, by predicate: the term's name, and the arguments that hold the first word and
    the one after the last, or the only word."""

    names: Mapping[str, str]
    spans: Mapping[str, tuple[int, ...]]

    @classmethod
    def load(cls, path: Path, predicates: Mapping[str, int]) -> "TermTable":
        """Loads lexicon/acting/terms.yaml for rules with these predicates and numbers of arguments; raises
        AuthoringError with every mistake."""
        source = Source(path)
        file = source.validated(_TermsFile)
        mistakes = tuple(
            source.mistake(("terms", predicate), message)
            for predicate, line in file.terms.items()
            for message in _mistakes(predicate, line, predicates)
        )
        if mistakes:
            raise AuthoringError(mistakes)
        return cls(
            names=MappingProxyType({predicate: line.name for predicate, line in file.terms.items()}),
            spans=MappingProxyType({predicate: line.span for predicate, line in file.terms.items()}),
        )

    def of_facts(self, facts: Iterable[Fact]) -> Iterator[Term]:
        """The terms that follow from facts."""
        for predicate, arguments in facts:
            if predicate in self.names:
                bounds = [int(arguments[place]) for place in self.spans[predicate]]
                last = bounds[1] - 1 if len(bounds) > 1 else bounds[0]
                yield self.names[predicate].format(*arguments), bounds[0], last


def terms_of(
    utterance: Utterance, functions: Iterable[Function], of_facts: Iterable[Term] = ()
) -> tuple[frozenset[str], ...]:
    """The terms of each word, in the order of the words."""
    found: list[set[str]] = [set() for _ in utterance.words]
    for name, first, last in (
        *_of_functions(functions),
        *_of_sentences(utterance),
        *_of_syntax(utterance),
        *_of_places(utterance),
        *_of_voice(utterance),
        *of_facts,
    ):
        for word in range(first, min(last, len(found) - 1) + 1):
            found[word].add(name)
    return tuple(map(frozenset, found))


def _of_functions(functions: Iterable[Function]) -> Iterator[Term]:
    for function in functions:
        if not function.kept:
            continue
        name = f"function({function.class_name})"
        yield name, function.first, function.last
        yield f"{name} here", function.last, function.last
        if function.subtype not in ("plain", ""):
            yield f"function({function.class_name}.{function.subtype})", function.first, function.last
        if function.given:
            yield f"given({function.class_name})", function.first, function.last


def _of_sentences(utterance: Utterance) -> Iterator[Term]:
    """The mood of each sentence, judged by its punctuation, and whether the sentence is short."""
    words = utterance.words
    ends = [word.index for word in words if word.text.rstrip("\"'”’)").endswith(_ENDS_SENTENCE)]
    bounds = [-1, *ends] if ends and ends[-1] == len(words) - 1 else [-1, *ends, len(words) - 1]
    for before, last in pairwise(bounds):
        mark = words[last].text.rstrip("\"'”’)")[-1:]
        mood = {"?": "question", "!": "exclamation", "…": "trailing off"}.get(mark, "statement")
        yield f"sentence({mood})", before + 1, last
        if last - before <= 3:
            yield "sentence(short)", before + 1, last


def _of_syntax(utterance: Utterance) -> Iterator[Term]:
    tokens = utterance.parse.tokens
    for token in tokens:
        if token.part_of_speech == "PUNCT":
            continue
        yield f"part_of_speech({token.part_of_speech})", token.word, token.word
        yield f"dependency({token.dependency})", token.word, token.word
        governor = tokens[token.head]
        if governor.index != token.index:
            yield f"under({governor.part_of_speech})", token.word, token.word
    yield from _of_persons(tokens)


def _of_persons(tokens: tuple[Token, ...]) -> Iterator[Term]:
    """The grammatical person of each verb's subject."""
    for token in tokens:
        if token.dependency.startswith("nsubj"):
            person = next((name for name, words in _PERSONS.items() if token.text.lower() in words), "third")
            yield f"subject({person} person)", tokens[token.head].word, tokens[token.head].word


def _of_places(utterance: Utterance) -> Iterator[Term]:
    count = len(utterance.words)
    if count:
        yield "line(first word)", 0, 0
        yield "line(last word)", count - 1, count - 1
        yield "line(short)" if count <= 6 else "line(long)" if count > 18 else "line(usual)", 0, count - 1
    for phrase in utterance.parse.phrases:
        yield f"phrase({phrase.kind}) head", phrase.head, phrase.head
        yield f"phrase({phrase.kind}) end", phrase.last, phrase.last
    for clause in utterance.parse.clauses:
        yield f"clause({clause.label}) end", clause.last, clause.last


def _of_voice(utterance: Utterance) -> Iterator[Term]:
    for word in utterance.words:
        if word.is_emphasised:
            yield "voice(stressed)", word.index, word.index
    if utterance.agitation and utterance.words:
        yield f"agitation({utterance.level})", 0, len(utterance.words) - 1
    if utterance.affect:
        for word in utterance.words:
            affect = utterance.affect.at(word.index)
            if affect.share(affect.tone) >= CLEAR_TONE:
                yield f"tone({affect.tone})", word.index, word.index

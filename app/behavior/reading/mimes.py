"""Mimes: bodily actions that a verb and its object name ("she knocked on the door").

The table is `lexicon/acting/mimes.yaml`.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Literal

from pydantic import Field

from ...errors import AuthoringError, did_you_mean
from ...model import Term, Token
from ...yaml_files import Entry, Source

MIME_LOG_ODDS = 1.0
"""What a verb adds to the log-odds of its mime."""

_DOERS = frozenset({"i", "you", "he", "she", "we", "they", "who"})
_OBJECTS = frozenset({"obj", "obl", "advmod", "xcomp", "iobj", "compound:prt", "acl", "nmod"})
_THINGS = frozenset({"obj", "obl"})
_SUBJECTS = "nsubj"
_ENDINGS = ("ing", "ed", "es", "s")


@dataclass(frozen=True, slots=True)
class Mime:
    """Words `first` to `last`, the verb and its object, name an action that behaviour `name` mimes; `verb` is its
    lemma."""

    name: str
    first: int
    last: int
    verb: str

    @property
    def part(self) -> Term:
        """What it adds to the worth of its behaviour."""
        return Term(f"mime of {self.verb!r}", MIME_LOG_ODDS)


@dataclass(frozen=True, slots=True)
class Action:
    """What behaviour `name` mimes: one of these verbs, with one of the objects if there are any, without the words with
    which it means something else; by anybody, or only by who is `told` to."""

    name: str
    verbs: frozenset[str]
    objects: frozenset[str]
    without: frozenset[str]
    told: bool


@dataclass(frozen=True, slots=True)
class MimeTable:
    """The actions by verb, in the order of the file, and the nouns that name people."""

    by_verb: Mapping[str, tuple[Action, ...]]
    people: frozenset[str]

    @classmethod
    def load(cls, path: Path, behaviors: Collection[str]) -> "MimeTable":
        """The table in a file. Raises AuthoringError with every mistake, among them behaviours that do not exist."""
        source = Source(path)
        file = source.validated(_MimesFile)
        mistakes = tuple(
            source.mistake(("mimes", name), f"no behaviour is called {name!r}{did_you_mean(name, behaviors)}")
            for name in file.mimes
            if name not in behaviors
        )
        if mistakes:
            raise AuthoringError(mistakes)
        by_verb: dict[str, tuple[Action, ...]] = {}
        for name, lines in file.mimes.items():
            for line in lines:
                for verb in line.verbs:
                    by_verb[verb] = (*by_verb.get(verb, ()), line.action(name))
        return cls(MappingProxyType(by_verb), frozenset(file.people))


def mimes_in(table: MimeTable, tokens: Sequence[Token]) -> tuple[Mime, ...]:
    """The mimes of a line, in the order of their verbs; of several for one verb the one that comes first in the
    file among those with an object, else among the others."""
    return tuple(mime for token in tokens if (mime := _mime(table, token, tokens)) is not None)


def _mime(table: MimeTable, verb: Token, tokens: Sequence[Token]) -> Mime | None:
    lemma = next((each for each in _lemmas(verb) if each in table.by_verb), None)
    if lemma is None or verb.part_of_speech != "VERB" or not _is_done(table, verb, tokens):
        return None
    actions = table.by_verb[lemma]
    governed = [each for each in tokens if each.head == verb.index and each.index != verb.index]
    fitting = (_found(action, verb, governed) for action in sorted(actions, key=_by_object))
    return next((replace(each, verb=lemma) for each in fitting if each is not None), None)


def _lemmas(verb: Token) -> Iterator[str]:
    """The verb's lemma, and what its form may be an inflection of where the lemma is not known ("climbe")."""
    text = verb.text.lower()
    yield from (verb.lemma.lower(), text)
    for ending in _ENDINGS:
        if text.endswith(ending):
            stem = text.removesuffix(ending)
            yield from (stem, f"{stem}e", stem[:-1])


def _by_object(action: Action) -> bool:
    return not action.objects


def _found(action: Action, verb: Token, governed: Sequence[Token]) -> Mime | None:
    words = {form for each in governed for form in (each.lemma.lower(), each.text.lower())}
    if words & action.without or (action.told and any(each.dependency.startswith(_SUBJECTS) for each in governed)):
        return None
    objects = [each for each in governed if each.dependency.partition(":")[0] in _OBJECTS]
    named = [each for each in objects if {each.lemma.lower(), each.text.lower()} & action.objects]
    if action.objects and not named:
        return None
    things = [each for each in objects if each.dependency in _THINGS and each.word > verb.word]
    far = [each.word for each in named or things][:1]
    return Mime(action.name, min((verb.word, *far)), max((verb.word, *far)), verb.lemma.lower())


def _is_done(table: MimeTable, verb: Token, tokens: Sequence[Token]) -> bool:
    """Whether a person does it, or nobody is named."""
    subjects = list(_subjects(verb, tokens))
    return all(
        each.text.lower() in _DOERS or each.part_of_speech == "PROPN" or each.lemma.lower() in table.people
        for each in subjects
    )


def _subjects(verb: Token, tokens: Sequence[Token]) -> Iterator[Token]:
    """The subjects of a verb, its own or those of the verb with which it is joined."""
    own = [each for each in tokens if each.head == verb.index and each.dependency.startswith(_SUBJECTS)]
    governor = tokens[verb.head]
    if own or governor.index == verb.index or verb.dependency not in ("conj", "xcomp"):
        yield from own
    else:
        yield from _subjects(governor, tokens)


_Lemma = Annotated[str, Field(pattern=r"^[a-z][a-z'-]*$")]
_Lemmas = Annotated[tuple[_Lemma, ...], Field(min_length=1)]


class _MimeLine(Entry):
    verbs: _Lemmas
    objects: tuple[_Lemma, ...] = ()
    without: tuple[_Lemma, ...] = ()
    doer: Literal["anybody", "told"] = "anybody"

    def action(self, name: str) -> Action:
        told = self.doer == "told"
        return Action(name, frozenset(self.verbs), frozenset(self.objects), frozenset(self.without), told)


class _MimesFile(Entry):
    people: _Lemmas
    mimes: dict[str, Annotated[tuple[_MimeLine, ...], Field(min_length=1)]]

"""Loads which mime shows which verb: `lexicon/acting/mimes.yaml`, with every mistake at its line and column."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Literal

from pydantic import Field

from ...errors import AuthoringError
from ...suggestions import did_you_mean
from ...yaml_files import Entry, Source


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
        file = source.validated(_File)
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


_Lemma = Annotated[str, Field(pattern=r"^[a-z][a-z'-]*$")]
_Lemmas = Annotated[tuple[_Lemma, ...], Field(min_length=1)]


class _Line(Entry):
    verbs: _Lemmas
    objects: tuple[_Lemma, ...] = ()
    without: tuple[_Lemma, ...] = ()
    doer: Literal["anybody", "told"] = "anybody"

    def action(self, name: str) -> Action:
        told = self.doer == "told"
        return Action(name, frozenset(self.verbs), frozenset(self.objects), frozenset(self.without), told)


class _File(Entry):
    people: _Lemmas
    mimes: dict[str, Annotated[tuple[_Line, ...], Field(min_length=1)]]

"""Finds the actions of a line that hands can mime: who drinks, knocks or digs, in whatever form and with whatever
object.

A verb is taken in its bodily sense where its doer is a person, or nobody is named because somebody is told or wants to
do it; and where none of the words is with it that give it another sense ("knock it off").
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from ...model import Term, Token
from .table import Action, MimeTable

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

"""Compares the functions and offered behaviours of lines before and after an edit of the rules.

Lines are compared without audio, because that is quick enough to try every edit: conditions on stress, pauses or
agitation do not hold. What is compared is what the mapping rules offer, not what is scheduled.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from ..errors import AuthoringError
from ..model import Function, Utterance, Word
from ..models import Understudy
from ..resources import resource_folder
from ..rules.derivation import understand
from ..rules.lexicon import SLOT, Lexicon
from ..rules.mapping import offer_movements
from ..text.transcript import read_transcript
from .rule_edits import Edits, rules_wrong, with_edits


@dataclass(frozen=True, slots=True)
class ComparedOffer:
    """A behaviour that a rule offers for a function, and the weight it has there."""

    name: str
    rule: str
    class_name: str
    first: int
    last: int
    weight: float


Said = TypeVar("Said", Function, ComparedOffer)


@dataclass(frozen=True, slots=True)
class LineChange:
    """A line for which something changed: the functions and offers that are gone, and the new ones."""

    id: str
    words: tuple[Word, ...]
    functions_before: tuple[Function, ...]
    functions_after: tuple[Function, ...]
    offers_before: tuple[ComparedOffer, ...]
    offers_after: tuple[ComparedOffer, ...]


@dataclass(frozen=True, slots=True)
class _LineReading:
    """The functions and offers for a line; the ids of functions, which depend on their count, are left out."""

    functions: tuple[Function, ...]
    offers: tuple[ComparedOffer, ...]


def example_lines(lexicon: Lexicon) -> Mapping[str, str]:
    """The example of every group of words, with the first of its words, and the bundled line, by file and example."""
    found: dict[str, str] = {}
    for entry in lexicon.entries:
        if entry.example:
            found.setdefault(f"{entry.path.name}: {entry.example}", entry.example.replace(SLOT, entry.phrase))
    bundled = (resource_folder("examples") / "example.txt").read_text(encoding="utf-8")
    return {"example.txt": bundled, **found}


def compare(understudy: Understudy, edits: Edits, lines: Mapping[str, str]) -> tuple[LineChange, ...]:
    """The lines (texts by id) that these edits change. Raises InputError `rules_wrong`, `unknown_file`, and for a text
    that cannot be used."""
    edited = with_edits(understudy, edits)
    most = understudy.language.settings.max_text_characters
    spoken = [read_transcript(text, max_characters=most) for text in lines.values()]
    parsed = understudy.language.parser.parse_all(spoken)
    utterances = [Utterance(words=words, parse=parse) for words, parse in zip(spoken, parsed, strict=True)]
    try:
        return tuple(
            change
            for line_id, utterance in zip(lines, utterances, strict=True)
            for change in _change(line_id, utterance, _read(understudy, utterance), _read(edited, utterance))
        )
    except AuthoringError as error:  # a rule that goes wrong where it runs
        raise rules_wrong(error) from None


def _change(line_id: str, utterance: Utterance, before: _LineReading, after: _LineReading) -> Iterator[LineChange]:
    if before != after:
        yield LineChange(
            line_id,
            utterance.words,
            functions_before=_without(before.functions, after.functions),
            functions_after=_without(after.functions, before.functions),
            offers_before=_without(before.offers, after.offers),
            offers_after=_without(after.offers, before.offers),
        )


def _read(understudy: Understudy, utterance: Utterance) -> _LineReading:
    known = understand(understudy.language.rules, utterance)
    offered = offer_movements(understudy.behavior.rules, utterance, known.functions, seed=0, facts=known.facts)
    offers = (
        ComparedOffer(
            movement.name, movement.rule, each.function.class_name, movement.first, movement.last, choice.weight
        )
        for each in offered
        for choice in each.alternatives
        for movement in choice.movements
        if each.function is not None
    )
    return _LineReading(tuple(map(_anonymous, known.functions)), tuple(offers))


def _anonymous(function: Function) -> Function:
    """The function without id and reasons, so that two are equal if they say the same of the same words."""
    return replace(function, id="", lost_to=None, because=())


def _without(these: Sequence[Said], those: Sequence[Said]) -> tuple[Said, ...]:
    return tuple(one for one in these if one not in those)

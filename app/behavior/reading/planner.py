"""What planning needs, loaded once: the encoder, the weights of the choice, and the tables of authors.

Authors may set weights by hand, on top of the fitted ones, in `lexicon/acting/weights.yaml`: how much a term speaks for
or against a family of gestures, a kind of head movement or a face. A weight is in log-odds: 0.7 doubles the odds, -0.7
halves them; `any` applies to every family of gestures. All mistakes in the file are reported at once, with their
places.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Annotated

from pydantic import Field

from ...errors import AuthoringError, did_you_mean
from ...model import SingleArray
from ...yaml_files import Entry, Source
from .choice_model import ChoiceModel
from .encoder import Encoder
from .families import Families, merged
from .mimes import MimeTable
from .terms import HEARD_TERMS, TermTable
from .worths import shown_by_lexemes

ANY = "any"
HEAVIEST = 10.0
"""The largest absolute weight; beyond it a term would settle every choice alone."""

_Weight = Annotated[float, Field(ge=-HEAVIEST, le=HEAVIEST, allow_inf_nan=False)]


class _WeightsFile(Entry):
    terms: dict[str, dict[str, _Weight]]


@dataclass(frozen=True, slots=True)
class TermNames:
    """The terms that there are: those `named`, and those that fit one of the `patterns`."""

    named: frozenset[str]
    patterns: tuple[re.Pattern[str], ...] = ()

    def __contains__(self, term: object) -> bool:
        return term in self.named or any(pattern.fullmatch(str(term)) for pattern in self.patterns)

    def __iter__(self) -> Iterator[str]:
        return iter(self.named)

    def __len__(self) -> int:
        return len(self.named)

    @classmethod
    def of(
        cls, fitted: Collection[str], of_facts: Iterable[str], classes: Mapping[str, Collection[str]]
    ) -> "TermNames":
        """The `fitted` terms, those of the voice, those of all functions by class and subtypes, and those that facts
        give, with {0} for an argument."""
        kinds = (f"{kind}.{subtype}" for kind, subtypes in classes.items() for subtype in subtypes)
        functions = {f"function({kind})" for kind in (*classes, *kinds)}
        own = {name for kind in classes for name in (f"function({kind}) here", f"given({kind})")}
        names = tuple(of_facts)
        open_ended = (name for name in names if "{" in name)
        patterns = (re.compile(re.sub(r"\\{\d\\}", ".+", re.escape(name))) for name in open_ended)
        whole = (name for name in names if "{" not in name)
        return cls(frozenset({*fitted, *HEARD_TERMS, *functions, *own, *whole}), tuple(patterns))


def load_weights(
    path: Path, families: Collection[str], terms: Collection[str], kinds: Collection[str] = ()
) -> Mapping[str, Mapping[str, float]]:
    """Weights by term and by family or kind of head movement and face; raises AuthoringError for a term, family or kind
    that does not exist."""
    source = Source(path)
    file = source.validated(_WeightsFile)
    mistakes = []
    for term, by_family in file.terms.items():
        if term not in terms:
            mistakes.append(source.mistake(("terms", term), f"{term!r} is not a term{did_you_mean(term, terms)}"))
        for family in by_family:
            if family != ANY and family not in families and family not in kinds:
                told = f"{family!r} is no family of gestures and no kind of head movement or face"
                told += did_you_mean(family, (*families, *kinds))
                mistakes.append(source.mistake(("terms", term, family), told))
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return MappingProxyType({term: _of_all(by_family, families, kinds) for term, by_family in file.terms.items()})


def _of_all(by_family: Mapping[str, float], families: Collection[str], kinds: Collection[str]) -> Mapping[str, float]:
    """The weights of all families, the weight for `any` plus the family's own, and those of kinds."""
    of_any = by_family.get(ANY, 0.0)
    of_families = {family: of_any + by_family.get(family, 0.0) for family in families}
    return MappingProxyType(of_families | {kind: by_family[kind] for kind in kinds if kind in by_family})


@dataclass(frozen=True, slots=True, eq=False)
class Planner:
    """The models of planning, loaded once: the encoder, the weights, how much each lexeme shows each family (L, F) with
    the lexemes' names, the lemmas without which a family cannot be shown (mimes: "drink", "phone"), and which verb is
    shown by which mime."""

    encoder: Encoder
    choice: ChoiceModel
    lexemes: Mapping[str, int]
    shown: SingleArray
    needed_lemmas: Mapping[str, frozenset[str]]
    mimes: MimeTable
    terms: TermTable
    kind_weights: Mapping[str, Mapping[str, float]]

    @classmethod
    def load(
        cls,
        folders: tuple[Path, Path],
        families: Families,
        predicates: Mapping[str, int],
        classes: Mapping[str, Collection[str]],
    ) -> "Planner":
        """Loads from the `folders` models/acting and lexicon/acting; `predicates` are those of the rules with their
        numbers of arguments, `classes` those of functions with their subtypes.

        Raises ServiceError `model_unreadable`, and AuthoringError for the weights and terms of authors.
        """
        models, lexicon = folders
        choice = ChoiceModel.load(models / "weights.json")
        table = TermTable.load(lexicon / "terms.yaml", predicates)
        names = TermNames.of(choice.terms, table.names.values(), classes)
        kinds = (*choice.head, *choice.face)
        authored = load_weights(lexicon / "weights.yaml", choice.families, names, kinds)
        return cls(
            encoder=Encoder.load(models / "encoder.onnx"),
            choice=choice.with_weights(authored),
            lexemes=MappingProxyType({lexeme: column for column, lexeme in enumerate(families.shows)}),
            shown=shown_by_lexemes(families.shows, choice.families),
            needed_lemmas=MappingProxyType(dict(_needed_lemmas(families))),
            mimes=MimeTable.load(lexicon / "mimes.yaml", families.gesture_names),
            terms=table,
            kind_weights=MappingProxyType(
                {term: {kind: by[kind] for kind in kinds if by.get(kind)} for term, by in authored.items()}
            ),
        )


def _needed_lemmas(families: Families) -> Iterator[tuple[str, frozenset[str]]]:
    for family, behaviors in families.gesture.items():
        if all(behavior.lemmas for behavior in behaviors):
            yield merged(family), frozenset[str]().union(*(behavior.lemmas for behavior in behaviors))

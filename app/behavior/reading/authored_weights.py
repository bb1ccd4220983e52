"""Loads weights that authors set by hand, on top of the fitted ones: how much a term speaks for or against a family of
gestures, a kind of head movement or a face.

Read from `lexicon/acting/weights.yaml`. A weight is in log-odds: 0.7 doubles the odds, -0.7 halves them; `any` applies
to every family of gestures. All mistakes in the file are reported at once, with their places.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Annotated

from pydantic import Field

from ...errors import AuthoringError, did_you_mean
from ...yaml_files import Entry, Source
from .terms import HEARD_TERMS

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
        patterns = (re.compile(re.sub(r"\\{\d\\}", ".+", re.escape(name))) for name in of_facts)
        return cls(frozenset({*fitted, *HEARD_TERMS, *functions, *own}), tuple(patterns))


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
            mistakes.append(source.mistake(("terms", term), f"{term!r} is no term{did_you_mean(term, terms)}"))
        for family in by_family:
            if family != ANY and family not in families and family not in kinds:
                told = f"{family!r} is no family of gestures{did_you_mean(family, (*families, *kinds))}"
                mistakes.append(source.mistake(("terms", term, family), told))
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return MappingProxyType({term: _of_all(by_family, families, kinds) for term, by_family in file.terms.items()})


def _of_all(by_family: Mapping[str, float], families: Collection[str], kinds: Collection[str]) -> Mapping[str, float]:
    """The weights of all families, the weight for `any` plus the family's own, and those of kinds."""
    of_any = by_family.get(ANY, 0.0)
    of_families = {family: of_any + by_family.get(family, 0.0) for family in families}
    return MappingProxyType(of_families | {kind: by_family[kind] for kind in kinds if kind in by_family})

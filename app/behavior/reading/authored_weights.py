"""Loads weights that authors set by hand, on top of the fitted ones: how much a term speaks for or against a family.

Read from `lexicon/acting/weights.yaml`. A weight is in log-odds: 0.7 doubles the odds, -0.7 halves them; `any` applies
to every family. All mistakes in the file are reported at once, with their places.
"""

from collections.abc import Collection, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Annotated

from pydantic import Field

from ...errors import AuthoringError
from ...suggestions import did_you_mean
from ...yaml_files import Entry, Source

ANY = "any"
HEAVIEST = 10.0
"""The largest absolute weight; beyond it a term would settle every choice alone."""

_Weight = Annotated[float, Field(ge=-HEAVIEST, le=HEAVIEST, allow_inf_nan=False)]


class _WeightsFile(Entry):
    terms: dict[str, dict[str, _Weight]]


def load_weights(path: Path, families: Collection[str], terms: Collection[str]) -> Mapping[str, Mapping[str, float]]:
    """Weights by term and family; raises AuthoringError for a term or family that does not exist."""
    source = Source(path)
    file = source.validated(_WeightsFile)
    mistakes = []
    for term, by_family in file.terms.items():
        if term not in terms:
            mistakes.append(source.mistake(("terms", term), f"{term!r} is no term{did_you_mean(term, terms)}"))
        for family in by_family:
            if family != ANY and family not in families:
                told = f"{family!r} is no family of gestures{did_you_mean(family, families)}"
                mistakes.append(source.mistake(("terms", term, family), told))
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return MappingProxyType({term: _of_all(by_family, families) for term, by_family in file.terms.items()})


def _of_all(by_family: Mapping[str, float], families: Collection[str]) -> Mapping[str, float]:
    """The weights of all families: the weight for `any` plus the family's own."""
    of_any = by_family.get(ANY, 0.0)
    return MappingProxyType({family: of_any + by_family.get(family, 0.0) for family in families})

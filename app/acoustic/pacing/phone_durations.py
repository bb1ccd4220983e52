"""How long speech sounds usually last, read from `lexicon/phone_durations.yaml`; every mistake in it is reported at
once, with its place. Where only the times of words are known, their sounds share them in proportion.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import accumulate, pairwise
from pathlib import Path
from typing import Annotated, Self

from pydantic import Field, RootModel

from ...errors import AuthoringError, Mistake, did_you_mean
from ...model import Interval, Phone, Word
from ...model.tables import PHONES
from ...yaml_files import Source

FILE = "phone_durations.yaml"
LABELS = frozenset(phone for phones in PHONES.values() for phone in phones) | {"HH"}

_Seconds = Annotated[float, Field(gt=0, le=1, strict=False)]


@dataclass(frozen=True, slots=True)
class PhoneDurations:
    """Seconds by ARPABET label, of all 39."""

    usual_s: Mapping[str, float]

    @classmethod
    def load(cls, path: Path) -> Self:
        """Raises AuthoringError with every mistake."""
        source = Source(path)
        read = source.validated(_DurationsFile).root
        if mistakes := tuple(_wrong(source, read)):
            raise AuthoringError(mistakes)
        return cls(read)

    def of(self, phones: tuple[Phone, ...]) -> float:
        """How long these usually last together, in seconds."""
        return sum(self.usual_s[phone.label] for phone in phones)

    def spread(self, word: Word, interval: Interval) -> Word:
        """The word at that time, its sounds after one another in it."""
        shares = [0.0, *accumulate(self.usual_s[phone.label] for phone in word.phones)]
        edges = [round(interval.start_s + interval.duration_s * share / (shares[-1] or 1), 3) for share in shares]
        phones = tuple(
            replace(phone, interval=Interval(begin_s, end_s))
            for phone, (begin_s, end_s) in zip(word.phones, pairwise(edges), strict=True)
        )
        return replace(word, interval=interval, phones=phones, spread=True)


class _DurationsFile(RootModel[dict[str, _Seconds]]):
    """A duration a label."""


def _wrong(source: Source, read: Mapping[str, float]) -> Iterator[Mistake]:
    for label in read.keys() - LABELS:
        yield source.mistake((label,), f"no speech sound is called {label!r}{did_you_mean(label, LABELS)}")
    if missing := sorted(LABELS - read.keys()):
        yield source.mistake((), f"the durations of {', '.join(missing)} are missing")

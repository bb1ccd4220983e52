"""The speech of a line: words and phones with their times and prominence, and the agitation of the voice."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Self

EMPHASISED = 0.5
"""A word counts as emphasised if its emphasis exceeds this."""


class Level(StrEnum):
    """The speaker's agitation (paper §3.1): lax, modal or tense voice."""

    LOW = "low"
    MEDIUM = "medium"
    HIGH = "high"


@dataclass(frozen=True, slots=True)
class Interval:
    """An interval of time, in seconds from the start of the audio."""

    start_s: float
    end_s: float

    @property
    def duration_s(self) -> float:
        return self.end_s - self.start_s


@dataclass(frozen=True, slots=True)
class Phone:
    """A speech sound: ARPABET label without digit; `stress` is 0, 1 or 2 on vowels, None on consonants."""

    label: str
    interval: Interval
    stress: int | None = None


@dataclass(frozen=True, slots=True)
class Word:
    """A word of the transcript; without audio it has no interval, no phones and none of the measures.

    The measures are in [0, 1]: the stressed ratio is the paper's (§3.1.5), prominence is ours and needs phones, and
    emphasis is derived from the one that is chosen (`understudy.acoustic.stress`); everything else uses emphasis.
    `focus` is the word's share of the line's narrow focus, how likely it is the word that is stressed against the
    others; the shares of a line sum to 1. `spread` marks times that were guessed from loudness alone.
    """

    index: int
    text: str
    interval: Interval | None = None
    phones: tuple[Phone, ...] = ()
    stressed_ratio: float | None = None
    prominence: float | None = None
    emphasis: float | None = None
    focus: float | None = None
    spread: bool = False

    @property
    def is_emphasised(self) -> bool:
        return self.emphasis is not None and self.emphasis > EMPHASISED


@dataclass(frozen=True, slots=True)
class Filler:
    """A hesitation sound ("um", "uh") that was heard and is not a word of the transcript."""

    text: str
    interval: Interval


@dataclass(frozen=True, slots=True)
class StressThresholds:
    """The utterance's own 90th percentiles (paper §3.1.5); `f0_hz` is None when no frame is voiced."""

    energy_db: float
    f0_hz: float | None


@dataclass(frozen=True, slots=True)
class Agitation:
    """Memberships of the three levels (paper §3.1.4), in [0, 1], summing to 1."""

    low: float
    medium: float
    high: float

    @classmethod
    def certain(cls, level: Level) -> Self:
        """Full membership in one level."""
        return cls(**{each.value: float(each is level) for each in Level})

    @property
    def level(self) -> Level:
        """The level of maximal membership; the calmer one on a tie."""
        return max(Level, key=lambda level: float(getattr(self, level.value)))

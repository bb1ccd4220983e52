"""What is heard of a line: its words and speech sounds in time, how they stand out, how agitated the voice is."""

from dataclasses import dataclass
from enum import StrEnum

EMPHASISED = 0.5
"""A word's emphasis above which it counts as emphasised."""


class Level(StrEnum):
    """The speaker's agitation (paper §3.1): lax, modal or tense voice."""

    LOW = "low"
    MEDIUM = "medium"
    HIGH = "high"


@dataclass(frozen=True, slots=True)
class Interval:
    """A stretch of time, in seconds from the start of the audio."""

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
    """A word of the transcript; without audio it has no interval, no phones and nothing of what follows.

    How it stands out, in [0, 1]: the stressed ratio is the paper's (§3.1.5), prominence is ours and needs phones, and
    emphasis is whichever of them is set, on a scale of its own (`understudy.acoustic.stress.emphasis`), by which all
    else goes. `spread` tells that its times were guessed from loudness alone.
    """

    index: int
    text: str
    interval: Interval | None = None
    phones: tuple[Phone, ...] = ()
    stressed_ratio: float | None = None
    prominence: float | None = None
    emphasis: float | None = None
    spread: bool = False

    @property
    def is_emphasised(self) -> bool:
        return self.emphasis is not None and self.emphasis > EMPHASISED


@dataclass(frozen=True, slots=True)
class Filler:
    """A sound of hesitation ("um", "uh") that was heard and is no word of the transcript."""

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

    @property
    def level(self) -> Level:
        """The level of maximal membership; the calmer one on a tie."""
        return max(Level, key=lambda level: float(getattr(self, level.value)))

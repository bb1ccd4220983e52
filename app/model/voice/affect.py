"""How a line sounds: activation, valence and dominance of the voice, and the shares of its tones.

The three dimensions are in [-1, 1], 0 is neutral (Bozkurt et al., *Affect-Expressive Hand Gestures*, §3: continuous
activation, valence and dominance). The shares of the tones are in [0, 1] and sum to 1; where nothing is certain, they
lean towards neutral.
"""

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from math import exp
from types import MappingProxyType


class Tone(StrEnum):
    """A tone of voice."""

    NEUTRAL = "neutral"
    HAPPY = "happy"
    SAD = "sad"
    ANGRY = "angry"
    AFRAID = "afraid"
    DISGUSTED = "disgusted"
    SURPRISED = "surprised"


_TONES = tuple(Tone)
_NUMBERS: Mapping[Tone, int] = MappingProxyType({tone: number for number, tone in enumerate(_TONES)})


@dataclass(frozen=True, slots=True)
class Affect:
    """The feeling heard in a stretch of speech; `tones` has a share for each tone, in the order of `Tone`."""

    activation: float = 0.0
    valence: float = 0.0
    dominance: float = 0.0
    tones: tuple[float, ...] = (1.0, *(0.0,) * (len(Tone) - 1))

    def share(self, tone: Tone) -> float:
        """The share of one tone."""
        return self.tones[_NUMBERS[tone]]

    @property
    def tone(self) -> Tone:
        """The tone with the largest share; the first of `Tone` on a tie."""
        return _TONES[self.tones.index(max(self.tones))]


NEUTRAL = Affect()

PLACES: Mapping[Tone, tuple[float, float, float]] = MappingProxyType(
    {
        Tone.NEUTRAL: (0.0, 0.0, 0.0),
        Tone.HAPPY: (0.5, 0.8, 0.5),
        Tone.SAD: (-0.3, -0.6, -0.3),
        Tone.ANGRY: (0.6, -0.5, 0.3),
        Tone.AFRAID: (0.6, -0.6, -0.4),
        Tone.DISGUSTED: (0.4, -0.6, 0.1),
        Tone.SURPRISED: (0.7, 0.4, -0.1),
    }
)
"""The activation, valence and dominance of each tone: the mean ratings of Russell & Mehrabian (1977), "Evidence for a
three-factor theory of emotions", rounded; neutral is the origin."""

_REACH = 0.35
"""The distance over which the share of a tone falls to .61: half of that between neutral and the others, about."""


def affect_of_tone(tone: Tone) -> Affect:
    """The feeling of one tone and no other."""
    return Affect(*PLACES[tone], tones=tuple(float(each is tone) for each in Tone))


def affect_of_dimensions(activation: float, valence: float, dominance: float) -> Affect:
    """The feeling of three numbers in [-1, 1], with shares for the tones that lie near."""
    given = (activation, valence, dominance)
    near = [
        exp(-sum((a - b) ** 2 for a, b in zip(given, PLACES[tone], strict=True)) / (2 * _REACH**2)) for tone in Tone
    ]
    total = sum(near)
    return Affect(activation, valence, dominance, tuple(share / total for share in near))


@dataclass(frozen=True, slots=True)
class AffectTrack:
    """A feeling over time, as an author gives it: `affects` are those at `times_s`, which rise; between two times it
    changes evenly, before the first and after the last it stays."""

    times_s: tuple[float, ...]
    affects: tuple[Affect, ...]

    def at(self, time_s: float) -> Affect:
        """The feeling at a time."""
        after = bisect_right(self.times_s, time_s)
        if after == 0 or after == len(self.times_s):
            return self.affects[min(after, len(self.affects) - 1)]
        start_s, end_s = self.times_s[after - 1 : after + 1]
        share = (time_s - start_s) / (end_s - start_s)
        return mean_affect(self.affects[after - 1 : after + 1], (1 - share, share))


def mean_affect(affects: Sequence[Affect], weights: Sequence[float]) -> Affect:
    """The mean of several feelings, which count by `weights` (of a positive sum)."""
    total = sum(weights)

    def mean(values: Sequence[float]) -> float:
        return sum(weight * value for weight, value in zip(weights, values, strict=True)) / total

    return Affect(
        activation=mean([each.activation for each in affects]),
        valence=mean([each.valence for each in affects]),
        dominance=mean([each.dominance for each in affects]),
        tones=tuple(mean(shares) for shares in zip(*(each.tones for each in affects), strict=True)),
    )


@dataclass(frozen=True, slots=True)
class PhraseAffect:
    """The feeling of words `first` to `last`."""

    first: int
    last: int
    affect: Affect


@dataclass(frozen=True, slots=True)
class LineAffect:
    """The feeling of a whole line, and of each phrase between pauses; `given` if the author gave it."""

    line: Affect
    phrases: tuple[PhraseAffect, ...] = ()
    given: bool = False

    def at(self, word: int) -> Affect:
        """The feeling of the phrase that holds a word, else that of the line."""
        return next((each.affect for each in self.phrases if each.first <= word <= each.last), self.line)


@dataclass(frozen=True, slots=True)
class Manner:
    """How a movement is made, from the voice at its stroke: factors of the usual size and speed, and how tense it is; 1
    is usual."""

    amplitude: float = 1.0
    speed: float = 1.0
    tension: float = 1.0

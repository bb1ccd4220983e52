"""What activation, valence and dominance go with which tone: the feeling that a tone's name stands for, and the tones
that three numbers stand for.

The places of the tones are the mean ratings of Russell & Mehrabian (1977), "Evidence for a three-factor theory of
emotions", rounded; neutral is the origin.
"""

from collections.abc import Mapping
from math import exp
from types import MappingProxyType

from ...model import Affect, Tone

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
"""Activation, valence, dominance."""

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

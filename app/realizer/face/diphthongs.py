"""Splits the visemes of diphthongs in two, so that the mouth glides as in "how" from wide to round.

The schedule has one of fifteen visemes per phone (docs/references.md), which for a diphthong is that of its first
vowel. Where phones are known too, the last part of a diphthong gets the viseme of the vowel it glides to, with the jaw
less open and less articulated, since glides usually undershoot.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType

from ...model import Interval, Phone, Viseme, Word

GLIDES: Mapping[str, str] = MappingProxyType({"AY": "I", "EY": "I", "OY": "I", "AW": "U", "OW": "U"})
"""The viseme that each diphthong glides to."""

GLIDE_SHARE = 0.4
"""The share of the phone that the glide takes."""

GLIDE_ARTICULATION = 0.7
GLIDE_OPENING = 0.7
"""As a factor of the diphthong's own."""


def with_glides(visemes: tuple[Viseme, ...], words: tuple[Word, ...]) -> tuple[Viseme, ...]:
    """The visemes, with the last part of each diphthong as a viseme of its own."""
    gliding = [phone for word in words for phone in word.phones if phone.label in GLIDES]
    return tuple(_split(visemes, gliding)) if gliding else visemes


def _split(visemes: Iterable[Viseme], gliding: list[Phone]) -> Iterator[Viseme]:
    """Split a viseme at each glide within it; several phones of one shape may share a viseme."""
    coming = iter(sorted(gliding, key=lambda phone: phone.interval.end_s))
    phone = next(coming, None)
    for viseme in visemes:
        rest = viseme
        while phone and phone.interval.end_s <= rest.interval.end_s:
            start_s = phone.interval.end_s - GLIDE_SHARE * phone.interval.duration_s
            if rest.interval.start_s < start_s:
                yield replace(rest, interval=Interval(rest.interval.start_s, start_s))
                yield _glide(rest, GLIDES[phone.label], Interval(start_s, phone.interval.end_s))
                rest = replace(rest, interval=Interval(phone.interval.end_s, rest.interval.end_s))
            phone = next(coming, None)
        if rest.interval.duration_s > 0:
            yield rest


def _glide(viseme: Viseme, label: str, interval: Interval) -> Viseme:
    articulation = GLIDE_ARTICULATION * viseme.articulation
    return Viseme(label, interval, articulation, GLIDE_OPENING * viseme.opening)

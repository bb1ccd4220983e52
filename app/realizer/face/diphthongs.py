"""Diphthongs glide: the mouth of "how" goes from wide to round, which its one viseme does not say.

The schedule has one of fifteen visemes for each phone (shared/motion.md), that of the diphthong's first vowel. Where
the phones are known too, the last part of a diphthong is given to the shape of the vowel towards which it glides, with
the jaw less open; like all speakers' glides it does not get there wholly.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType

from ...model import Interval, Phone, Viseme, Word

GLIDES: Mapping[str, str] = MappingProxyType({"AY": "I", "EY": "I", "OY": "I", "AW": "U", "OW": "U"})
"""The viseme towards which each diphthong goes."""

GLIDE_SHARE = 0.4
"""The part of the phone in which it glides."""

GLIDE_ARTICULATION = 0.7
GLIDE_OPENING = 0.7
"""Of the diphthong's own."""


def with_glides(visemes: tuple[Viseme, ...], words: tuple[Word, ...]) -> tuple[Viseme, ...]:
    """The visemes, each diphthong's end made one of its own."""
    gliding = [phone for word in words for phone in word.phones if phone.label in GLIDES]
    return tuple(_split(visemes, gliding)) if gliding else visemes


def _split(visemes: Iterable[Viseme], gliding: list[Phone]) -> Iterator[Viseme]:
    """Phones may share a viseme with others of its shape, so a viseme is split as often as need be."""
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

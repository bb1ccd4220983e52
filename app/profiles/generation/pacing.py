"""A line's gestures at the speaker's rate, segment by segment (NGS §3.3, step 4).

The paper has one sequence for a whole text. Drawn so, the gestures of a long text crowd in one stretch and are rare in
another, as chance has it: 9 % were more than 4 s apart, 4.5 % of the speaker's, and 40 % of units were single gestures,
28 % of the speaker's (`python -m benchmarks.profiles`; now 34 %). Here each segment has what the rate allots to its
time, and what the segments before it were short of or had too much, one gesture at most. Times are seconds.
"""

import random
from collections.abc import Iterator, Sequence
from itertools import pairwise

from ...model import Word
from ..profile import FIRST, Profile
from ..segments import segments_of, spoken_s
from .candidates import Place
from .sequence import Drawn, drawn_gestures

MOST_OWED = 1.0
"""How many gestures a segment makes up at most for those before it."""


def paced_gestures(
    profile: Profile, places: Sequence[Place], words: Sequence[Word], *, rng: random.Random, likeliest: bool = False
) -> tuple[Drawn, ...]:
    """The gestures on the places of words in time."""
    made: list[Drawn] = []
    owed = 0.0
    for segment, lasting_s in enumerate(_segments_s(words)):
        allotted = owed + profile.gestures_per_minute * lasting_s / 60
        own = [place for place in places if place.segment == segment]
        before = made[-1].lexeme if made else FIRST
        drawn = drawn_gestures(profile, own, expected=allotted, rng=rng, likeliest=likeliest, before=before)
        owed = min(max(allotted - len(drawn), -MOST_OWED), MOST_OWED)
        made += drawn
    return tuple(made)


def _segments_s(words: Sequence[Word]) -> Iterator[float]:
    """How long each segment is spoken, with so much of the pause before it as counts."""
    segments = segments_of(words)
    until_s = [spoken_s(words, segments[:number]) for number in range(1, len(segments) + 1)]
    yield from (other - one for one, other in pairwise((0.0, *until_s)))

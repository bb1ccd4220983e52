"""Breath: the lungs fill where the voice pauses, and empty slowly while it speaks.

Conventions: seconds; the lungs' volume is 0 after a quiet breath out and 1 after a deep breath in. Who rests breathes
about 15 times a minute, two fifths of the time in; who speaks breathes in quickly and deeper in the pauses and before
the first word, and out over whole phrases, so that the rhythm is the speech's.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from ...model import FloatArray, Interval
from ..geometry.easing import through

QUIET_CYCLE_S = 4.0
INHALING_SHARE = 0.4
QUIET_DEPTH = 0.6
QUICK_BREATH_S = (0.35, 0.8)
SHORTEST_PAUSE_S = 0.25
SHORTEST_BETWEEN_S = 1.5
"""A pause sooner than this after the last breath needs no other."""


def lungs(
    times_s: FloatArray,
    phrases: Sequence[Interval],
    generator: np.random.Generator,
    *,
    cycle_s: float = QUIET_CYCLE_S,
) -> FloatArray:
    """The volume (T,), with breaths in the pauses between `phrases` (in order), and quiet ones of about `cycle_s` where
    nobody speaks."""
    during = Interval(float(times_s[0]), float(times_s[-1]))
    at_s, volumes = np.array(list(_knots(during, phrases, generator, cycle_s))).T
    return through(times_s, at_s, volumes)


def _knots(
    during: Interval, phrases: Sequence[Interval], generator: np.random.Generator, usual_s: float
) -> Iterator[tuple[float, float]]:
    """When the lungs are empty and when full, from before the first moment to after the last."""
    pauses = list(_pauses(phrases))
    now_s = during.start_s - usual_s * float(generator.uniform(1.0, 2.0))
    while now_s <= during.end_s:
        cycle_s, depth = usual_s * float(generator.uniform(0.85, 1.15)), QUIET_DEPTH
        inhaled_s = now_s + INHALING_SHARE * cycle_s
        for pause in pauses:
            if pause.start_s <= now_s < pause.end_s:
                inhaled_s, depth = now_s + float(np.clip(pause.end_s - now_s, *QUICK_BREATH_S)), 1.0
        yield now_s, 0.0
        yield inhaled_s, depth * float(generator.uniform(0.85, 1.0))
        due_s = now_s + cycle_s
        due_s = next((phrase.end_s for phrase in phrases if phrase.start_s <= due_s < phrase.end_s), due_s)
        soon_s = inhaled_s + SHORTEST_BETWEEN_S
        now_s = min([max(due_s, soon_s), *(pause.start_s for pause in pauses if pause.start_s >= soon_s)])
    yield now_s, 0.0


def _pauses(phrases: Sequence[Interval]) -> Iterator[Interval]:
    """Where there is time to breathe in: before the first phrase and between phrases."""
    if phrases:
        yield Interval(phrases[0].start_s - QUICK_BREATH_S[1], phrases[0].start_s)
    for phrase, following in pairwise(phrases):
        if following.start_s - phrase.end_s >= SHORTEST_PAUSE_S:
            yield Interval(phrase.end_s, following.start_s)

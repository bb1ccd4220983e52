"""Breathing: the lungs fill in speech pauses and empty slowly during phrases.

Conventions: seconds; lung volume is 0 after quiet expiration and 1 after deep inspiration. At rest people breathe about
15 times a minute, inhaling for two fifths of the cycle. Speakers inhale quickly and more deeply in pauses and before
the first word, and exhale over whole phrases.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from ...model import FloatArray, Interval
from ..geometry.easing import minimum_jerk_through

QUIET_CYCLE_S = 4.0
INHALING_SHARE = 0.4
QUIET_DEPTH = 0.6
QUICK_BREATH_S = (0.35, 0.8)
SHORTEST_PAUSE_S = 0.25
SHORTEST_BETWEEN_S = 1.5
"""A pause sooner than this after the last breath gets no breath of its own."""


def lung_volume(
    times_s: FloatArray,
    phrases: Sequence[Interval],
    generator: np.random.Generator,
    *,
    cycle_s: float = QUIET_CYCLE_S,
) -> FloatArray:
    """The lung volume (T,), with breaths in the pauses between `phrases` (in order), and quiet breathing with a period
    of about `cycle_s` where nobody speaks."""
    during = Interval(float(times_s[0]), float(times_s[-1]))
    at_s, volumes = np.array(list(_knots(during, phrases, generator, cycle_s))).T
    return minimum_jerk_through(times_s, at_s, volumes)


def _knots(
    during: Interval, phrases: Sequence[Interval], generator: np.random.Generator, usual_s: float
) -> Iterator[tuple[float, float]]:
    """The times of empty and full lungs with their volumes, from before the first time to after the last."""
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
    """The intervals in which to inhale: before the first phrase and between phrases."""
    if phrases:
        yield Interval(phrases[0].start_s - QUICK_BREATH_S[1], phrases[0].start_s)
    for phrase, following in pairwise(phrases):
        if following.start_s - phrase.end_s >= SHORTEST_PAUSE_S:
            yield Interval(phrase.end_s, following.start_s)

"""Statistics of generated or annotated gestures: shares of lexemes and hands, sizes of units, rate, strokes, offsets.

Shares of two distributions differ by half the sum of the differences, which is what would have to be moved. Times are
seconds; offsets are from the end of a word to that of its main stroke, without the lead.
"""

from collections import Counter
from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from statistics import fmean, pstdev
from typing import TypeVar

import numpy as np

from understudy.model import Hand, Word
from understudy.profiles.annotation.model import Annotation
from understudy.profiles.generation.script import GestureScript
from understudy.profiles.learning.observations import observed_gestures
from understudy.profiles.learning.tables import shares_of
from understudy.profiles.profile import Profile
from understudy.profiles.segments import segments_of, spoken_s, time_of

LONGEST_UNIT = 7
Named = TypeVar("Named", bound=Hashable)


@dataclass(frozen=True, slots=True)
class Statistics:
    """Of all gestures of a speaker, or of all scripts."""

    per_minute: float
    lexemes: Mapping[str, float]
    hands: Mapping[Hand, float]
    unit_sizes: Mapping[int, float]
    mean_unit: float
    strokes: float
    offset_s: float
    offset_deviation_s: float


def annotated_statistics(annotation: Annotation) -> Statistics:
    """Of an annotation."""
    phrases = annotation.phrases
    offsets_s = [each.offset_s for each in observed_gestures(annotation) if each.offset_s is not None]
    sizes = [len(unit.phrases) for unit in annotation.units]
    minutes = spoken_s(annotation.words, annotation.segments) / 60
    return Statistics(
        per_minute=len(phrases) / minutes,
        lexemes=shares_of(Counter(each.lexeme for each in phrases)),
        hands=shares_of(Counter(each.hand for each in phrases)),
        unit_sizes=_sizes(sizes),
        mean_unit=fmean(sizes),
        strokes=fmean(max(1, len(each.strokes)) for each in phrases),
        offset_s=fmean(offsets_s),
        offset_deviation_s=pstdev(offsets_s),
    )


def scripted_statistics(scripts: Sequence[GestureScript], words: Sequence[Word], profile: Profile) -> Statistics:
    """Of scripts of the same words."""
    made = [gesture for script in scripts for gesture in script.made]
    ends_s = {word.index: time_of(word).end_s for word in words}
    offsets_s = [each.strokes[0].end_s - ends_s[each.word] + profile.lead.main_s for each in made]
    sizes = [len(unit.gestures) for script in scripts for unit in script.units]
    minutes = spoken_s(words, segments_of(words)) / 60
    return Statistics(
        per_minute=len(made) / (len(scripts) * minutes),
        lexemes=shares_of(Counter(each.lexeme for each in made)),
        hands=shares_of(Counter(each.hand for each in made)),
        unit_sizes=_sizes(sizes),
        mean_unit=fmean(sizes),
        strokes=fmean(len(each.strokes) for each in made),
        offset_s=fmean(offsets_s),
        offset_deviation_s=pstdev(offsets_s),
    )


def moved(one: Mapping[Named, float], other: Mapping[Named, float]) -> float:
    """How much of a distribution would have to be moved to make it the other."""
    return sum(abs(one.get(name, 0.0) - other.get(name, 0.0)) for name in {*one, *other}) / 2


def chance(shares: Mapping[Named, float], number: int, *, draws: int = 500) -> float:
    """How much of so many drawn from a distribution would have to be moved to make it: what chance alone does."""
    rng = np.random.default_rng(0)
    likely = np.array(list(shares.values()))
    drawn = rng.multinomial(number, likely / likely.sum(), size=draws) / number
    return float(np.abs(drawn - likely).sum(axis=1).mean() / 2)


def _sizes(sizes: Iterable[int]) -> Mapping[int, float]:
    return shares_of(Counter(min(size, LONGEST_UNIT) for size in sizes))

"""How much each word stands out by the measure that is set: the one value that all that follows the voice goes by.

Rules emphasise by it, strokes fall on the word that has most of it, repeated strokes and dips of the head on the words
that have enough, and the mouth opens by it. Of the two measures prominence (`understudy.acoustic.stress.prominence`)
follows what listeners hear far better than the paper's stressed ratio (`understudy.acoustic.stress.stress`):
`benchmarks/acoustic/prominence.py`. A word whose phones are not known has the ratio alone, and is judged by that. Their
thresholds lie far apart; so both are brought to one scale, on which 0 is 0, the threshold is `EMPHASISED` and 1 is 1,
with straight lines between.
"""

from dataclasses import dataclass, replace
from typing import Literal

from ...model import EMPHASISED, Word

PROMINENT = 0.34
"""The prominence above which there are as many syllables as listeners hear stressed (`training/prominence.py`)."""

STRESSED = 0.1
"""The paper's stressed ratio (Figure 8)."""


@dataclass(frozen=True, slots=True)
class Measure:
    """Which measure of a word tells how much it stands out, and above which value of each a word is emphasised."""

    name: Literal["prominence", "ratio"] = "prominence"
    above_prominence: float = PROMINENT
    above_ratio: float = STRESSED


def with_emphasis(words: tuple[Word, ...], measure: Measure) -> tuple[Word, ...]:
    """The words; those that were heard with their emphasis, in thousandths."""
    return tuple(replace(word, emphasis=_emphasis(word, measure)) for word in words)


def _emphasis(word: Word, measure: Measure) -> float | None:
    if word.prominence is not None and measure.name == "prominence":
        return _scaled(word.prominence, measure.above_prominence)
    return None if word.stressed_ratio is None else _scaled(word.stressed_ratio, measure.above_ratio)


def _scaled(value: float, threshold: float) -> float:
    if value <= threshold:
        return round(EMPHASISED * value / threshold, 3) if threshold else 0.0
    return round(EMPHASISED + (1 - EMPHASISED) * (value - threshold) / (1 - threshold), 3)

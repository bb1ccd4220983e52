"""The emphasis of each word, from the selected measure of stress; all later stages use this value.

Rules test it, strokes fall on the word with the highest emphasis, repeated strokes and head dips on emphasized words,
and the mouth opens by it. Prominence (`understudy.acoustic.stress.prominence`) agrees with listeners far better than
the paper's stressed ratio (`understudy.acoustic.stress.stress`): `benchmarks/acoustic/prominence.py`. Words without
known phones have only the ratio and are judged by it. Since their thresholds differ, both are mapped to one scale,
piecewise linearly: 0 to 0, the threshold to `EMPHASISED`, 1 to 1.
"""

from dataclasses import dataclass, replace
from typing import Literal

from ...model import EMPHASISED, Word

PROMINENT = 0.34
"""The prominence above which as many syllables lie as listeners perceive as stressed (`training/prominence.py`)."""

STRESSED = 0.1
"""The paper's threshold of the stressed ratio (Figure 8)."""


@dataclass(frozen=True, slots=True)
class Measure:
    """The measure of emphasis, and the value of each measure above which a word is emphasized."""

    name: Literal["prominence", "ratio"] = "prominence"
    above_prominence: float = PROMINENT
    above_ratio: float = STRESSED


def with_emphasis(words: tuple[Word, ...], measure: Measure) -> tuple[Word, ...]:
    """The words; those with a measure get their emphasis, rounded to thousandths."""
    return tuple(replace(word, emphasis=_emphasis(word, measure)) for word in words)


def _emphasis(word: Word, measure: Measure) -> float | None:
    if word.prominence is not None and measure.name == "prominence":
        return _scaled(word.prominence, measure.above_prominence)
    return None if word.stressed_ratio is None else _scaled(word.stressed_ratio, measure.above_ratio)


def _scaled(value: float, threshold: float) -> float:
    if value <= threshold:
        return round(EMPHASISED * value / threshold, 3) if threshold else 0.0
    return round(EMPHASISED + (1 - EMPHASISED) * (value - threshold) / (1 - threshold), 3)

"""What the body does by itself: a look at the listener as the line begins, and blinks.

People blink about 26 times a minute while they talk (Bentivoglio et al. 1997), rather where they pause or a phrase
ends. These have no rule and no function, but a reason.
"""

import random
from collections.abc import Iterator
from dataclasses import dataclass

from app.model import Utterance, Word

BLINKS_PER_MINUTE = 26.0

_SHORTEST_BETWEEN_BLINKS_S = 0.8
_NEAR_S = 0.8
"""How far a blink that is due waits for a pause or phrase end, or comes before its time for one."""
_SHORTEST_PAUSE_S = 0.2


@dataclass(frozen=True, slots=True)
class Unasked:
    """A behaviour of the table that no function asks for: when, in which word, why."""

    name: str
    at_s: float
    word: int
    reason: str


def unasked(utterance: Utterance, timed: tuple[Word, ...], seed: int) -> Iterator[Unasked]:
    """The opening gaze, and the blinks until the sound or the last of the `timed` words ends."""
    yield Unasked("gaze_opening", 0.0, timed[0].index, "looks at the listener as the line begins")
    chances = dict(_chances(utterance, timed))
    intervals = [(word.index, word.interval) for word in timed if word.interval is not None]
    end_s = utterance.duration_s or intervals[-1][1].end_s
    for at_s in _blinks(sorted(chances), end_s, _generator(utterance, seed)):
        word = max((index for index, interval in intervals if interval.start_s <= at_s), default=intervals[0][0])
        yield Unasked("blink", at_s, word, chances.get(at_s, "blinks now and then"))


def _generator(utterance: Utterance, seed: int) -> random.Random:
    """Lines of other words blink at other times, the same line always at the same."""
    return random.Random(f"{seed} blinks {' '.join(word.text for word in utterance.words)}")


def _chances(utterance: Utterance, timed: tuple[Word, ...]) -> Iterator[tuple[float, str]]:
    """Where a blink is likely, and why: where phrases end, and where the voice pauses."""
    phrase_ends = {phrase.last for phrase in utterance.parse.phrases}
    for word, following in zip(timed, (*timed[1:], None), strict=True):
        if word.interval is None:
            continue
        if word.index in phrase_ends or following is None:
            yield word.interval.end_s, "blinks as a phrase ends"
        elif following.interval and following.interval.start_s - word.interval.end_s >= _SHORTEST_PAUSE_S:
            yield word.interval.end_s, "blinks in a pause"


def _blinks(chances: list[float], end_s: float, generator: random.Random) -> Iterator[float]:
    usual_s = 60 / BLINKS_PER_MINUTE
    due_s, last_s = generator.uniform(0.3, usual_s), -_SHORTEST_BETWEEN_BLINKS_S
    while due_s < end_s:
        near = [
            time_s
            for time_s in chances
            if abs(time_s - due_s) <= _NEAR_S and time_s >= last_s + _SHORTEST_BETWEEN_BLINKS_S
        ]
        last_s = min(near, key=lambda time_s: abs(time_s - due_s), default=due_s)
        yield last_s
        due_s = last_s + _SHORTEST_BETWEEN_BLINKS_S
        due_s += generator.expovariate(1 / (usual_s - _SHORTEST_BETWEEN_BLINKS_S))

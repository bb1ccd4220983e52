"""Idle behaviour at particular moments of the speech: blinks, breath, looks at the listener, changes of posture, and
looks aside (gaze aversion).
"""

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import cycle, pairwise
from types import MappingProxyType

from ...model import Interval, Utterance, Word
from ...model.tables import GazeDirection


@dataclass(frozen=True, slots=True)
class Habit:
    """A gaze habit: eye contact for a share `eye_contact` of the time, with looks aside of `aside_s`."""

    eye_contact: float
    aside_s: float
    widest_degrees: float

    @property
    def contact_s(self) -> float:
        """The duration of eye contact between two looks aside."""
        return self.aside_s * self.eye_contact / (1 - self.eye_contact)


TALKING = Habit(eye_contact=0.71, aside_s=1.65, widest_degrees=27.5)
LISTENING = Habit(eye_contact=0.86, aside_s=1.14, widest_degrees=22.7)
"""Measured: people who talked looked aside for 1.96 s at a time (less here, because the longest looks are left out) and
back for 4.75 s; people who listened, for 1.14 s and 7.21 s."""

SPREAD = 0.25
"""The standard deviation of these times relative to their mean (0.16 to 0.29 in the measurements)."""

LONGEST_S = 1.9

DIRECTIONS: Mapping[GazeDirection, float] = MappingProxyType(
    {
        GazeDirection.RIGHT: 15.54,
        GazeDirection.UPRIGHT: 6.46,
        GazeDirection.UP: 17.69,
        GazeDirection.UPLEFT: 7.44,
        GazeDirection.LEFT: 16.80,
        GazeDirection.DOWNLEFT: 7.89,
        GazeDirection.DOWN: 20.38,
        GazeDirection.DOWNRIGHT: 7.79,
    }
)
"""Percentages of all saccades."""

NARROWEST_DEGREES = 5.0
"""The smallest angle of a look aside; at smaller angles the eyes are still on the other's face."""

MEAN_DEGREES = 6.9
"""Magnitudes are distributed exponentially: -6.9 ln(P / 15.7)."""

SHORTEST_S = 0.25


@dataclass(frozen=True, slots=True)
class Glance:
    """A look aside."""

    interval: Interval
    direction: GazeDirection
    angle_degrees: float


def glances(free: Interval, habit: Habit, generator: random.Random) -> Iterator[Glance]:
    """The looks aside in an interval in which nothing else moves the eyes; each ends within it."""
    # The interval may begin anywhere between two looks aside.
    start_s = free.start_s + SHORTEST_S + generator.random() * _lasting(habit.contact_s, generator)
    while start_s + SHORTEST_S <= free.end_s:
        aside_s = min(_lasting(habit.aside_s, generator), LONGEST_S)
        interval = Interval(start_s, min(start_s + aside_s, free.end_s))
        (direction,) = generator.choices(list(DIRECTIONS), list(DIRECTIONS.values()))
        angle = NARROWEST_DEGREES + generator.expovariate(1 / MEAN_DEGREES)
        yield Glance(interval, direction, min(angle, habit.widest_degrees))
        start_s = interval.end_s + _lasting(habit.contact_s, generator)


def _lasting(mean_s: float, generator: random.Random) -> float:
    """A random time around the mean."""
    return max(SHORTEST_S, generator.gauss(mean_s, SPREAD * mean_s))


BLINKS_PER_MINUTE = 19.0

_FEWEST_BLINKS_PER_MINUTE = 5.0
"""The least rate of spontaneous blinks, however many others are asked for."""
_SHORTEST_BETWEEN_BLINKS_S = 0.8
_NEAR_S = 0.8
"""How far a blink may be moved from its time to a pause or phrase end."""
_SHORTEST_PAUSE_S = 0.2
_SHORTEST_BREATH_S = 0.35
_SHORTEST_BETWEEN_BREATHS_S = 4.0
_SHORTEST_BETWEEN_SHIFTS_S = 5.0
_TURN_S = 0.35
_TURNING_WAITS_S = (0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5)
"""The delays after the beginning of a sentence at which a turn to another listener is tried."""
_SENTENCE_ENDS = (".", "?", "!", "…")


@dataclass(frozen=True, slots=True)
class IdleBehavior:
    """A behaviour of the table without a function: its time, word and reason."""

    name: str
    at_s: float
    word: int
    reason: str


def idle_behaviors(
    utterance: Utterance,
    timed: tuple[Word, ...],
    seed: int,
    *,
    rest_poses: Sequence[str] = (),
    blinks_asked_s: Sequence[float] = (),
    turning_beside: Sequence[Interval] | None = None,
) -> Iterator[IdleBehavior]:
    """The idle behaviour until the sound or the last of the `timed` words ends. Without `rest_poses` the posture stays;
    near the times `blinks_asked_s` no further blinks are made. `turning_beside` is given if there are several
    listeners: the speaker then turns to the next one with each sentence, while none of these other looks is going
    on."""
    yield IdleBehavior("gaze_opening", 0.0, timed[0].index, "looks at the listener as the line begins")
    if turning_beside is not None:
        yield from _turns(timed, turning_beside)
    yield from _breaths([(word.index, word.interval) for word in timed if word.interval is not None])
    yield from _shifts(timed, rest_poses)
    yield from blinks(utterance, timed, f"{seed}", asked_s=blinks_asked_s)


def blinks(
    utterance: Utterance, timed: tuple[Word, ...], seed: str, *, asked_s: Sequence[float] = ()
) -> Iterator[IdleBehavior]:
    """The blinks of a line in addition to requested ones. Their times depend on the words, so they are the same for the
    same line."""
    intervals = [(word.index, word.interval) for word in timed if word.interval is not None]
    generator = random.Random(f"{seed} blinks {' '.join(word.text for word in utterance.words)}")
    chances = dict(_chances(utterance, timed))
    end_s = utterance.duration_s or intervals[-1][1].end_s
    for at_s in _blinks(sorted(chances), sorted(asked_s), end_s, generator):
        word = max((index for index, interval in intervals if interval.start_s <= at_s), default=intervals[0][0])
        yield IdleBehavior("blink", at_s, word, chances.get(at_s, "blinks now and then"))


def _turns(timed: tuple[Word, ...], others: Sequence[Interval]) -> Iterator[IdleBehavior]:
    for word, following in pairwise(timed):
        if following.interval is not None and _ends_sentence(word.text):
            times_s = (following.interval.start_s + wait_s for wait_s in _TURNING_WAITS_S)
            free = (time_s for time_s in times_s if not any(_near_turn(time_s, other) for other in others))
            at_s = next(free, None)
            if at_s is not None:
                yield IdleBehavior("gaze_opening", at_s, following.index, "turns to another listener")


def _near_turn(time_s: float, other: Interval) -> bool:
    return other.start_s - _TURN_S < time_s < other.end_s + _TURN_S


def _breaths(intervals: list[tuple[int, Interval]]) -> Iterator[IdleBehavior]:
    last_s = -_SHORTEST_BETWEEN_BREATHS_S
    for (word, before), (_, after) in pairwise(intervals):
        at_s = (before.end_s + after.start_s) / 2
        pause_s = after.start_s - before.end_s
        if pause_s >= _SHORTEST_BREATH_S and at_s >= last_s + _SHORTEST_BETWEEN_BREATHS_S:
            yield IdleBehavior("breath", at_s, word, "breathes in as the voice pauses")
            last_s = at_s


def _shifts(timed: tuple[Word, ...], rest_poses: Sequence[str]) -> Iterator[IdleBehavior]:
    """Changes from one rest pose to the next where a sentence begins after a pause."""
    if not rest_poses:
        return
    poses = cycle((*rest_poses[1:], rest_poses[0]))
    last_s = -_SHORTEST_BETWEEN_SHIFTS_S
    for word, following in pairwise(timed):
        if word.interval is None or following.interval is None or not _ends_sentence(word.text):
            continue
        start_s = following.interval.start_s
        if start_s - word.interval.end_s < _SHORTEST_PAUSE_S or start_s < last_s + _SHORTEST_BETWEEN_SHIFTS_S:
            continue
        yield IdleBehavior(next(poses), start_s, following.index, "shifts posture as another sentence begins")
        last_s = start_s


def _ends_sentence(text: str) -> bool:
    return text.rstrip("\"'”’)").endswith(_SENTENCE_ENDS)


def _chances(utterance: Utterance, timed: tuple[Word, ...]) -> Iterator[tuple[float, str]]:
    """Where a blink is likely, and why: at ends of phrases, and in pauses."""
    phrase_ends = {phrase.last for phrase in utterance.parse.phrases}
    for word, following in zip(timed, (*timed[1:], None), strict=True):
        if word.interval is None:
            continue
        if word.index in phrase_ends or following is None:
            yield word.interval.end_s, "blinks as a phrase ends"
        elif following.interval and following.interval.start_s - word.interval.end_s >= _SHORTEST_PAUSE_S:
            yield word.interval.end_s, "blinks in a pause"


def _blinks(chances: list[float], asked: list[float], end_s: float, generator: random.Random) -> Iterator[float]:
    usual_s = 60 / max(BLINKS_PER_MINUTE - 60 * len(asked) / end_s, _FEWEST_BLINKS_PER_MINUTE)
    due_s, last_s = generator.expovariate(1 / (usual_s - _SHORTEST_BETWEEN_BLINKS_S)), -_SHORTEST_BETWEEN_BLINKS_S
    while due_s < end_s:
        at_s = min(_near(chances, asked, due_s, last_s), key=lambda time_s: abs(time_s - due_s), default=due_s)
        before = [time_s for time_s in asked if last_s < time_s < at_s + _SHORTEST_BETWEEN_BLINKS_S]
        if before:
            last_s = before[0]
        else:
            yield at_s
            last_s = at_s
        due_s = last_s + _SHORTEST_BETWEEN_BLINKS_S
        due_s += generator.expovariate(1 / (usual_s - _SHORTEST_BETWEEN_BLINKS_S))


def _near(chances: list[float], asked: list[float], due_s: float, last_s: float) -> list[float]:
    """The candidate times for a blink that is due at about `due_s`, the last one having been at `last_s`."""
    return [
        time_s
        for time_s in chances
        if abs(time_s - due_s) <= _NEAR_S
        and time_s >= last_s + _SHORTEST_BETWEEN_BLINKS_S
        and all(abs(time_s - other_s) >= _SHORTEST_BETWEEN_BLINKS_S for other_s in asked)
    ]

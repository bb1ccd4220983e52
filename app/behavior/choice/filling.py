"""Fills the time in which nothing is asked of head and eyes: they are never quite still (paper §6).

Between the movements that show something the head drifts by a few degrees and the eyes go aside and come back; where
they stay aside for a while, and nothing else is asked of the head, it goes with them. These movements are placed where
their channel is free, so they never compete. A still character drifts less often and less far. No drift is repeated
immediately, and the eyes are back on the listener when the last word begins, to yield the turn (Kendon 1967). What an
author forbids does not come by itself either.
"""

import random
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from ...model import Behavior, Channel, Interval, Utterance, Word
from ...model.tables import LOOK
from ..characters.overlays import Character
from ..idle.idle_behaviors import Habit, glances
from ..reading.player import Ban, banned
from ..table.behavior_table import DRIFTS, BehaviorEntry
from ..timing.anchoring import PlacedBehavior, filler, interval_of
from ..timing.conflicts import Kept

DRIFT_S = (2.5, 5.0)
"""The duration of a drift, from the first movement to rest."""

SHORTEST_DRIFT_S = 2.0
"""In shorter gaps the head rests."""

GAZE_RANGE_DEGREES = 60.0
"""The angle of a gaze of amount 1."""

_TURNS_HEAD = ("look_aside", "drift_turn_left", "drift_turn_right")
"""What a look aside does with the head; where one of these is forbidden, the eyes go alone."""

LOOK_S, LOOK_DEGREES = 0.7, 10.0
"""The head goes with eyes that stay aside at least this long, and then turns at least this far."""


@dataclass(frozen=True, slots=True)
class FillingContext:
    """What the fillers of a line depend on: its words, its end, the character, the random generator, and what is
    forbidden where."""

    words: tuple[Word, ...]
    end_s: float
    character: Character
    generator: random.Random
    bans: tuple[Ban, ...] = ()

    @classmethod
    def of(
        cls,
        utterance: Utterance,
        timed: tuple[Word, ...],
        character: Character,
        seed: str,
        bans: tuple[Ban, ...] = (),
    ) -> "FillingContext":
        ends = [word.interval.end_s for word in timed if word.interval is not None]
        text = " ".join(word.text for word in utterance.words)
        return cls(timed, utterance.duration_s or ends[-1], character, random.Random(f"{seed} {text}"), bans)

    def permits(self, name: str, interval: Interval) -> bool:
        """Whether the author lets the body do this by itself in an interval."""
        starts = [(word.index, interval_of(word).start_s) for word in self.words]
        first = max((index for index, start_s in starts if start_s <= interval.start_s), default=starts[0][0])
        last = max((index for index, start_s in starts if start_s < interval.end_s), default=first)
        return not banned(self.bans, name, first, last)


def fillers(kept: Kept, rest: FillingContext, habit: Habit) -> tuple[PlacedBehavior, ...]:
    """Looks aside, with the eyes alone or with the head, and drifts of the head in the time that these and the kept
    leave free."""
    looks = tuple(_looks_aside(kept, rest, habit))
    return (*_drifts((*kept, *looks), rest), *looks)


def free(kept: Kept, channel: Channel, end_s: float) -> Iterator[Interval]:
    """The intervals of a line in which nothing is kept on a channel; looks aside occupy the head as well."""
    begin_s = 0.0
    taken = (each.behavior.sync for each in kept if each.behavior.kind is channel or _has(each.behavior, channel))
    for sync in sorted(taken, key=lambda sync: sync.start):
        if sync.start > begin_s:
            yield Interval(begin_s, sync.start)
        begin_s = max(begin_s, sync.end)
    if end_s > begin_s:
        yield Interval(begin_s, end_s)


def _drifts(kept: Kept, rest: FillingContext) -> Iterator[PlacedBehavior]:
    activity = 1 - rest.character.stillness
    name = ""
    for gap in free(kept, Channel.HEAD, rest.end_s):
        for interval in _parts(gap, rest.generator):
            others = [other for other in DRIFTS if other != name and rest.permits(other, interval)]
            if not others:
                continue
            name = rest.generator.choice(others)
            entry = rest.character.entries[name]
            amount = (entry.amount or 0.0) * rest.generator.uniform(0.5, 1.0) * activity
            if rest.generator.random() < activity:
                yield _filler(replace(entry, amount=amount), interval, rest, "the head is never quite still")


def _parts(gap: Interval, generator: random.Random) -> Iterator[Interval]:
    """A gap divided into drifts; a remainder that would be too short is added to the last."""
    start_s = gap.start_s
    while gap.end_s - start_s >= SHORTEST_DRIFT_S:
        end_s = start_s + generator.uniform(*DRIFT_S)
        if gap.end_s - end_s < SHORTEST_DRIFT_S:
            end_s = gap.end_s
        yield Interval(start_s, end_s)
        start_s = end_s


def _has(behavior: Behavior, channel: Channel) -> bool:
    """Whether it is a look aside and the channel is the head, which it occupies as well."""
    return channel is Channel.HEAD and behavior.lexeme == LOOK and behavior.direction is not None


def _looks_aside(kept: Kept, rest: FillingContext, habit: Habit) -> Iterator[PlacedBehavior]:
    for gap in free(kept, Channel.GAZE, interval_of(rest.words[-1]).start_s):
        for glance in glances(gap, habit, rest.generator):
            during, angle, name = glance.interval, glance.angle_degrees, "saccade"
            free_head = _longest_within(free(kept, Channel.HEAD, rest.end_s), during)
            if free_head.duration_s >= LOOK_S and all(rest.permits(each, free_head) for each in _TURNS_HEAD):
                during, angle, name = free_head, max(angle, LOOK_DEGREES), "look_aside"
            if not rest.permits(name, during):
                continue
            entry = rest.character.entries[name]
            aside = replace(entry, direction=glance.direction, amount=angle / GAZE_RANGE_DEGREES)
            yield _filler(aside, during, rest, "the eyes wander off and come back")


def _longest_within(stretches: Iterable[Interval], whole: Interval) -> Interval:
    """The longest part of the whole that is in one of the stretches; an empty interval if there is none."""
    parts = (Interval(max(each.start_s, whole.start_s), min(each.end_s, whole.end_s)) for each in stretches)
    return max(parts, key=lambda part: part.duration_s, default=Interval(0.0, 0.0))


def _filler(entry: BehaviorEntry, interval: Interval, rest: FillingContext, reason: str) -> PlacedBehavior:
    begun = [word.index for word in rest.words if word.interval and word.interval.start_s <= interval.start_s]
    word = begun[-1] if begun else rest.words[0].index
    return filler(entry, interval, word, reason)

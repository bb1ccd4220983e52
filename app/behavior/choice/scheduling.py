"""From candidates to a timed schedule (paper §3.4, §3.5): what is done, when it begins, strikes and ends, with which
hand.

How a movement is timed by its word is in `timing/anchoring.py`, which alternatives are taken in `choosing.py`, what
does not fit together is settled in `timing/conflicts.py`, what the body does by itself is in `idle/idle_behaviors.py`.

Transitions between gestures are as fast as the next stroke, if possible (paper §3.8, Figure 4). Where a gesture joins
the next and the transition would be faster than the stroke, its hold ends earlier, because a fast transition looks as
if it meant more than the stroke. That is our addition: the paper accepts transitions that are faster by no more than
v_th. Where the transition would be slower, the realizer prolongs the hold.

The three conditions of the paper's study (§5) take gestures from the meaning, from the stress, or from chance. Head,
eyes and face are those of the meaning in all three, so that a comparison of them compares the gestures. The two rivals
are made as good as possible: beats are spread over the stressed words of the whole line, and chance draws anew for each
text.
"""

import random
from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import pairwise
from types import MappingProxyType

from ...model import Behavior, BehaviorCandidates, Channel, Interval, Level, Limit, Mode, Movement, Utterance, Word
from ..characters.overlays import Character
from ..idle.idle_behaviors import TALKING, idle_behaviors
from ..idle.stillness import to_thousandths
from ..reading.player import Ban, banned
from ..timing.anchoring import PlacedBehavior, asked, interval_of, placed_idle
from ..timing.conflicts import FittedBehavior, Kept, compete, fitted, resolve, transition
from ..timing.time_index import TimeIndex
from .attempts import ChoiceContext
from .choosing import choose
from .filling import FillingContext, fillers
from .hands import with_hand
from .necessity import BLINK, needed

SHORTEST_HOLD_S = 0.2
"""The least hold that remains (people's holds last .20 to 1.10 s, docs/references.md)."""


def eased(kept: Kept) -> Kept:
    """The kept behaviours in their order, with transitions between joined gestures as slow as their holds permit."""
    gestures = sorted((each for each in kept if each.behavior.kind is Channel.GESTURE), key=_stroke_start_s)
    by_id: dict[str, Behavior] = {each.behavior.id: each.behavior for each in kept}
    for number, second in enumerate(gestures):
        earlier = [_current(each, by_id) for each in gestures[:number] if compete(each.behavior, second.behavior)]
        by_id |= {each.id: each for each in _eased(_current(second, by_id), earlier)}
    return tuple(_current(each, by_id) for each in kept)


def _current(placed: PlacedBehavior, by_id: dict[str, Behavior]) -> PlacedBehavior:
    return replace(placed, behavior=by_id[placed.behavior.id])


def _stroke_start_s(gesture: PlacedBehavior) -> float:
    sync = gesture.behavior.sync
    return sync.start if sync.stroke_start is None else sync.stroke_start


def _eased(second: PlacedBehavior, earlier: Iterable[PlacedBehavior]) -> Iterable[Behavior]:
    """The second gesture, beginning when the first may relax, and those that it joins."""
    start_s = second.behavior.sync.start
    joined = [each for each in earlier if each.behavior.sync.end == start_s]
    relax_s = max((_relax_s(each, second) for each in joined), default=start_s)
    if relax_s >= start_s or any(each.behavior.sync.end > relax_s for each in earlier if each not in joined):
        return
    yield replace(second.behavior, sync=replace(second.behavior.sync, start=relax_s))
    for first in joined:
        sync = first.behavior.sync
        relaxed = replace(sync, relax=min(sync.end if sync.relax is None else sync.relax, relax_s), end=relax_s)
        yield replace(first.behavior, sync=relaxed)


def _relax_s(first: PlacedBehavior, second: PlacedBehavior) -> float:
    """When the first gesture should relax so that its hand moves as fast as the second's stroke, with some of its hold
    left."""
    sync = first.behavior.sync
    relax_s = sync.end if sync.relax is None else sync.relax
    held_s = relax_s if sync.stroke_end is None else min(relax_s, sync.stroke_end + SHORTEST_HOLD_S)
    return round(max(held_s, min(relax_s, _stroke_start_s(second) - transition(first, second).equal_s)), 3)


BEAT = "beat_gesture"
BEAT_PRIORITY = 1.0

DRAWS = 8
"""How many random gestures are tried until one fits."""


def in_mode(
    mode: Mode,
    chosen: tuple[Kept, tuple[Behavior, ...]],
    line: ChoiceContext,
    seed: int,
) -> tuple[Kept, tuple[Behavior, ...]]:
    """What is kept and lost in a mode, from what was chosen by meaning."""
    if mode is Mode.SEMANTIC:
        return chosen
    kept, lost = chosen
    gestures = [each for each in kept if each.behavior.kind is Channel.GESTURE]
    others = TimeIndex(each for each in kept if each.behavior.kind is not Channel.GESTURE)
    lost = tuple(behavior for behavior in lost if behavior.kind is not Channel.GESTURE)
    reason = f"not used in mode {mode}"
    replaced = (replace(each.behavior, kept=False, limit=Limit.MODE, reason=reason) for each in gestures)
    if mode is Mode.PROSODY:
        return tuple(_beaten_in(others, line)), (*lost, *replaced)
    text = " ".join(word.text for word in line.timed)
    drawn = _drawn(others, gestures, line, random.Random(f"{seed} {text} gestures"))
    return tuple(drawn), (*lost, *replaced)


def _beaten_in(kept: TimeIndex, line: ChoiceContext) -> TimeIndex:
    """The kept with beats on stressed words, as many as the character makes, spread over the line."""
    stressed = [word for word in line.timed if word.is_emphasised]
    for part in _parts(stressed, line.most_gestures):
        kept = _beaten_once(kept, part, line)
    return kept


def _parts(stressed: Sequence[Word], most: int) -> list[Sequence[Word]]:
    """The stressed words in order, divided evenly into as many parts as there are beats; each part gets one beat."""
    count = min(most, len(stressed))
    bounds = [place * len(stressed) // count for place in range(count + 1)] if count else []
    return [stressed[first:last] for first, last in pairwise(bounds)]


def _beaten_once(kept: TimeIndex, part: Sequence[Word], line: ChoiceContext) -> TimeIndex:
    """The kept with a beat on the most stressed word of a part on which one fits; of equally stressed words the last,
    because English has its main stress late."""
    for word in sorted(part, key=lambda word: (-(word.emphasis or 0.0), -word.index)):
        movement = Movement(BEAT, word.index, word.index, BEAT_PRIORITY, "", None)
        outcome = _fitted(movement, kept, line, "beats on a stressed word")
        if outcome is not None:
            return outcome.kept
    return kept


def _drawn(kept: TimeIndex, gestures: list[PlacedBehavior], line: ChoiceContext, generator: random.Random) -> TimeIndex:
    """The kept with a random gesture of the table in place of each gesture."""
    names = [name for name, entry in line.character.entries.items() if entry.channel is Channel.GESTURE]
    for each in gestures:
        behavior = each.behavior
        for name in generator.choices(names, k=DRAWS):
            movement = Movement(name, behavior.first, behavior.last, behavior.priority, "", None)
            outcome = _fitted(movement, kept, line, "drawn by chance")
            if outcome is not None:
                kept = outcome.kept
                break
    return kept


def _fitted(movement: Movement, kept: TimeIndex, line: ChoiceContext, reason: str) -> FittedBehavior | None:
    if banned(line.bans, movement.name, movement.first, movement.last):
        return None
    name = f"{movement.name}.{movement.first}.{movement.last}"
    candidate = asked(movement, line.character.entries[movement.name], line.timed, name)
    if not candidate.behavior.kept:
        return None
    behavior = replace(candidate.behavior, rule=None, reason=reason)
    candidate = with_hand(replace(candidate, behavior=behavior), kept, line.character.handedness)
    outcome = fitted(candidate, kept)
    return outcome if isinstance(outcome, FittedBehavior) else None


PLANNED_MORE = MappingProxyType({Level.LOW: 2.0, Level.MEDIUM: 2.2, Level.HIGH: 2.8})
"""Ideas crowd in some lines and are absent from others: a planned line may have this many times the usual gestures, and
agitation drives the quantity (paper §1)."""

ASKED_MORE = MappingProxyType({Level.LOW: 3.6, Level.MEDIUM: 4.0, Level.HIGH: 4.6})
"""How many times the usual gestures functions may ask for by priority alone, as in the paper's Figure 8: in the usual
character a stroke every .7 s. Agitation drives the quantity (§1)."""

PAUSE_S = 0.5
"""A line has its share of the pause between lines. It makes up for the gestures that find no place in their line, so
that the rates of `benchmarks/bml/schedule.py` come out as set."""


def schedule(
    candidates: Iterable[BehaviorCandidates],
    utterance: Utterance,
    character: Character,
    *,
    seed: int,
    mode: Mode = Mode.SEMANTIC,
    several_listeners: bool = False,
    bans: tuple[Ban, ...] = (),
) -> tuple[Behavior, ...]:
    """The behaviours in order of time, those that were dropped among them; none at all when no word has a time.

    Head, eyes and face are the same in every mode. The kept ones do not overlap on a channel (or hand), and their sync
    points are in order and not before 0.
    """
    timed = tuple(word for word in utterance.words if word.interval is not None)
    if not timed:
        return ()
    duration_s = utterance.duration_s or interval_of(timed[-1]).end_s
    candidates = tuple(candidates)
    planned = any(each.moment and not each.moment.demanded for each in candidates)
    spoken_s = duration_s - utterance.lead_in_s
    level = utterance.level
    at_rate = most_gestures(character, spoken_s * (PLANNED_MORE[level] if planned else 1.0))
    most_asked = most_gestures(character, spoken_s * ASKED_MORE[level])
    line = ChoiceContext(timed, character, at_rate + _second_places(candidates), most_asked, bans)
    kept, lost = choose(candidates, line)
    kept, needless = needed(kept, candidates)
    usual = replace(line, most_gestures=most_gestures(character, spoken_s))
    kept, lost = in_mode(mode, (kept, (*lost, *needless)), usual, seed)
    kept, own_lost = resolve(_idle(kept, utterance, usual, seed, several_listeners=several_listeners), kept)
    kept = eased(kept)
    rest = FillingContext.of(utterance, timed, character, f"{seed} rest", bans)
    kept += fillers(kept, rest, replace(TALKING, eye_contact=character.eye_contact))
    return numbered([*(candidate.behavior for candidate in kept), *lost, *own_lost])


def _idle(
    kept: Kept, utterance: Utterance, line: ChoiceContext, seed: int, *, several_listeners: bool
) -> list[PlacedBehavior]:
    """What the body does by itself beside the kept, and nobody forbids."""
    character = line.character
    gazes = [each.behavior.sync for each in kept if each.behavior.kind is Channel.GAZE]
    looks = [Interval(sync.start, sync.end) for sync in gazes]
    blinks_asked_s = [each.basis.at_s for each in kept if each.behavior.lexeme == BLINK]
    behaviors = idle_behaviors(
        utterance,
        line.timed,
        seed,
        rest_poses=character.rest_poses,
        blinks_asked_s=blinks_asked_s,
        turning_beside=looks if several_listeners else None,
    )
    return [
        placed_idle(each, character.entries[each.name], f"own.{number:04d}")
        for number, each in enumerate(behaviors)
        if not banned(line.bans, each.name, each.word, each.word)
    ]


def most_gestures(character: Character, duration_s: float) -> int:
    """How many gestures the character makes at most in a line of this length, with the pause that goes with a line."""
    return round(character.gestures_per_minute * (duration_s + PAUSE_S) / 60)


def _second_places(candidates: Iterable[BehaviorCandidates]) -> int:
    """Contrasts whose second place is shown: it is one idea with the first, and the rate allows both or neither."""
    moments = (each.moment for each in candidates if each.moment)
    return sum(moment.set_against is not None and moment.set_against < moment.stroke for moment in moments)


def numbered(behaviors: Iterable[Behavior]) -> tuple[Behavior, ...]:
    """The behaviours in order of time, their ids such as `gesture1` in that order."""
    in_time = sorted(behaviors, key=lambda behavior: (behavior.sync.start, not behavior.kept, behavior.id))
    counts = dict.fromkeys(Channel, 0)
    names = {}
    for behavior in in_time:
        counts[behavior.kind] += 1
        names[behavior.id] = f"{behavior.kind}{counts[behavior.kind]}"
    return tuple(
        replace(
            behavior,
            id=names[behavior.id],
            lost_to=behavior.lost_to and names[behavior.lost_to],
            amount=behavior.amount if behavior.amount is None else to_thousandths(behavior.amount),
        )
        for behavior in in_time
    )

"""Generates a line's gestures in a speaker's style, by the sixteen steps of NGS §3.3.

     1–3  words, tags, candidates                                   `candidates`
     4, 5  the sequence of gestures at the speaker's rate, and hands `sequence`
     6    the hand shape: the library's for the lexeme, in the speaker's size
     7, 8  units; a preparation if there is time                     `phases`
     9    the start and end of strokes: an occurrence in the speaker's GestureDB
    10–13 strokes, their times, conflicts                            `phases`
    14–16 holds, retractions, the script                             `phases`, `script`

All random draws depend on the seed and the words only.

Step 4 runs segment by segment. The paper draws one sequence for a whole text, by which the gestures of a long text
cluster by chance: 9 % were more than 4 s apart, against 4.5 % of the speaker's, and 40 % of units were single gestures,
against 28 % of the speaker's (`python -m benchmarks.profiles`; now 34 %). Here each segment has the number of gestures
that the rate implies for its duration, plus the deficit or minus the surplus of the segments before it, at most one
gesture. Times are seconds.
"""

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, zip_longest
from math import inf
from statistics import fmean

from ...model import Hand, Interval, Utterance, Word
from ...model.limits import USUAL_AMOUNT, transition_times
from ..annotation.model import TaggedWords
from ..profile import FIRST, Occurrence, Profile
from ..segments import segments_of, spoken_s
from ..space import size_of
from .candidates import PlayableGesture, Repertoire, StrokeWord, places_of
from .phases import (
    MOVED_S,
    Bounds,
    TimedStrokes,
    after,
    bounds_of,
    drawn_main,
    form_of,
    joined,
    rest_after,
    with_after_strokes,
)
from .script import GestureScript, ScriptedGesture, ScriptedUnit
from .sequence import Drawn, drawn_gestures, drawn_hands

PREPARED_S = 0.5
"""A gesture with less time than this before its stroke has no preparation of its own."""

LEAST_MOVED_S = 0.005
"""Smaller shifts of a gesture are not reported."""


@dataclass(frozen=True, slots=True)
class Speaker:
    """The speaker's profile, the repertoire and the seed; `likeliest` selects the most probable sequence instead of a
    drawn one."""

    profile: Profile
    repertoire: Repertoire
    seed: int = 0
    likeliest: bool = False


@dataclass(frozen=True, slots=True)
class _Made:
    """A gesture that has been scheduled."""

    drawn: Drawn
    hand: Hand
    timed: TimedStrokes


def generate(speaker: Speaker, utterance: Utterance, tags: Sequence[TaggedWords]) -> GestureScript:
    """The gesture script of a line; empty if no word is timed."""
    profile, repertoire = speaker.profile, speaker.repertoire
    words = [word for word in utterance.words if word.interval is not None]
    rng = random.Random(f"{speaker.seed} {profile.name} {' '.join(word.text for word in words)}")
    places = places_of(profile, repertoire, utterance, tags)
    chosen = paced_gestures(profile, places, words, rng=rng, likeliest=speaker.likeliest)
    hands = drawn_hands(profile, chosen, repertoire, rng=rng)
    by_index = {word.index: word for word in words}
    timed = [
        drawn_main(profile, each.lexeme, by_index[each.place.word], repertoire.gestures[each.lexeme].stroke_s, rng)
        for each in chosen
    ]
    made, given_up = _in_turn(repertoire, list(map(_Made, chosen, hands, timed)))
    made = [_struck(speaker, each, following, words, rng) for each, following in zip_longest(made, made[1:])]
    end_s = utterance.duration_s or (words[-1].interval.end_s if words and words[-1].interval else 0.0)
    gestures, units = _script(speaker, made, end_s, rng)
    every = sorted((*gestures, *given_up), key=lambda each: (each.strokes[0].start_s, each.word))
    return GestureScript(profile.name, speaker.seed, tuple(every), units)


def _in_turn(repertoire: Repertoire, wanted: Sequence[_Made]) -> tuple[list[_Made], list[ScriptedGesture]]:
    """The gestures for which there is time after the previous one, and the others (step 11). If time is short, the
    previous gesture is made earlier by half of the missing time, if possible, and this one later by the rest."""
    made: list[_Made] = []
    given_up: list[ScriptedGesture] = []
    for each in wanted:
        free_s = _free_s(repertoire, made, each)
        lacks_s = free_s - each.timed.strokes[0].start_s
        if made and 0 < lacks_s <= MOVED_S:
            made[-1] = _earlier(repertoire, made, lacks_s / 2)
            free_s = _free_s(repertoire, made, each)
        timed = after(each.timed, free_s)
        if timed is None:
            before = f"{made[-1].drawn.lexeme} leaves it no time" if made else "there is no time before its word"
            given_up.append(_given_up(each, before))
        elif any(_overlap(timed, taken) for taken in repertoire.taken):
            given_up.append(_given_up(each, "the hands already make another gesture"))
        else:
            made.append(replace(each, timed=timed))
    return made, given_up


def _free_s(repertoire: Repertoire, made: Sequence[_Made], following: _Made) -> float:
    """The time from which the hands are free for the next stroke."""
    return made[-1].timed.strokes[0].end_s + _way_s(repertoire, made[-1], following) if made else 0.0


def _earlier(repertoire: Repertoire, made: Sequence[_Made], most_s: float) -> _Made:
    """The last scheduled gesture, made earlier by this much, or by as much as the one before it allows."""
    *others, last = made
    timed = last.timed.shifted(
        -max(0.0, min(most_s, last.timed.strokes[0].start_s - _free_s(repertoire, others, last)))
    )
    return last if any(_overlap(timed, taken) for taken in repertoire.taken) else replace(last, timed=timed)


def _way_s(repertoire: Repertoire, one: _Made, other: _Made) -> float:
    """The minimum time between the strokes of two successive gestures."""
    gestures = repertoire.gestures[one.drawn.lexeme], repertoire.gestures[other.drawn.lexeme]
    return transition_times(
        gestures[0].forms[one.hand], gestures[1].forms[other.hand], amounts=(gestures[0].amount, gestures[1].amount)
    ).shortest_s


def _overlap(timed: TimedStrokes, taken: Interval) -> bool:
    return timed.strokes[0].start_s - PREPARED_S < taken.end_s and taken.start_s < timed.strokes[-1].end_s + PREPARED_S


def _given_up(each: _Made, reason: str) -> ScriptedGesture:
    strokes = each.timed.strokes
    start_s, end_s = max(0.0, strokes[0].start_s), max(0.0, strokes[-1].end_s)
    bounds = Bounds(start_s, end_s, end_s, last=True)
    name = f"given_up.{each.drawn.place.word}"
    return replace(_scripted(each, bounds, name), kept=False, reason=reason)


def _struck(speaker: Speaker, each: _Made, following: _Made | None, words: Sequence[Word], rng: random.Random) -> _Made:
    """The gesture with its after-strokes (steps 10 and 12), which leave enough time before the next gesture."""
    until_s = inf
    if following is not None:
        until_s = following.timed.strokes[0].start_s - _way_s(speaker.repertoire, each, following)
    later = [word for word in words if word.index > each.drawn.place.word]
    timed = with_after_strokes(speaker.profile, each.drawn.lexeme, each.timed, later, until_s=until_s, rng=rng)
    return replace(each, timed=timed)


def _script(
    speaker: Speaker, made: Sequence[_Made], end_s: float, rng: random.Random
) -> tuple[list[ScriptedGesture], tuple[ScriptedUnit, ...]]:
    """The script: the gestures with their bounds and forms, and their units."""
    profile, strokes = speaker.profile, [each.timed for each in made]
    segments = [each.drawn.place.segment for each in made]
    bounds = list(bounds_of(profile.phases, strokes, joined(profile, strokes, segments, rng)))
    gestures: list[ScriptedGesture] = []
    for number, (each, bound) in enumerate(zip(made, bounds, strict=True)):
        gesture = _scripted(each, bound, f"script.{number}")
        before = gestures[-1] if gestures and not bounds[number - 1].last else None
        playable = speaker.repertoire.gestures[gesture.lexeme]
        gestures.append(_sized(_placed(gesture, profile, before, rng), profile, playable))
    return gestures, tuple(_units(profile, gestures, bounds, end_s))


def _scripted(each: _Made, bounds: Bounds, name: str) -> ScriptedGesture:
    tag = each.drawn.place.tags[each.drawn.lexeme]
    return ScriptedGesture(
        id=name,
        lexeme=each.drawn.lexeme,
        hand=each.hand,
        tag=tag.tag,
        first=tag.first,
        last=tag.last,
        word=each.drawn.place.word,
        start_s=bounds.start_s,
        strokes=each.timed.strokes,
        relax_s=bounds.relax_s,
        end_s=bounds.end_s,
        held=each.timed.held,
        reason=_moved(each.timed.moved_s),
    )


def _moved(moved_s: float) -> str | None:
    """The reason why a gesture is not at the time of its word."""
    if abs(moved_s) < LEAST_MOVED_S:
        return None
    return f"{abs(moved_s):.2f} s " + (
        "later: too little time before it" if moved_s > 0 else "earlier: too little time after it"
    )


def _placed(
    gesture: ScriptedGesture, profile: Profile, before: ScriptedGesture | None, rng: random.Random
) -> ScriptedGesture:
    """The gesture with the positions of one of the speaker's occurrences (step 9). Without time for a preparation, an
    occurrence that starts where the previous gesture ended is preferred."""
    known = [each for each in profile.database if each.lexeme == gesture.lexeme]
    fitting = [each for each in known if each.hand is gesture.hand] or known
    if before is not None and before.end is not None and gesture.strokes[0].start_s - before.relax_s < PREPARED_S:
        fitting = [each for each in fitting if each.start == before.end] or fitting
    if not fitting:
        return gesture
    chosen = rng.choice(fitting)
    return replace(gesture, start=chosen.start, end=chosen.end, path=chosen.path)


def _sized(gesture: ScriptedGesture, profile: Profile, playable: PlayableGesture) -> ScriptedGesture:
    """The gesture with its emphasis and its size, by the speaker's form and the occurrence."""
    known = [_size(each) for each in profile.database if each.lexeme == gesture.lexeme]
    own = size_of([gesture.start, gesture.end]) / fmean(known) if gesture.start and gesture.end and known else 1.0
    size = form_of(profile, gesture.lexeme).size * own
    main = gesture.strokes[0]
    amount = (USUAL_AMOUNT if playable.amount is None else playable.amount) * size**2
    emphasis_s = main.start_s + playable.emphasis * main.duration_s
    return replace(gesture, emphasis_s=emphasis_s, amount=min(1.0, amount))


def _size(occurrence: Occurrence) -> float:
    return size_of((occurrence.start, occurrence.end))


def _units(
    profile: Profile, gestures: Sequence[ScriptedGesture], bounds: Sequence[Bounds], end_s: float
) -> Iterator[ScriptedUnit]:
    first = 0
    for place, (gesture, bound) in enumerate(zip(gestures, bounds, strict=True)):
        if bound.last:
            next_s = gestures[place + 1].start_s if place + 1 < len(gestures) else max(end_s, bound.end_s)
            names = tuple(each.id for each in gestures[first : place + 1])
            rest = rest_after(profile.rests, next_s - gesture.end_s)
            yield ScriptedUnit(names, gestures[first].start_s, gesture.end_s, rest)
            first = place + 1


MOST_OWED = 1.0
"""The largest deficit or surplus of gestures that is carried over to the next segment."""


def paced_gestures(
    profile: Profile,
    places: Sequence[StrokeWord],
    words: Sequence[Word],
    *,
    rng: random.Random,
    likeliest: bool = False,
) -> tuple[Drawn, ...]:
    """The sequence of gestures on the places of a line, at the speaker's rate in each segment."""
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
    """The duration of each segment, including the part of the preceding pause that counts as speech."""
    segments = segments_of(words)
    until_s = [spoken_s(words, segments[:number]) for number in range(1, len(segments) + 1)]
    yield from (other - one for one, other in pairwise((0.0, *until_s)))

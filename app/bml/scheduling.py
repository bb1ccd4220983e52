"""From chosen movements to a timed schedule (paper §3.5): when each begins, strikes and ends, and with which hand.

A movement is timed by the word it is anchored to: the stressed vowel of that word, or the word's start where its
phones are not known. Nothing happens before 0: a gesture or head movement for which there is no time before its word
is dropped, with the reason; faces, gazes and eyes, which have no stroke to be late, come a little later instead.
Retractions may run past the end. What the body does by itself is in `unasked.py`, what does not fit together is
settled in `conflicts.py`.
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import ceil, floor

from app.bml.characters import Character
from app.bml.conflicts import Candidate, resolve
from app.bml.phases import Placing, Window, placed
from app.bml.table import STROKED, Anchor, BehaviorEntry
from app.bml.unasked import Unasked, unasked
from app.model import Behavior, Channel, Hand, Interval, Movement, Phone, SyncPoints, Utterance, Word

HAND_SWITCH_S = 2.0
"""A gesture that may take either hand stays on the one in use for this long (paper §3.4)."""


def schedule(
    movements: Iterable[Movement], utterance: Utterance, character: Character, *, seed: int
) -> tuple[Behavior, ...]:
    """The behaviours in order of time, those that were dropped among them; none at all when no word has a time.

    The kept ones do not overlap on a channel (or hand), and their sync points are in order and not before 0.
    """
    timed = tuple(word for word in utterance.words if word.interval is not None)
    if not timed:
        return ()
    asked = [_candidate(movement, character.entries[movement.name], timed) for movement in movements]
    own = [_own(behavior, character.entries[behavior.name]) for behavior in unasked(utterance, timed, seed)]
    candidates = _numbered(_with_hands([*asked, *own], character.handedness))
    possible = [candidate for candidate in candidates if candidate.behavior.kept]
    impossible = [candidate.behavior for candidate in candidates if not candidate.behavior.kept]
    budget = _most_gestures(character, utterance.duration_s or _interval(timed[-1]).end_s)
    return tuple(sorted([*resolve(possible, most_gestures=budget), *impossible], key=_time_and_id))


def stressed_vowel_s(word: Word) -> float:
    """Where the vowel of a timed word's stressed syllable begins; the word's start where its vowels are not known.

    The vowel with the primary stress; where phones come without stress digits, the longest that is no AH, for length
    is the strongest cue of stress and AH is what English weakens to (`../shared/alignment.md`, "Stress").
    """
    vowels = [phone for phone in word.phones if phone.label in _VOWELS]
    if not vowels:
        return _interval(word).start_s
    return max(vowels, key=_strength).interval.start_s


_VOWELS = frozenset(["AA", "AE", "AH", "AO", "AW", "AY", "EH", "ER", "EY", "IH", "IY", "OW", "OY", "UH", "UW"])

_DIGIT_RANKS = {None: 0, 0: 0, 2: 1, 1: 2}
"""How strong ARPABET's stress digits are: 1 is the primary stress, 2 the secondary."""


def _strength(vowel: Phone) -> tuple[int, bool, float]:
    return _DIGIT_RANKS[vowel.stress], vowel.label != "AH", round(vowel.interval.duration_s, 3)


def _candidate(movement: Movement, entry: BehaviorEntry, timed: tuple[Word, ...]) -> Candidate:
    """The movement as a behaviour, kept=False from the start where it cannot be timed."""
    words = [word for word in timed if movement.first <= word.index <= movement.last]
    if words:
        at_s, until_s = stressed_vowel_s(_anchor(entry.anchor, words)), _interval(words[-1]).end_s
    else:
        at_s = until_s = max((_interval(word).end_s for word in timed if word.index < movement.first), default=0.0)
    placing = _placing(entry, at_s, until_s)
    sync = placed(placing, Window())
    reason = None
    if not words:
        reason = "none of its words is spoken"
    elif sync is None:
        reason = f"it would have to begin before the audio to strike at {at_s:.3f} s"
    behavior = replace(
        _behavior(entry, sync or _late(placing), movement.first, movement.last),
        priority=movement.priority,
        rule=movement.rule,
        function=movement.function,
        kept=reason is None,
        reason=reason,
    )
    return Candidate(behavior, placing)


def _own(wish: Unasked, entry: BehaviorEntry) -> Candidate:
    placing = _placing(entry, wish.at_s, wish.at_s)
    behavior = _behavior(entry, placed(placing, Window()) or _late(placing), wish.word, wish.word)
    return Candidate(replace(behavior, reason=wish.reason), placing)


def _placing(entry: BehaviorEntry, at_s: float, until_s: float) -> Placing:
    stroked = entry.channel in STROKED
    earliest_s = 0.0 if stroked else entry.timing.preparation.shortest_s
    return Placing(entry.timing, max(floor(at_s * 1000) / 1000, earliest_s), until_s, stroked)


def _late(placing: Placing) -> SyncPoints:
    """How the behaviour would go if it began at 0."""
    timing = placing.timing
    at_s = timing.preparation.usual_s + timing.alignment * timing.stroke.usual_s
    sync = placed(replace(placing, at_s=at_s, until_s=at_s), Window())
    assert sync is not None, "its usual preparation has room"
    return sync


def _behavior(entry: BehaviorEntry, sync: SyncPoints, first: int, last: int) -> Behavior:
    return Behavior(
        id="",
        kind=entry.channel,
        lexeme=entry.lexeme,
        sync=sync,
        first=first,
        last=last,
        priority=0.0,
        hand=entry.hand,
        amount=entry.amount,
        target=entry.target,
        direction=entry.direction,
        repetitions=entry.repetitions,
    )


def _anchor(anchor: Anchor, words: list[Word]) -> Word:
    """The word a stroke falls on; of equally stressed words the last."""
    if anchor is Anchor.FIRST:
        return words[0]
    if anchor is Anchor.LAST:
        return words[-1]
    return max(reversed(words), key=lambda word: word.stressed_ratio or 0.0)


def _with_hands(candidates: list[Candidate], own_hand: Hand) -> Iterator[Candidate]:
    """Gestures that may take either hand take the one that the gesture shortly before has, else the character's own."""
    hand, used_s = own_hand, 0.0
    for candidate in sorted(candidates, key=lambda candidate: candidate.placing.at_s):
        behavior = candidate.behavior
        if behavior.kind is Channel.GESTURE and behavior.kept and behavior.hand is not Hand.BOTH:
            if behavior.hand is None:
                recent = behavior.sync.start - used_s <= HAND_SWITCH_S
                behavior = replace(behavior, hand=hand if recent else own_hand)
            hand, used_s = behavior.hand or own_hand, behavior.sync.end
        elif behavior.kind is Channel.GESTURE and behavior.hand is None:
            behavior = replace(behavior, hand=own_hand)
        yield replace(candidate, behavior=behavior)


def _numbered(candidates: Iterable[Candidate]) -> list[Candidate]:
    """The candidates in order of time, with ids such as `gesture1`."""
    counts = dict.fromkeys(Channel, 0)
    numbered = []
    for candidate in sorted(candidates, key=lambda candidate: candidate.behavior.sync.start):
        kind = candidate.behavior.kind
        counts[kind] += 1
        numbered.append(replace(candidate, behavior=replace(candidate.behavior, id=f"{kind}{counts[kind]}")))
    return numbered


def _most_gestures(character: Character, duration_s: float) -> int:
    return ceil(character.gestures_per_minute * duration_s / 60)


def _time_and_id(behavior: Behavior) -> tuple[float, str]:
    return behavior.sync.start, behavior.id


def _interval(word: Word) -> Interval:
    assert word.interval is not None, "only timed words are asked"
    return word.interval

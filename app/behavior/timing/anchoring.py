"""Converts a movement to a behaviour with times, before its neighbours are considered (paper §3.5).

Its time is that of the word it is anchored to: the stressed vowel of that word, or the word's start where its phones
are not known. Nothing happens before 0. If there is no time before the word even for the shortest preparation, a
gesture begins with the hand already raised, and its reason says so; other behaviours come a little later. Retractions
may run past the end. Times are seconds.
"""

from bisect import bisect_left
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import floor

from ...model import Behavior, Channel, Hand, Interval, Limit, Movement, Phone, SyncPoints, Word
from ...model.limits import LATEST_S, Forms
from ..idle.idle_behaviors import IdleBehavior
from ..table.behavior_table import STROKED, Anchor, BehaviorEntry, BriefGesture, PhaseDuration
from .phases import TimingBasis, Window, placed, soonest, underway

MOVABLE = frozenset({Channel.HEAD, Channel.FACE})
"""The channels on which a planned moment is meant for all of its words, and not for the one of a stroke."""


@dataclass(frozen=True, slots=True)
class PlacedBehavior:
    """A behaviour with the basis of its timing; a gesture with its forms by hand, and with its brief variant; a planned
    head movement or face with the times of its other words, the nearest first, at which it may come instead."""

    behavior: Behavior
    basis: TimingBasis
    forms: Mapping[Hand, Forms] = field(default_factory=dict)
    brief: BriefGesture | None = None
    elsewhere_s: tuple[float, ...] = ()

    @property
    def own_forms(self) -> Forms:
        """The forms for the behaviour's hand."""
        return self.forms.get(self.behavior.hand or Hand.RIGHT, ())

    @property
    def firm_end_s(self) -> float:
        """The earliest end without loss of stroke or hold."""
        sync = self.behavior.sync
        return min(sync.end, (sync.relax or sync.end) + self.basis.timing.retraction.shortest_s)

    @property
    def stroke_end_s(self) -> float:
        """The earliest end without loss of stroke, with the shortest hold."""
        sync, timing = self.behavior.sync, self.basis.timing
        if sync.stroke_end is None:
            return self.firm_end_s
        return min(self.firm_end_s, sync.stroke_end + timing.hold.shortest_s + timing.retraction.shortest_s)


def asked(
    movement: Movement, entry: BehaviorEntry, timed: tuple[Word, ...], name: str, *, may_be_brief: bool = False
) -> PlacedBehavior:
    """The movement as `entry` defines it, with `name` as its id; kept is false where it cannot be timed.

    With `may_be_brief` its stroke is shortened if it would otherwise be late, or if its neighbours require that.
    """
    brief = entry.brief if may_be_brief else None
    if brief:
        entry = replace(entry, timing=replace(entry.timing, hold=PhaseDuration(0.0, entry.timing.hold.usual_s)))
    begin, past = words_before(timed, movement.first), words_before(timed, movement.last + 1)
    words = timed[begin:past]
    if words:
        at_s, until_s = stressed_vowel_s(_stroke_word(movement, entry.anchor, words)), interval_of(words[-1]).end_s
    else:
        at_s = until_s = max((interval_of(word).end_s for word in timed[:begin]), default=0.0)
    basis, sync, hurry = _in_time(_timing_basis(entry, at_s, until_s), entry.channel)
    if brief and basis.at_s > at_s:
        entry = replace(entry, timing=brief.timing, forms=brief.forms)
        basis, sync, hurry = _in_time(_timing_basis(entry, at_s, until_s), entry.channel)
    late_s = basis.at_s - at_s if entry.channel is Channel.GESTURE else 0.0
    reason = _late(late_s) if late_s > LATEST_S else hurry if words else "none of its words is spoken"
    in_time = bool(words) and late_s <= LATEST_S
    behavior = _behavior(entry, name, sync, movement, reason=reason, kept=in_time)
    behavior = behavior if in_time else replace(behavior, limit=Limit.TIME)
    elsewhere_s = _elsewhere_s(words, at_s) if movement.moment and entry.channel in MOVABLE else ()
    return PlacedBehavior(behavior, basis, entry.forms, brief, elsewhere_s)


def _elsewhere_s(words: Sequence[Word], at_s: float) -> tuple[float, ...]:
    """The stressed vowels of words but that at `at_s`, the nearest first."""
    others_s = {floor(stressed_vowel_s(word) * 1000) / 1000 for word in words} - {floor(at_s * 1000) / 1000}
    return tuple(sorted(others_s, key=lambda other_s: (abs(other_s - at_s), other_s)))


def placed_idle(idle: IdleBehavior, entry: BehaviorEntry, name: str) -> PlacedBehavior:
    """An idle behaviour, with the least priority."""
    basis = _timing_basis(entry, idle.at_s, idle.at_s)
    basis, sync, _hurry = _in_time(basis, entry.channel)
    return PlacedBehavior(_behavior(entry, name, sync, _idle_movement(entry, idle.word), reason=idle.reason), basis)


def filler(entry: BehaviorEntry, interval: Interval, word: int, reason: str) -> PlacedBehavior:
    """An idle behaviour that fills a free interval, which must have room for its shortest phases."""
    timing = entry.timing
    retraction_s = min(timing.retraction.usual_s, interval.duration_s / 4)
    at_s = interval.start_s + min(timing.preparation.usual_s + timing.stroke.usual_s, interval.duration_s / 2)
    basis = TimingBasis(timing, at_s, interval.end_s - retraction_s, entry.channel in STROKED)
    sync = placed(basis, Window(interval.start_s, interval.end_s))
    assert sync is not None, "the interval has room for it"
    name = f"own.{entry.name}.{interval.start_s:.3f}"
    return PlacedBehavior(_behavior(entry, name, sync, _idle_movement(entry, word), reason=reason), basis)


def stressed_vowel_s(word: Word) -> float:
    """The start of the vowel of a timed word's stressed syllable; the word's start if its vowels are not known.

    The vowel with the primary stress; for phones without stress digits, the longest other than AH, because length is
    the strongest cue of stress and AH is what English vowels weaken to (docs/references.md, "Stress").
    """
    vowels = [phone for phone in word.phones if phone.label in _VOWELS]
    if not vowels:
        return interval_of(word).start_s
    return max(vowels, key=_strength).interval.start_s


def words_before(timed: Sequence[Word], index: int) -> int:
    """How many of the timed words, which are in order, come before the word with this index."""
    return bisect_left(timed, index, key=_index)


def _index(word: Word) -> int:
    return word.index


def interval_of(word: Word) -> Interval:
    """The interval of a word that has one."""
    assert word.interval is not None, "only timed words are asked"
    return word.interval


_VOWELS = frozenset(["AA", "AE", "AH", "AO", "AW", "AY", "EH", "ER", "EY", "IH", "IY", "OW", "OY", "UH", "UW"])

_DIGIT_RANKS = {None: 0, 0: 0, 2: 1, 1: 2}
"""The strength of ARPABET's stress digits: 1 is the primary stress, 2 the secondary."""


def _strength(vowel: Phone) -> tuple[int, bool, float]:
    return _DIGIT_RANKS[vowel.stress], vowel.label != "AH", round(vowel.interval.duration_s, 3)


def _stroke_word(movement: Movement, anchor: Anchor, words: Sequence[Word]) -> Word:
    """The word a stroke falls on: the movement's own if it is spoken, else the anchor; of equally emphasised words the
    last."""
    for word in words:
        if word.index == movement.stroke:
            return word
    if anchor is Anchor.FIRST:
        return words[0]
    if anchor is Anchor.LAST:
        return words[-1]
    return max(reversed(words), key=lambda word: word.emphasis or 0.0)


def _timing_basis(entry: BehaviorEntry, at_s: float, until_s: float) -> TimingBasis:
    stroked = entry.channel in STROKED
    earliest_s = 0.0 if stroked else entry.timing.preparation.shortest_s
    return TimingBasis(entry.timing, max(floor(at_s * 1000) / 1000, earliest_s), until_s, stroked)


def _in_time(basis: TimingBasis, channel: Channel) -> tuple[TimingBasis, SyncPoints, str | None]:
    """The basis, or one that begins with the performance; its sync points; and the reason for the change."""
    sync = placed(basis, Window())
    if sync is not None:
        return basis, sync, None
    if channel is Channel.GESTURE:
        basis, why = underway(basis), "begins with the hand raised: there is no time to raise it"
    else:
        basis, why = soonest(basis), "a little late: there is no time before its word"
    sync = placed(basis, Window())
    assert sync is not None, "what begins at 0 has room"
    return basis, sync, why


def _late(late_s: float) -> str:
    return f"its stroke would come {late_s:.2f} s after its word: there is too little time before it; add a lead-in"


def _idle_movement(entry: BehaviorEntry, word: int) -> Movement:
    """An idle movement on a word, with the least priority."""
    return Movement(entry.name, word, word, 0.0, "", None)


def _behavior(
    entry: BehaviorEntry, name: str, sync: SyncPoints, movement: Movement, *, reason: str | None, kept: bool = True
) -> Behavior:
    return Behavior(
        id=name,
        kind=entry.channel,
        lexeme=entry.lexeme,
        sync=sync,
        first=movement.first,
        last=movement.last,
        priority=movement.priority,
        rule=movement.rule or None,
        function=movement.function,
        moment=movement.moment,
        hand=entry.hand,
        amount=entry.amount,
        target=movement.target or entry.target,
        direction=entry.direction,
        repetitions=entry.repetitions,
        kept=kept,
        reason=reason,
        decided_by=movement.decided_by,
    )

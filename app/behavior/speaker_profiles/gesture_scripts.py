"""Connects a speaker's profile to a line: gives gesture generation what it needs from the other stages, and turns its
script into behaviours.

What rules and notes forbid stays forbidden: lexemes that the behaviour table does not offer, hands that it does not
offer them for, iconic gestures without their words, what a director wants avoided or still, and transitions that are
too fast. Gestures that a director, a caller's functions or a pointing ask for are made by the rules; the profile's
gestures leave time for them.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from ...model import (
    Alternative,
    Behavior,
    BehaviorCandidates,
    Channel,
    Direction,
    Function,
    Hand,
    Interval,
    Moment,
    Utterance,
)
from ...profiles.generation.candidates import ClosedWords, PlayableGesture, Repertoire
from ...profiles.generation.generating import Speaker, generate
from ...profiles.generation.script import GestureScript, behaviors_of
from ...profiles.profile import Profile, tag_of, tags_of
from ...text.transcript import MAX_WORDS
from ..candidates.notes import WORDS_NEAR
from ..candidates.vocabulary import ANYTHING, HANDS, STILL
from ..characters.overlays import Character
from ..reading.families import Families, merged
from ..reading.player import Player
from ..table.behavior_table import BehaviorEntry

Channels = Mapping[str, tuple[Channel, str]]
"""The channel and lexeme of behaviours by name."""


def without_planned_gestures(moments: Iterable[Moment]) -> tuple[Moment, ...]:
    """The moments of a plan without its gestures, except those that a director's notes ask for."""
    return tuple(each for each in moments if each.channel is not Channel.GESTURE or each.note is not None)


def without_chosen_gestures(
    candidates: Iterable[BehaviorCandidates], lexemes: Channels
) -> Iterator[BehaviorCandidates]:
    """The candidates without gestures, except those that a note or a caller's function asks for."""
    for offer in candidates:
        if (offer.moment and offer.moment.note is not None) or (offer.function and offer.function.given):
            yield offer
            continue
        alternatives = tuple(_without_gestures(offer.alternatives, lexemes))
        if alternatives:
            yield replace(offer, alternatives=alternatives)


def gesture_script(
    profile: Profile, repertoire: Repertoire, utterance: Utterance, functions: Sequence[Function], *, seed: int
) -> GestureScript:
    """The gesture script that a profile generates for a line."""
    return generate(Speaker(profile, repertoire, seed), utterance, tags_of(functions))


def scripted_behaviors(
    script: GestureScript, functions: Iterable[Function], kept: Sequence[Behavior]
) -> tuple[Behavior, ...]:
    """The behaviours of a script, each with the function that it shows. A rest that overlaps a kept change of posture
    is dropped."""
    shown = {(tag_of(each), each.first, each.last): each.id for each in functions if each.kept}
    postures = [each for each in kept if each.kept and each.kind is Channel.POSTURE]
    return tuple(_beside(each, postures) for each in behaviors_of(script, shown))


def _beside(behavior: Behavior, postures: Iterable[Behavior]) -> Behavior:
    if behavior.kind is not Channel.POSTURE:
        return behavior
    sync = behavior.sync
    other = next((each for each in postures if each.sync.start < sync.end and sync.start < each.sync.end), None)
    if other is None:
        return behavior
    return replace(behavior, kept=False, lost_to=other.id, reason=f"the body is about to take {other.lexeme}")


def repertoire_of(
    player: Player, character: Character, direction: Direction | None = None, kept: Iterable[Behavior] = ()
) -> Repertoire:
    """What a character may play in a line: its gestures, what is forbidden and what a director's notes close, and when
    its hands are taken by the gestures among the `kept`."""
    families = player.families
    forbidden = (ClosedWords(ban.first, ban.last, lexemes) for ban, lexemes in player.banned_lexemes() if lexemes)
    asked = (each for each in kept if each.kept and each.kind is Channel.GESTURE)
    return Repertoire(
        gestures=dict(_playable(character.entries.values(), _needed_lemmas(families, character))),
        closed=(*forbidden, *(_closed(direction, families) if direction else ())),
        taken=tuple(Interval(each.sync.start, each.sync.end) for each in asked),
    )


def _without_gestures(alternatives: Iterable[Alternative], lexemes: Channels) -> Iterator[Alternative]:
    for alternative in alternatives:
        movements = tuple(each for each in alternative.movements if lexemes[each.name][0] is not Channel.GESTURE)
        if movements:
            yield replace(alternative, movements=movements)


def _playable(
    entries: Iterable[BehaviorEntry], lemmas: Mapping[str, frozenset[str]]
) -> Iterator[tuple[str, PlayableGesture]]:
    """The gestures of the table by lexeme, each with the hands of all its entries; the first entry has its times."""
    by_lexeme: dict[str, list[BehaviorEntry]] = {}
    for entry in entries:
        if entry.channel is Channel.GESTURE and entry.forms:
            by_lexeme.setdefault(entry.lexeme, []).append(entry)
    for lexeme, own in by_lexeme.items():
        hands = {hand for entry in own for hand in ((Hand.LEFT, Hand.RIGHT) if entry.hand is None else (entry.hand,))}
        forms = {hand: own[0].forms[hand] for hand in Hand if hand in hands and hand in own[0].forms}
        timing = own[0].timing
        needed = lemmas.get(lexeme, frozenset())
        yield lexeme, PlayableGesture(forms, timing.stroke.usual_s, timing.emphasis, own[0].amount, needed)


def _needed_lemmas(families: Families, character: Character) -> Mapping[str, frozenset[str]]:
    """The words, by lexeme, one of which must be spoken for the gesture: of lexemes all of whose families need one."""
    listed = [(family, each) for family, behaviors in families.gesture.items() for each in behaviors]
    free = {merged(family) for family, each in listed if not each.lemmas}
    found: dict[str, frozenset[str]] = {}
    for _family, each in listed:
        lexeme = character.lexemes[each.name][1]
        if not any(merged(shown) in free for shown in families.shows.get(lexeme, ())):
            found[lexeme] = found.get(lexeme, frozenset()) | each.lemmas
    return found


def _closed(direction: Direction, families: Families) -> Iterator[ClosedWords]:
    if direction.complete:
        yield ClosedWords(0, MAX_WORDS)
    for avoidance in direction.avoid:
        first, last = avoidance.first - WORDS_NEAR, avoidance.last + WORDS_NEAR
        if {ANYTHING, HANDS} & {*avoidance.what}:
            yield ClosedWords(first, last)
        lexemes = {lexeme for lexeme, shown in families.shows.items() if {*shown} <= {*avoidance.what}}
        yield ClosedWords(first, last, frozenset(lexemes))
    for moment in direction.moments:
        if moment.gesture[:1] == (STILL,):
            yield ClosedWords(moment.first, moment.last)

"""Applies a speaker's profile to a line: its gestures and its other habits.

Gesture generation gets what it needs from the other stages, and its script is turned into behaviours. What rules and
notes forbid stays forbidden: lexemes that the behaviour table does not offer, hands that it does not offer them for,
iconic gestures without their words, what a director wants avoided or still, and transitions that are too fast. Gestures
that a director, a caller's functions or a pointing ask for are made by the rules; the profile's gestures leave time for
them.

The other habits are those of speakers and listeners: how much the head moves, how long the eyes stay on the listener,
the posture, and where the hands rest.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from ..model import (
    Alternative,
    Behavior,
    BehaviorCandidates,
    Channel,
    Direction,
    Function,
    Hand,
    Interval,
    Moment,
    SyncPoints,
    Utterance,
)
from ..profiles.generation.candidates import ClosedWords, PlayableGesture, Repertoire
from ..profiles.generation.generating import Speaker, generate
from ..profiles.generation.phases import rest_after
from ..profiles.generation.script import PRIORITY, RESTS, STANCES, GestureScript, behaviors_of
from ..profiles.profile import Profile, tag_of, tags_of
from ..text.transcript import MAX_WORDS
from .candidates.notes import WORDS_NEAR
from .candidates.vocabulary import ANYTHING, HANDS, STILL
from .characters.overlays import Character
from .listeners.listening import HeadRates
from .reading.families import Families, merged
from .reading.player import Player
from .table.behavior_table import BehaviorEntry

HEAD_MOVEMENTS_PER_MINUTE = 20.0
"""The rate of the default character in the lines of the example annotations; a speaker's own is relative to it."""

LEAST_ACTIVITY, MOST_ACTIVITY = 0.3, 2.0
SETTLED_S = 0.1
"""The duration of a posture change that ends so soon that the first frame shows its result."""


def as_speaker(character: Character, profile: Profile) -> Character:
    """The character with the head, eyes and rests of a profile; the hands follow the gesture script.

    The activity of the head scales `gestures_per_minute`, on which the amount of planned movement depends.
    """
    eye_contact = profile.head.eye_contact
    return replace(
        character,
        gestures_per_minute=character.gestures_per_minute * head_activity(profile),
        eye_contact=character.eye_contact if eye_contact is None else eye_contact,
        rest_poses=(),
    )


def as_listener(rates: HeadRates, profile: Profile) -> HeadRates:
    """How often the profile's speaker nods and mirrors when listening: the usual rates, scaled by how much the head
    moves in speech, since listeners are not annotated. Gaze keeps the statistics of listeners: people look at a speaker
    for longer than at a listener."""
    activity = head_activity(profile)
    return replace(
        rates,
        nods_after_pause=min(1.0, rates.nods_after_pause * activity),
        nods_after_phrase=min(1.0, rates.nods_after_phrase * activity),
        mirrored=min(1.0, rates.mirrored * activity),
    )


def head_activity(profile: Profile) -> float:
    """How much the head moves relative to the default character; 1 if head movements were not annotated."""
    per_minute = profile.head.per_minute
    activity = sum(per_minute.values()) / HEAD_MOVEMENTS_PER_MINUTE if per_minute else 1.0
    return min(max(activity, LEAST_ACTIVITY), MOST_ACTIVITY)


def speaking_postures(profile: Profile) -> Iterator[Behavior]:
    """The posture in which the profile's speaker begins a line (the default posture of NGS §3.2)."""
    yield from _from_the_first_frame(profile, _marked(profile))


def listening_postures(profile: Profile, duration_s: float) -> Iterator[Behavior]:
    """The posture of the profile's speaker while somebody else speaks for `duration_s`: that of speaking, with the
    hands in the rest pose for a rest of that length, unless the posture says where they are."""
    marked = _marked(profile)
    resting = () if any(each in RESTS.values() for each in marked) else (RESTS[rest_after(profile.rests, duration_s)],)
    yield from _from_the_first_frame(profile, (*marked, *resting))


def _marked(profile: Profile) -> tuple[str, ...]:
    """The most frequent annotated postures that the realizer has: at most one of the feet and one of the hands."""
    postures = profile.head.postures
    first = (next((each for each in postures if each in known), None) for known in (STANCES, RESTS.values()))
    return tuple(each for each in first if each is not None)


def _from_the_first_frame(profile: Profile, lexemes: tuple[str, ...]) -> Iterator[Behavior]:
    for number, lexeme in enumerate(lexemes):
        yield Behavior(
            id=f"habit.{number}",
            kind=Channel.POSTURE,
            lexeme=lexeme,
            sync=SyncPoints(start=0.0, end=SETTLED_S),
            first=0,
            last=0,
            priority=PRIORITY,
            rule=f"profile_{profile.name}",
            reason=f"the usual stance of {profile.name}",
        )


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
    return replace(behavior, kept=False, lost_to=other.id, reason=f"the body is about to change to {other.lexeme}")


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

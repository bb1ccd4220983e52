"""What of a speaker's profile is not gestures: how much the head moves, how long the eyes stay on the listener, how the
body stands and where the hands rest. Those who speak have it, and those who listen.
"""

from collections.abc import Iterator
from dataclasses import replace

from .bml.choice.characters.characters import Character
from .bml.choice.listeners.head_rates import HeadRates
from .model import Behavior, Channel, SyncPoints
from .profiles.generation.behaviors import PRIORITY, RESTS, STANCES
from .profiles.generation.units import rest_after
from .profiles.profile import Profile

HEAD_MOVEMENTS_PER_MINUTE = 20.0
"""Of the default character in the lines of the example annotations: the measure of a speaker's own."""

LEAST_ACTIVITY, MOST_ACTIVITY = 0.3, 2.0
SETTLED_S = 0.1
"""A posture that is over so soon is that of the first frame."""


def as_speaker(character: Character, profile: Profile) -> Character:
    """The character with the head, eyes and rests of a profile; the hands are the script's.

    How much the head moves goes with how much the character does at all.
    """
    eye_contact = profile.head.eye_contact
    return replace(
        character,
        gestures_per_minute=character.gestures_per_minute * head_activity(profile),
        eye_contact=character.eye_contact if eye_contact is None else eye_contact,
        rest_poses=(),
    )


def as_listener(rates: HeadRates, profile: Profile) -> HeadRates:
    """How often the profile's speaker nods and mirrors when listening: as others do, more or less by how much the head
    moves in speech, for nobody marks listeners. Eyes are left to listeners' own statistics: people look longer at whom
    they listen to than at whom they speak to."""
    activity = head_activity(profile)
    return replace(
        rates,
        nods_after_pause=min(1.0, rates.nods_after_pause * activity),
        nods_after_phrase=min(1.0, rates.nods_after_phrase * activity),
        mirrored=min(1.0, rates.mirrored * activity),
    )


def head_activity(profile: Profile) -> float:
    """How much the head moves beside others'; 1 where nobody marked it."""
    per_minute = profile.head.per_minute
    activity = sum(per_minute.values()) / HEAD_MOVEMENTS_PER_MINUTE if per_minute else 1.0
    return min(max(activity, LEAST_ACTIVITY), MOST_ACTIVITY)


def speaking_postures(profile: Profile) -> Iterator[Behavior]:
    """How the profile's speaker stands as a line begins (the default posture of NGS §3.2)."""
    yield from _from_the_first_frame(profile, _marked(profile))


def listening_postures(profile: Profile, duration_s: float) -> Iterator[Behavior]:
    """How the profile's speaker stands while somebody else speaks for so long: as when speaking, and with the hands
    where they rest for so long, unless the posture says where they are."""
    marked = _marked(profile)
    resting = () if any(each in RESTS.values() for each in marked) else (RESTS[rest_after(profile.rests, duration_s)],)
    yield from _from_the_first_frame(profile, (*marked, *resting))


def _marked(profile: Profile) -> tuple[str, ...]:
    """The commonest of the postures that were marked and that bodies have, of the feet and of the hands."""
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
            reason=f"{profile.name} stands so",
        )

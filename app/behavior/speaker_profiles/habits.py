"""Applies the habits of a speaker's profile other than gestures, to speakers and listeners: how much the head moves,
how long the eyes stay on the listener, the posture, and where the hands rest.
"""

from collections.abc import Iterator
from dataclasses import replace

from ...model import Behavior, Channel, SyncPoints
from ...profiles.generation.phases import rest_after
from ...profiles.generation.script import PRIORITY, RESTS, STANCES
from ...profiles.profile import Profile
from ..characters.overlays import Character
from ..listeners.listening import HeadRates

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
            reason=f"{profile.name} stands so",
        )

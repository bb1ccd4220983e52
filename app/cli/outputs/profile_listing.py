"""Summarizes a gesture profile for people."""

from collections.abc import Iterator, Mapping

from ...model import Hand
from ...profiles.profile import Profile

MOST_LEXEMES = 12
MOST_TAGS = 12
MOST_OF_A_TAG = 4


def profile_lines(profile: Profile) -> Iterator[str]:
    """The most prominent habits of a profile; the file has all."""
    yield f"{profile.name}: {profile.description}"
    rate, sizes = profile.gestures_per_minute, profile.units.sizes
    yield f"{rate:.1f} gestures a minute, units of {_mean_size(sizes):.1f} gestures on average"
    if sizes:
        yield f"units of 1, 2, … 6 and more: {' '.join(f'{share:.0%}' for share in sizes)}"
    hands = {hand.value: _share(profile, hand) for hand in Hand}
    yield f"hands: {_shares(hands)}"
    lexemes = {name: habit.share for name, habit in profile.lexemes.items()}
    yield f"gestures: {_shares(lexemes, MOST_LEXEMES)}"
    if profile.head.eye_contact is not None:
        yield f"eyes on the listener {profile.head.eye_contact:.0%} of the time"
    yield "what comes with what is said:"
    by_likelihood = sorted(profile.tags.items(), key=lambda item: -sum(item[1].lexemes.values()))
    for tag, habit in by_likelihood[:MOST_TAGS]:
        yield f"  {tag:24s} {sum(habit.lexemes.values()):4.0%}  {_shares(habit.lexemes, MOST_OF_A_TAG)}"


def _share(profile: Profile, hand: Hand) -> float:
    return sum(habit.share * habit.hands.get(hand, 0.0) for habit in profile.lexemes.values())


def _mean_size(sizes: tuple[float, ...]) -> float:
    return sum(size * share for size, share in enumerate(sizes, start=1)) or 1.0


def _shares(shares: Mapping[str, float], most: int = 99) -> str:
    named = sorted(shares.items(), key=lambda item: (-item[1], item[0]))
    more = f" … {len(named) - most} more" if len(named) > most else ""
    return ", ".join(f"{name} {share:.0%}" for name, share in named[:most]) + more

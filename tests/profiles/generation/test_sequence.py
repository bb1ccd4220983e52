"""The chain of gestures: as many as the speaker makes, each as likely as it is, never too close."""

import random
from collections import Counter
from itertools import pairwise

import pytest

from tests.support.words.scripted import habit, line, profile, repertoire
from understudy.model import Hand
from understudy.profiles.annotation.model import TaggedWords
from understudy.profiles.generation.candidates import StrokeWord, places_of
from understudy.profiles.generation.sequence import APART_S, drawn_gestures, drawn_hands
from understudy.profiles.profile import Profile

TAG = TaggedWords("x", 0, 0)


def _places(number: int, weights: dict[str, float], *, step_s: float = 0.5) -> list[StrokeWord]:
    return [StrokeWord(each, each * step_s, 0, weights, dict.fromkeys(weights, TAG)) for each in range(number)]


def _profile(**shares: float) -> Profile:
    return profile({name: habit(share) for name, share in shares.items()}, {"any": shares})


@pytest.mark.parametrize("expected", [2.0, 5.0, 10.0])
def test_as_many_are_made_as_expected_and_none_too_close(expected: float) -> None:
    places, rng = _places(60, {"A": 0.2, "B": 0.1}), random.Random(1)
    drawn = [drawn_gestures(_profile(A=0.6, B=0.4), places, expected=expected, rng=rng) for _ in range(50)]
    counts = [len(each) for each in drawn]
    assert sum(counts) / 50 == pytest.approx(expected, abs=3 * (expected / 50) ** 0.5)  # three standard errors
    assert max(abs(count - expected) for count in counts) <= 2  # several are drawn, and the nearest is taken
    for each in drawn:
        assert all(other.place.end_s - one.place.end_s >= APART_S for one, other in pairwise(each))


def test_shares_come_out_as_they_are() -> None:
    places, rng = _places(60, {"A": 0.15, "B": 0.05}), random.Random(1)
    drawn = [drawn_gestures(_profile(A=0.75, B=0.25), places, expected=8, rng=rng) for _ in range(40)]
    made = Counter(gesture.lexeme for each in drawn for gesture in each)
    assert made["A"] / made.total() == pytest.approx(0.75, abs=0.05)


def test_what_follows_what_is_kept() -> None:
    follower = _profile(A=0.5, B=0.5)
    follower = Profile(
        **{name: getattr(follower, name) for name in Profile.__slots__}
        | {"follows": {"A": {"A": 0.02, "B": 0.98}, "B": {"A": 0.98, "B": 0.02}}}
    )
    drawn = drawn_gestures(follower, _places(80, {"A": 0.1, "B": 0.1}), expected=20, rng=random.Random(2))
    changes = sum(one.lexeme != other.lexeme for one, other in pairwise(drawn))
    assert changes / (len(drawn) - 1) > 0.85


def test_the_likeliest_sequence_has_the_likeliest_gestures() -> None:
    places = _places(20, {"A": 0.12, "B": 0.1})
    drawn = drawn_gestures(_profile(A=0.5, B=0.5), places, expected=4, rng=random.Random(0), likeliest=True)
    assert {each.lexeme for each in drawn} == {"A"}


def test_nothing_is_made_of_nothing() -> None:
    assert drawn_gestures(_profile(A=1.0), [], expected=3, rng=random.Random(0)) == ()
    assert drawn_gestures(_profile(A=1.0), _places(5, {"A": 0.5}), expected=0, rng=random.Random(0)) == ()


def test_a_hand_that_the_table_does_not_offer_is_never_taken() -> None:
    both = profile({"A": habit(1.0)}, {"any": {"A": 0.5}})
    left = Profile(
        **{name: getattr(both, name) for name in Profile.__slots__}
        | {
            "lexemes": {
                "A": habit(1.0).__class__(1.0, {Hand.BOTH: 1.0}, both.lexemes["A"].strokes, both.lexemes["A"].offset_s)
            }
        }
    )
    drawn = drawn_gestures(left, _places(30, {"A": 0.5}), expected=6, rng=random.Random(0))
    hands = drawn_hands(left, drawn, repertoire("A"), rng=random.Random(0))
    assert len(hands) == len(drawn)
    assert Hand.BOTH not in hands


def test_candidates_are_likely_playable_and_on_their_words() -> None:
    speaker = profile({"A": habit(0.5), "B": habit(0.4), "C": habit(0.1)}, {"any": {"A": 0.3, "B": 0.2, "C": 0.005}})
    tags = [TaggedWords("deixis.self", 1, 2), TaggedWords("negation", 2, 2)]
    [place] = places_of(speaker, repertoire("A", "C"), line("a b c d"), tags)
    assert place.word == 2
    # C is under a fiftieth of the gestures, B is not in the repertoire; A stands for them, for both tags.
    assert place.weights.keys() == {"A"}
    assert place.weights["A"] == pytest.approx(2 * 0.505 * 0.3 / 0.5)


def test_mimes_need_their_words() -> None:
    speaker = profile({"A": habit(1.0)}, {"any": {"A": 0.3}})
    tags = [TaggedWords("x", 1, 1)]
    assert not places_of(speaker, repertoire("A", lemmas=["phone"]), line("nothing of it"), tags)
    assert places_of(speaker, repertoire("A", lemmas=["phone"]), line("the phone rang"), tags)


@pytest.mark.parametrize("likeliest", [False, True])
def test_where_next_to_no_gesture_is_expected_there_is_none(likeliest: bool) -> None:
    """A segment gets what others left it, which may be as little as rounding leaves."""
    places = _places(4, {"A": 0.5})
    drawn = drawn_gestures(_profile(A=1.0), places, expected=1e-15, rng=random.Random(0), likeliest=likeliest)
    assert drawn == ()

"""What is learnt of a speaker: the counts of NGS §3.2, smoothed."""

from pathlib import Path

import pytest

from tests.support.annotations import SPARING, SWEEPING, small_tracks
from understudy.errors import InputError
from understudy.model import Hand
from understudy.profiles.annotation.reading import annotation_of, read_annotations
from understudy.profiles.learning.learner import learn
from understudy.profiles.learning.observations import observed_gestures, observed_tags
from understudy.profiles.profile import Profile
from understudy.profiles.segments import spoken_s


@pytest.fixture(scope="module")
def profiles() -> tuple[Profile, Profile]:
    sweeping, sparing = read_annotations([SWEEPING, SPARING])
    return learn([sweeping], "sweeping"), learn([sparing], "sparing")


def test_observations_of_a_short_annotation() -> None:
    annotation = annotation_of(small_tracks().values(), Path("x"))
    me, no, you = observed_gestures(annotation)
    assert [each.before for each in (me, no, you)] == ["first", "ME", "NEGATION"]
    assert [each.tags for each in (me, no, you)] == [("deixis.self",), ("negation",), ("deixis.addressee",)]
    assert me.offset_s == pytest.approx(0.0)  # the stroke ends at .9, as the word does
    assert no.offset_s == pytest.approx(1.8 - 1.3)
    assert no.gap_s == pytest.approx(1.6 - 1.3)  # from the after-stroke
    assert (no.joined, you.joined) == (True, False)
    assert [each.outcome for each in observed_tags(annotation)] == [
        {"ME": 1.0, "": 0.0},
        {"NEGATION": 1.0, "": 0.0},
        {"YOU": 1.0, "": 0.0},
    ]
    assert spoken_s(annotation.words, annotation.segments) == pytest.approx(2.4)


def test_a_gesture_on_words_of_several_tags_is_shared_by_them() -> None:
    tracks = small_tracks()
    tracks["tags"] = type(tracks["tags"])("tags", (*tracks["tags"].spans, *tracks["tags"].spans[:1]))
    outcomes = [each.outcome for each in observed_tags(annotation_of(tracks.values(), Path("x")))]
    assert sorted(each.get("ME", 0.0) for each in outcomes) == [0.0, 0.0, 0.5, 0.5]


def test_too_few_gestures_are_no_habit() -> None:
    with pytest.raises(InputError, match="3 gestures are annotated"):
        learn([annotation_of(small_tracks().values(), Path("x"))], "nobody")


def test_probabilities_are_some(profiles: tuple[Profile, Profile]) -> None:
    for profile in profiles:
        assert sum(habit.share for habit in profile.lexemes.values()) == pytest.approx(1)
        for habit in profile.tags.values():
            assert 0 <= sum(habit.lexemes.values()) <= 1
        sums = [sum(row.values()) for row in profile.follows.values()]
        sums += [sum(row.values()) for row in profile.hand_follows.values()]
        assert sums == pytest.approx([1.0] * len(sums))
        for lexeme in profile.lexemes.values():
            assert sum(lexeme.hands.values()) == pytest.approx(1)
        assert sum(profile.units.sizes) == pytest.approx(1)


def test_the_styles_by_which_the_examples_were_made_are_found_again(profiles: tuple[Profile, Profile]) -> None:
    """training/profiles/styles.yaml says what there is to find."""
    sweeping, sparing = profiles
    assert sweeping.gestures_per_minute == pytest.approx(24, rel=0.1)
    assert sparing.gestures_per_minute == pytest.approx(15, rel=0.1)
    assert sweeping.head.eye_contact == pytest.approx(0.55, abs=0.02)
    assert sparing.head.eye_contact == pytest.approx(0.75, abs=0.02)
    beat = sparing.lexemes["BEAT"].hands
    assert beat[Hand.LEFT] > beat[Hand.RIGHT] > beat[Hand.BOTH]
    assert sweeping.units.merge_within_s > 2 * sparing.units.merge_within_s
    assert sum(size * share for size, share in enumerate(sweeping.units.sizes, start=1)) > 2
    assert sparing.units.sizes[0] > 0.7
    assert sweeping.forms["OPEN_HAND"].size > 1.1
    assert sparing.forms["OPEN_HAND"].size < 0.9
    assert sweeping.rests.near == "open"


def test_how_often_units_go_on_is_learnt_by_their_size(profiles: tuple[Profile, Profile]) -> None:
    """By one share for every size up to six; longer units go on as often as the last says."""
    units = profiles[0].units
    assert len(set(units.joined)) > 1
    assert units.joined_after(9) == units.joined[-1]
    assert all(0 <= share <= 1 for share in units.joined)


def test_tags_tell_something_by_held_out_likelihood(profiles: tuple[Profile, Profile]) -> None:
    for profile in profiles:
        assert profile.smoothing.held_out > profile.smoothing.blind
    negation = profiles[0].tags["negation"].lexemes
    assert max(negation, key=negation.__getitem__) in {"NEGATION", "SWEEP_AWAY", "PALMS_OUT"}

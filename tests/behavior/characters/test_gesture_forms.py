from dataclasses import replace

import pytest

from tests.support.characters import CHARACTERS
from tests.support.words.by_hand import FIGURE_8, movement, offered, spoken, utterance
from understudy.behavior.characters.gesture_forms import FormedCharacters, with_forms
from understudy.behavior.choice.scheduling import schedule
from understudy.errors import InputError
from understudy.model import Channel, Hand, Level
from understudy.model.limits import ArmEnds, GestureForm, GestureTable

ENDS = ArmEnds((0.0, 0.0, 0.0), (0.3, 0.0, 0.0), (0.3, 0.0, 0.0))
SHORT, LONG = (GestureForm(0.3, after_s, 0.6, {Hand.RIGHT: ENDS}) for after_s in (0.1, 0.2))
TABLE = GestureTable({("NEGATION", Level.LOW, hand): (SHORT, LONG) for hand in Hand})
LIVELY = replace(CHARACTERS.named("default"), gestures_per_minute=60)


def test_a_stroke_is_as_long_as_its_longest_form_and_still_ends_as_the_vowel_begins() -> None:
    character = with_forms(LIVELY, TABLE, Level.LOW)
    line = utterance(spoken(FIGURE_8))
    behaviors = schedule([offered(movement("gesture_negation", 2))], line, character, seed=0)
    (gesture,) = (each for each in behaviors if each.kind is Channel.GESTURE)
    vowel_s = 1.0 + 2 * 0.4 + 0.2
    assert gesture.sync.stroke_end == pytest.approx(vowel_s)
    assert gesture.sync.stroke == pytest.approx(vowel_s - 0.2)
    assert gesture.sync.stroke_start == pytest.approx(vowel_s - 0.5)


def test_what_the_table_does_not_have_stays_as_it_is() -> None:
    character = with_forms(LIVELY, TABLE, Level.LOW)
    for name in ("gesture_me", "small_nod"):
        assert character.entries[name] == LIVELY.entries[name]
    assert with_forms(LIVELY, TABLE, Level.HIGH) == LIVELY


def test_a_stroke_that_would_come_far_too_late_is_told_with_what_would_help() -> None:
    """Even the half of it, 1 s, that is left where there is no time."""
    slow = GestureTable({("NEGATION", Level.LOW, hand): (GestureForm(1.4, 0.6, 0.6, {}),) for hand in Hand})
    line = utterance(spoken(FIGURE_8, start_s=0.0, word_s=0.1))
    offers = [offered(movement("gesture_negation", 2))]
    behaviors = schedule(offers, line, with_forms(LIVELY, slow, Level.LOW), seed=0)
    (gesture,) = (each for each in behaviors if each.kind is Channel.GESTURE)
    assert not gesture.kept
    assert gesture.reason == (
        "its stroke would come 0.75 s after its word: there is too little time before it; add a lead-in"
    )


def test_what_is_asked_for_is_made_shorter_rather_than_late() -> None:
    """A stroke of .8 s for a word .3 s after the beginning: half of it is .1 s late, the whole would be .5 s."""
    slow = GestureTable({("NEGATION", Level.LOW, hand): (GestureForm(0.5, 0.3, 0.6, {}),) for hand in Hand})
    line = utterance(spoken(FIGURE_8, start_s=0.1, word_s=0.1))
    (gesture,) = (
        each
        for each in schedule(
            [offered(movement("gesture_negation", 2))], line, with_forms(LIVELY, slow, Level.LOW), seed=0
        )
        if each.kind is Channel.GESTURE
    )
    assert gesture.kept
    assert (gesture.sync.stroke_start, gesture.sync.stroke_end) == pytest.approx((0.0, 0.4))


def test_the_brief_form_is_as_long_as_the_longest_that_is_made_then() -> None:
    """Of strokes of .6 and .35 s the first has .3 s when brief, in which the second cannot be made whole; the second,
    brief, takes .23 s."""
    forms = tuple(GestureForm(0.7 * stroke_s, 0.3 * stroke_s, 0.6, {Hand.RIGHT: ENDS}) for stroke_s in (0.6, 0.35))
    table = GestureTable({("NEGATION", Level.LOW, hand): forms for hand in Hand})
    brief = with_forms(LIVELY, table, Level.LOW).entries["gesture_negation"].brief
    assert brief is not None
    longest_s = max(form.stroke_s for form in brief.forms[Hand.RIGHT])
    assert brief.timing.stroke.usual_s == pytest.approx(longest_s)
    assert all(form.within(longest_s).stroke_s <= longest_s for form in forms)


def test_a_character_is_formed_once_for_each_level() -> None:
    formed = FormedCharacters.of(CHARACTERS, TABLE)
    low = formed.named("default", Level.LOW)
    assert low is formed.named("default", Level.LOW)
    assert low.entries["gesture_negation"].forms
    assert not formed.named("default", Level.HIGH).entries["gesture_negation"].forms
    with pytest.raises(InputError) as caught:
        formed.named("nobody", Level.LOW)
    assert caught.value.code == "unknown_character"

from dataclasses import replace
from itertools import combinations

import pytest

from tests.support.characters import CHARACTERS
from tests.support.words.by_hand import FIGURE_8, movement, offered, spoken, utterance
from understudy.behavior.characters.overlays import Character
from understudy.behavior.choice.scheduling import ASKED_MORE, SHORTEST_HOLD_S, eased, schedule
from understudy.behavior.table.behavior_table import PhaseDuration, Timing
from understudy.behavior.timing.anchoring import PlacedBehavior, stressed_vowel_s
from understudy.behavior.timing.conflicts import compete
from understudy.behavior.timing.phases import TimingBasis, Window, placed
from understudy.model import Behavior, Channel, Hand, Interval, Level, Movement, Phone, Word
from understudy.model.lead_in import with_lead_in
from understudy.model.limits import ArmEnds, GestureForm

TIMING = Timing(PhaseDuration(0.2, 0.2), PhaseDuration(0.5, 0.5), PhaseDuration(0.0, 2.0), PhaseDuration(0.0, 0.0))
RIGHT = GestureForm(0.3, 0.2, 0.6, {Hand.RIGHT: ArmEnds((0.0, 0.0, 0.0), (0.3, 0.0, 0.0), (0.3, 0.0, 0.0))})
"""Back over its .3 m at .6 m/s takes .5 s."""


def gesture(name: str, at_s: float, until_s: float, hand: Hand = Hand.RIGHT) -> PlacedBehavior:
    """A stroke of .5 s that ends at `at_s`, held until `until_s`; its preparation takes .2 s."""
    basis = TimingBasis(TIMING, at_s, until_s, stroked=True)
    sync = placed(basis, Window())
    assert sync is not None
    behavior = Behavior(name, Channel.GESTURE, "X", sync, 0, 0, 1.0, hand=hand)
    return PlacedBehavior(behavior, basis, dict.fromkeys((hand, Hand.RIGHT), (RIGHT,)))


def test_a_hold_gives_way_to_a_transition_as_fast_as_the_next_stroke() -> None:
    """The second stroke starts at 3.5 s, so the first relaxes at 3.0 s, not at 3.3 s."""
    first, second = eased((gesture("one", 2.0, 3.3), gesture("two", 4.0, 4.5)))
    assert first.behavior.sync.relax == first.behavior.sync.end == second.behavior.sync.start == pytest.approx(3.0)
    assert second.behavior.sync.stroke_start == pytest.approx(3.5)


def test_some_of_a_hold_is_left() -> None:
    first, second = eased((gesture("one", 2.9, 3.3), gesture("two", 4.0, 4.5)))
    assert first.behavior.sync.relax == second.behavior.sync.start == pytest.approx(2.9 + SHORTEST_HOLD_S)


def test_gestures_that_are_not_joined_stay_as_they_are() -> None:
    apart = (gesture("one", 2.0, 3.0), gesture("two", 4.0, 4.5))
    assert eased(apart) == apart


def test_a_hand_that_is_still_busy_keeps_a_gesture_of_both_where_it_is() -> None:
    busy = (
        gesture("left", 2.6, 3.2, Hand.LEFT),
        gesture("one", 2.0, 3.3),
        gesture("both", 4.0, 4.5, Hand.BOTH),
    )
    assert eased(busy) == busy


LIVELY = replace(CHARACTERS.named("default"), gestures_per_minute=60)


def scheduled(
    *movements: Movement, words: tuple[Word, ...] | None = None, character: Character = LIVELY, seed: int = 0
) -> list[Behavior]:
    """What became of the movements, each wished for by itself."""
    line = utterance(words or spoken(FIGURE_8))
    candidates = [offered(movement) for movement in movements]
    return [behavior for behavior in schedule(candidates, line, character, seed=seed) if behavior.function]


def test_a_stroke_ends_as_the_stressed_vowel_begins() -> None:
    (gesture,) = scheduled(movement("gesture_negation", 2))
    vowel_s = 1.0 + 2 * 0.4 + 0.2
    assert gesture.sync.stroke_end == pytest.approx(vowel_s)
    assert [name for name, _ in gesture.sync.in_order()] == [
        "start",
        "ready",
        "stroke_start",
        "stroke",
        "stroke_end",
        "relax",
        "end",
    ]


def test_a_hold_lasts_to_the_end_of_the_words() -> None:
    (gesture,) = scheduled(movement("gesture_point_right", 9, 10))
    assert gesture.sync.stroke_end == pytest.approx(1.0 + 9 * 0.4 + 0.2)
    assert gesture.sync.relax == pytest.approx(1.0 + 11 * 0.4)


def test_a_gesture_strikes_on_the_most_stressed_word_and_a_pointing_on_the_first() -> None:
    words = spoken(FIGURE_8, stressed=[9])
    for name, word in (("gesture_surround", 9), ("gesture_point_right", 8)):
        (gesture,) = scheduled(movement(name, 8, 10), words=words)
        assert gesture.sync.stroke_end == pytest.approx(1.0 + word * 0.4 + 0.2)


def test_the_stressed_vowel_is_the_primary_one_else_the_word_begins_it() -> None:
    phones = (
        Phone("AH", Interval(1.0, 1.1), 2),
        Phone("L", Interval(1.1, 1.2)),
        Phone("AW", Interval(1.2, 1.3), 1),
        Phone("AH", Interval(1.3, 1.4), 0),
    )
    assert stressed_vowel_s(Word(0, "allowed", Interval(1.0, 1.4), phones)) == 1.2
    assert stressed_vowel_s(Word(0, "allowed", Interval(1.0, 1.4))) == 1.0


def test_without_stress_digits_the_longest_full_vowel_is_the_stressed_one() -> None:
    phones = (
        Phone("P", Interval(1.0, 1.1)),
        Phone("AH", Interval(1.1, 1.3)),
        Phone("T", Interval(1.3, 1.4)),
        Phone("EY", Interval(1.4, 1.55)),
        Phone("T", Interval(1.55, 1.6)),
        Phone("OW", Interval(1.6, 1.7)),
    )
    assert stressed_vowel_s(Word(0, "potato", Interval(1.0, 1.7), phones)) == 1.4


@pytest.mark.parametrize("start_s", [0.25, 0.35, 0.6])
def test_a_gesture_hurries_before_its_word_as_far_as_it_can(start_s: float) -> None:
    (gesture,) = scheduled(movement("gesture_me", 0), words=spoken("I see.", start_s=start_s))
    timing = LIVELY.entries["gesture_me"].timing
    assert gesture.kept
    assert gesture.sync.start >= 0
    assert gesture.sync.stroke_end == pytest.approx(start_s + 0.2)
    assert gesture.sync.ready is not None
    assert gesture.sync.ready - gesture.sync.start >= timing.preparation.shortest_s - 1e-9


@pytest.mark.parametrize(("start_s", "late_s"), [(0.2, 0.0), (0.1, 0.0), (0.0, 0.03)])
def test_where_there_is_no_time_at_all_the_hand_is_raised_already(start_s: float, late_s: float) -> None:
    """The shortest stroke of a gesture takes .23 s, and the vowel of the first word begins .2 s after the word."""
    (gesture,) = scheduled(movement("gesture_me", 0), words=spoken("I see.", start_s=start_s))
    assert gesture.kept
    assert gesture.sync.ready == gesture.sync.start
    assert gesture.sync.stroke_end == pytest.approx(start_s + 0.2 + late_s)
    assert "begins with the hand raised" in (gesture.reason or "")


def test_a_movement_of_the_head_comes_a_little_later_instead() -> None:
    (shake,) = scheduled(movement("shake", 0), words=spoken("No way.", start_s=0, word_s=0.1))
    assert shake.kept
    assert shake.sync.start == 0
    assert "a little late" in (shake.reason or "")


def test_with_a_lead_in_the_first_gesture_has_all_its_time_and_the_budget_is_the_same() -> None:
    line = with_lead_in(utterance(spoken("I see.", start_s=0)), 1.0)
    candidates = [offered(movement("gesture_me", 0))]
    (gesture,) = (each for each in schedule(candidates, line, LIVELY, seed=0) if each.function)
    timing = LIVELY.entries["gesture_me"].timing
    assert gesture.kept
    assert gesture.reason is None
    assert gesture.sync.stroke_end == pytest.approx(1.2)
    assert gesture.sync.ready == pytest.approx(1.2 - timing.stroke.usual_s)
    assert gesture.sync.start == pytest.approx(1.2 - timing.stroke.usual_s - timing.preparation.usual_s)
    quiet = replace(LIVELY, gestures_per_minute=0)
    assert not any(each.kept for each in schedule(candidates, line, quiet, seed=0) if each.kind is Channel.GESTURE)


def test_a_face_comes_a_little_later_instead() -> None:
    (face,) = scheduled(movement("smile", 0), words=spoken("Good day.", start_s=0, word_s=0.2))
    assert face.kept
    assert face.sync.start == 0
    assert face.sync.ready == pytest.approx(LIVELY.entries["smile"].timing.preparation.shortest_s)


def test_words_that_are_not_spoken_are_no_anchor() -> None:
    words = spoken("well - no - then")
    words = tuple(replace(word, interval=None, phones=()) if word.text == "-" else word for word in words)
    behaviors = scheduled(movement("shake", 1), movement("gesture_negation", 1, 2), words=words)
    alone, beside = sorted(behaviors, key=lambda behavior: behavior.last)
    assert not alone.kept
    assert alone.reason == "none of its words is spoken"
    assert beside.sync.stroke_end == pytest.approx(2.0)


def test_a_line_without_times_has_no_schedule() -> None:
    words = tuple(Word(index, text) for index, text in enumerate(FIGURE_8.split()))
    assert schedule([offered(movement("shake", 2))], utterance(words), LIVELY, seed=0) == ()


def test_a_free_gesture_takes_the_characters_hand_or_the_one_in_use() -> None:
    lefty = replace(LIVELY, handedness=Hand.LEFT)
    assert [gesture.hand for gesture in scheduled(movement("gesture_me", 3), character=lefty)] == [Hand.LEFT]
    soon = scheduled(movement("gesture_point_left", 3), movement("gesture_me", 7))
    assert [gesture.hand for gesture in soon] == [Hand.LEFT, Hand.LEFT]
    late = scheduled(movement("gesture_point_left", 0), movement("gesture_me", 11))
    assert [gesture.hand for gesture in late] == [Hand.LEFT, Hand.RIGHT]


def test_the_gesture_rate_is_the_characters() -> None:
    """Functions ask by their priority alone for up to four times the usual."""
    words = spoken(" ".join(["word"] * 150), start_s=0.0)
    names = ("beat_gesture", "gesture_rhythm", "gesture_me", "gesture_you")
    candidates = [movement(names[number // 4 % 4], number, priority=number % 5) for number in range(2, 150, 4)]
    for rate in (0, 2, 6):
        gestures = scheduled(*candidates, words=words, character=replace(LIVELY, gestures_per_minute=rate))
        assert len([gesture for gesture in gestures if gesture.kept]) == ASKED_MORE[Level.MEDIUM] * rate


def test_an_overlay_changes_the_schedule() -> None:
    (lively,) = scheduled(movement("big_nod", 3))
    (reserved,) = scheduled(movement("big_nod", 3), character=CHARACTERS.named("reserved"))
    assert lively.amount is not None
    assert reserved.amount is not None
    assert reserved.amount < lively.amount


@pytest.mark.parametrize("seed", range(2))
def test_everything_possible_at_once_still_makes_a_schedule(seed: int) -> None:
    names = sorted(CHARACTERS.behavior_names)[seed::2]
    candidates = [
        replace(movement(name, number % 12, priority=number % 7), function=f"f{number}")
        for number, name in enumerate(names)
    ]
    behaviors = schedule(map(offered, candidates), utterance(spoken(FIGURE_8)), LIVELY, seed=seed)
    assert len([behavior for behavior in behaviors if behavior.function]) == len(candidates)
    assert len({behavior.id for behavior in behaviors}) == len(behaviors)
    kept = [behavior for behavior in behaviors if behavior.kept]
    assert {behavior.kind for behavior in kept} == set(Channel)
    for behavior in behaviors:
        times = [time_s for _, time_s in behavior.sync.in_order()]
        assert times == sorted(times)
        assert times[0] >= 0
        assert behavior.kept or behavior.reason
    for one, other in combinations(kept, 2):
        if one.kind is other.kind and compete(one, other):
            assert one.sync.end <= other.sync.start or other.sync.end <= one.sync.start


def test_what_the_body_does_by_itself_has_a_reason_and_no_rule() -> None:
    behaviors = schedule([], utterance(spoken(FIGURE_8)), LIVELY, seed=0)
    assert {behavior.kind for behavior in behaviors} >= {Channel.HEAD, Channel.GAZE, Channel.EYES}
    assert all(behavior.reason and behavior.rule is None and behavior.function is None for behavior in behaviors)

"""The choice over the whole line: the order of choosing, and the effects on the random draw."""

from dataclasses import replace

import pytest

from tests.support.characters import DEFAULT
from tests.support.operations import calls_of
from tests.support.words.by_hand import function, movement, spoken
from understudy.behavior.choice.attempts import ChoiceContext
from understudy.behavior.choice.choosing import EASILY_S, choose
from understudy.model import Alternative, Behavior, BehaviorCandidates, Channel, Hand, Moment, Movement

WORDS = spoken(" ".join(["word"] * 40))


def between(*alternatives: tuple[Movement, ...], lots: tuple[float, ...] = ()) -> BehaviorCandidates:
    """A offer that may be shown by any of the alternatives; without `lots` the first is the luckiest."""
    first = alternatives[0][0]
    named = replace(function("by_hand", "plain", first.first, first.last, first.priority), id=first.function or "")
    drawn = lots or tuple(1.0 + number / 100 for number in range(len(alternatives)))
    pairs = zip(alternatives, drawn, strict=True)
    return BehaviorCandidates(named, tuple(Alternative(movements, 1.0, lot) for movements, lot in pairs))


def settled(
    *candidates: BehaviorCandidates, most_gestures: int = 9, strokes_per_unit: int = 9
) -> tuple[list[Behavior], list[Behavior]]:
    """What is kept and what is lost, in order of time."""
    character = replace(DEFAULT, strokes_per_unit=strokes_per_unit)
    kept, lost = choose(candidates, ChoiceContext(WORDS, character, most_gestures, most_gestures))
    in_time = sorted((each.behavior for each in kept), key=lambda behavior: behavior.sync.start)
    return in_time, list(lost)


def lexemes(behaviors: list[Behavior]) -> list[str]:
    return [behavior.lexeme for behavior in behaviors]


def test_luck_decides_where_nothing_else_does() -> None:
    nod_or_tilt = ((movement("small_nod", 5),), (movement("tilt_left", 5),))
    for lots, lexeme in (((0.2, 1.0), "NOD"), ((1.0, 0.2), "TILT_LEFT")):
        kept, lost = settled(between(*nod_or_tilt, lots=lots))
        assert (lexemes(kept), lost) == ([lexeme], [])


def test_the_higher_priority_chooses_first() -> None:
    low, high = movement("gesture_me", 4, priority=2), movement("gesture_you", 5, priority=5)
    kept, lost = settled(between((low,)), between((high,)), most_gestures=1)
    assert (lexemes(kept), lexemes(lost)) == (["YOU"], ["ME"])
    assert lost[0].reason == "beyond the character's gesture rate, which gives this line 1"


def test_the_loser_of_a_channel_takes_another_and_tells_what_was_lost() -> None:
    winner = between((movement("big_nod", 5, priority=5),))
    loser = between((movement("shake", 5, priority=2),), (movement("small_brow_raise", 5, priority=2),))
    kept, lost = settled(winner, loser)
    assert sorted(lexemes(kept)) == ["NOD", "RAISE_BROWS"]
    assert lexemes(lost) == ["SHAKE"]
    assert lost[0].lost_to == kept[lexemes(kept).index("NOD")].id


def test_whoever_is_lost_to_is_there() -> None:
    """Parts of the luckiest alternative that compete with each other, and another alternative that is wholly made: the
    loser's winner is not made either, so neither is told."""
    both_of_the_head = (movement("big_nod", 5), movement("shake", 5))
    kept, lost = settled(between(both_of_the_head, (movement("gesture_me", 5),)))
    assert lexemes(kept) == ["ME"]
    assert {each.lost_to for each in lost} <= {each.id for each in (*kept, *lost)} | {None}


def test_part_of_an_alternative_may_do() -> None:
    winner = between((movement("big_nod", 5, priority=5),))
    kept, lost = settled(winner, between((movement("gesture_me", 5), movement("small_nod", 5))))
    assert sorted(lexemes(kept)) == ["ME", "NOD"]
    assert lexemes(lost) == ["NOD"]


def test_an_alternative_that_fits_is_preferred_to_one_that_must_be_shortened() -> None:
    winner = between((movement("gesture_you", 5, priority=5),))
    swept_or_pointed = between((movement("gesture_future", 7),), (movement("gesture_here", 7),))
    alone, _ = settled(swept_or_pointed)
    beside, _ = settled(winner, swept_or_pointed)
    assert lexemes(alone) == ["FUTURE"]
    assert "shortened" in (beside[-1].reason or "") or lexemes(beside)[-1] == "HERE"


def planned(offer: BehaviorCandidates) -> BehaviorCandidates:
    """The offer as if for a moment of the plan, not for a function."""
    assert offer.function is not None
    first, last = offer.function.first, offer.function.last
    moment = Moment(f"moment.{first}", Channel.GESTURE, first, last, first, ("self",), 0.5)
    alternatives = tuple(
        replace(each, movements=tuple(replace(one, moment=moment.id) for one in each.movements))
        for each in offer.alternatives
    )
    return BehaviorCandidates(None, alternatives, moment)


def test_the_same_gesture_within_five_seconds_is_less_suitable() -> None:
    again = between((movement("gesture_me", 8),), (movement("gesture_you", 8),))
    assert lexemes(settled(again)[0]) == ["ME"]
    assert lexemes(settled(between((movement("gesture_me", 4, priority=5),)), again)[0]) == ["ME", "YOU"]


@pytest.mark.parametrize(("word", "made"), [(6, False), (7, True)])
def test_a_planned_gesture_takes_the_other_hand_only_once_the_one_in_use_is_done(word: int, *, made: bool) -> None:
    asks = [planned(between((movement(f"gesture_point_{side}", at),))) for side, at in (("left", 4), ("right", word))]
    kept, lost = settled(*asks)
    if made:
        assert kept[0].sync.end <= (kept[1].sync.stroke or 0.0)
    else:
        assert lexemes(kept) == ["POINT_LEFT"]
        assert lost[0].reason == "the other hand is in use for POINT_LEFT"


def test_a_planned_gesture_keeps_the_hand_in_use_if_another_shows_the_same() -> None:
    left = planned(between((movement("gesture_point_left", 4),)))
    right_or_left = (movement("gesture_point_right", 8),), (movement("gesture_left", 8),)
    assert lexemes(settled(planned(between(*right_or_left)))[0]) == ["POINT_RIGHT"]
    assert lexemes(settled(left, planned(between(*right_or_left)))[0]) == ["POINT_LEFT", "LEFT"]


def test_what_only_the_hands_can_show_keeps_them() -> None:
    """Something more important has other means, and would leave neither hand the time."""
    both_or_nod = between((movement("gesture_question_both", 6, priority=5),), (movement("small_nod", 6, priority=5),))
    alone, _ = settled(both_or_nod)
    assert lexemes(alone) == ["QUESTION"]
    words = spoken(" ".join(["word"] * 20), word_s=0.12)
    only_by_hand = between((movement("gesture_me", 5, priority=2),))
    kept, _ = choose([both_or_nod, only_by_hand], ChoiceContext(words, DEFAULT, 9, 9))
    assert sorted(each.behavior.lexeme for each in kept) == ["ME", "NOD"]


def test_a_free_gesture_keeps_the_hand_in_use() -> None:
    left = movement("gesture_point_left", 6, priority=5)
    for word, hand in ((3, Hand.LEFT), (9, Hand.LEFT), (14, Hand.RIGHT)):
        kept, _ = settled(between((left,)), between((movement("gesture_me", word),)))
        assert {behavior.lexeme: behavior.hand for behavior in kept}["ME"] is hand


def test_a_gesture_unit_is_no_longer_than_the_characters() -> None:
    names = ("gesture_me", "gesture_you", "gesture_here")
    chain = [between((movement(name, 4 + 2 * number, priority=5),)) for number, name in enumerate(names)]
    last = between((movement("gesture_we", 10),), (movement("small_nod", 10),))
    assert lexemes(settled(*chain, last, strokes_per_unit=9)[0])[-1] == "WE"
    assert lexemes(settled(*chain, last, strokes_per_unit=1, most_gestures=3)[0])[-1] == "NOD"


def test_hands_that_may_move_are_moved() -> None:
    nod_or_me = between((movement("small_nod", 5),), (movement("gesture_me", 5),))
    assert lexemes(settled(nod_or_me)[0]) == ["ME"]
    assert lexemes(settled(nod_or_me, most_gestures=0)[0]) == ["NOD"]


def test_the_order_of_the_wishes_does_not_matter() -> None:
    candidates = [between((movement("gesture_me", word, priority=word % 3),)) for word in range(3, 30, 2)]
    assert settled(*candidates) == settled(*reversed(candidates))


def test_of_equals_a_gesture_that_has_its_time_goes_before_one_that_has_not() -> None:
    """The first word begins with the recording, so that its gesture could only begin with the hand raised."""
    words = spoken("No I never", start_s=0.0, word_s=0.3)
    first, second = between((movement("gesture_me", 0),)), between((movement("gesture_negation", 2),))
    for asked in ((first, second), (second, first)):
        kept, lost = choose(asked, ChoiceContext(words, DEFAULT, 1, 1))
        assert [each.behavior.lexeme for each in kept] == ["NEGATION"]
        assert lexemes(list(lost)) == ["ME"]
    kept, _ = choose([first], ChoiceContext(words, DEFAULT, 1, 1))
    assert [each.behavior.lexeme for each in kept] == ["ME"]


def test_any_gesture_has_its_time_a_second_after_the_beginning() -> None:
    timings = [entry.timing for entry in DEFAULT.entries.values() if entry.channel is Channel.GESTURE]
    assert max(timing.preparation.shortest_s + timing.stroke.shortest_s for timing in timings) < EASILY_S


def test_twice_as_many_offers_are_twice_the_work() -> None:
    def work(count: int) -> int:
        words = spoken(" ".join(["word"] * count))
        movements = ("small_nod", "gesture_me", "small_brow_raise", "shake", "gaze_aversion_downright")
        offers = [between(*(((movement(name, word),)) for name in movements)) for word in range(count)]
        return calls_of(lambda: choose(offers, ChoiceContext(words, DEFAULT, count, count)))

    half, whole = work(300), work(600)
    assert whole <= 2.1 * half

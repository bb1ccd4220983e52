"""Behaviours that would show nothing are dropped, whatever the line and the seed: many lines with random functions,
performed by the actual stages."""

import random
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import pytest

from tests.support.characters import CHARACTERS
from tests.support.words.by_hand import function, movement, offered, spoken, utterance
from understudy.behavior.choice.scheduling import schedule
from understudy.model import Behavior, BehaviorCandidates, Channel

DEFAULT = CHARACTERS.named("default")
WORDS = 90
CLASSES = ("emphasis", "negation", "affirmation", "initial_noun_phrase", "performance", "deixis")
NAMES = ("small_nod", "half_nod", "shake", "tilt_left", "short_blink", "gaze_listener", "gaze_left", "gaze_up")


def asked(names: tuple[tuple[str, int, str], ...]) -> tuple[BehaviorCandidates, ...]:
    """Functions of one movement each: the movement, its word, the class of the function."""
    return tuple(
        BehaviorCandidates(
            replace(function(class_name, "plain", word, word), id=f"function{word}"),
            offered(movement(name, word)).alternatives,
        )
        for name, word, class_name in names
    )


def performed(*names: tuple[str, int, str], seed: int = 0) -> tuple[Behavior, ...]:
    line = utterance(spoken(" ".join(f"word{seed}" for _ in range(WORDS))), phrase_ends=range(7, WORDS, 8))
    return schedule(asked(names), line, DEFAULT, seed=seed)


def by_chance(seed: int) -> tuple[Behavior, ...]:
    luck = random.Random(seed)
    drawn = ((luck.choice(NAMES), word, luck.choice(CLASSES)) for word in range(2, WORDS - 1, 2))
    return performed(*drawn, seed=seed)


def of_kind(behaviors: tuple[Behavior, ...], kind: Channel) -> Iterator[Behavior]:
    return (behavior for behavior in behaviors if behavior.kept and behavior.kind is kind)


@pytest.mark.parametrize("seed", range(20))
def test_no_two_blinks_come_within_six_tenths_of_a_second(seed: int) -> None:
    starts_s = [blink.sync.start for blink in of_kind(by_chance(seed), Channel.EYES)]
    assert min(later - earlier for earlier, later in pairwise(starts_s)) >= 0.6


def test_people_blink_15_to_25_times_a_minute_when_nothing_asks_for_more() -> None:
    blinks = [sum(1 for _ in of_kind(performed(seed=seed), Channel.EYES)) for seed in range(40)]
    assert 15 <= sum(blinks) / (40 * WORDS * 0.4 / 60) <= 25


@pytest.mark.parametrize("seed", range(20))
def test_who_is_looked_at_is_not_looked_at_again(seed: int) -> None:
    aside_until_s = 0.0
    for gaze in of_kind(by_chance(seed), Channel.GAZE):
        if gaze.direction is not None:
            aside_until_s = gaze.sync.end
        else:
            assert gaze.sync.start == 0 or gaze.sync.start <= aside_until_s + 0.1


def test_a_look_that_is_not_needed_tells_why_and_one_that_is_stays() -> None:
    (needless,) = (each for each in performed(("gaze_listener", 20, "deixis")) if each.function is not None)
    assert not needless.kept
    assert needless.reason == "the eyes are on the listener already"
    behaviors = performed(("gaze_left", 20, "deixis"), ("gaze_listener", 21, "interrogative"))
    assert [each.direction for each in behaviors if each.kept and each.function is not None] == ["LEFT", None]


@pytest.mark.parametrize("seed", range(20))
def test_no_idle_look_lasts_two_seconds_or_outlasts_the_turn(seed: int) -> None:
    idle = [gaze for gaze in of_kind(performed(seed=seed), Channel.GAZE) if gaze.direction is not None]
    assert idle
    assert max(gaze.sync.end - gaze.sync.start for gaze in idle) < 2
    last = spoken(" ".join(["word"] * WORDS))[-1].interval
    assert last is not None
    assert max(gaze.sync.end for gaze in idle) <= last.start_s


@pytest.mark.parametrize("seed", range(20))
def test_the_head_does_the_same_twice_running_only_for_another_reason(seed: int) -> None:
    behaviors = by_chance(seed)
    luck = random.Random(seed)
    drawn = {word: (luck.choice(NAMES), luck.choice(CLASSES))[1] for word in range(2, WORDS - 1, 2)}
    for earlier, later in pairwise(of_kind(behaviors, Channel.HEAD)):
        if earlier.lexeme == later.lexeme and later.sync.start - earlier.sync.start < 3:
            assert earlier.function != later.function
            assert _reason(drawn, earlier) != _reason(drawn, later)


def _reason(classes: dict[int, str], behavior: Behavior) -> str:
    if behavior.function is None:
        return "itself"
    return "weight" if classes[behavior.first] in ("emphasis", "initial_noun_phrase") else classes[behavior.first]


def test_of_two_nods_alike_the_more_important_is_made() -> None:
    behaviors = performed(("small_nod", 20, "emphasis"), ("half_nod", 24, "initial_noun_phrase"))
    nods = [each for each in behaviors if each.function is not None]
    assert [nod.kept for nod in nods].count(True) == 1
    (dropped,) = (nod for nod in nods if not nod.kept)
    assert dropped.lost_to == next(nod.id for nod in nods if nod.kept)
    assert "within 3 s" in (dropped.reason or "")


def test_a_nod_for_another_reason_is_made_again() -> None:
    behaviors = performed(("small_nod", 20, "emphasis"), ("half_nod", 24, "affirmation"))
    assert all(each.kept for each in behaviors if each.function is not None)

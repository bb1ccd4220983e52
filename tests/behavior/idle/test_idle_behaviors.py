from itertools import pairwise

import pytest

from tests.support.words.by_hand import spoken, utterance
from understudy.behavior.idle.idle_behaviors import BLINKS_PER_MINUTE, IdleBehavior, idle_behaviors
from understudy.model import Interval, Word

LONG = " ".join(["word"] * 600)


def blinks(words: tuple[Word, ...], phrase_ends: tuple[int, ...] = (), seed: int = 0) -> list[IdleBehavior]:
    behaviors = idle_behaviors(utterance(words, phrase_ends=phrase_ends), words, seed)
    return [behavior for behavior in behaviors if behavior.name == "blink"]


def test_a_line_begins_with_a_look_at_the_listener() -> None:
    words = spoken("Hello there.")
    first = next(iter(idle_behaviors(utterance(words), words, 0)))
    assert (first.name, first.at_s, first.word) == ("gaze_opening", 0.0, 0)


@pytest.mark.parametrize("seed", range(3))
def test_blinks_come_at_the_usual_rate(seed: int) -> None:
    minutes = 600 * 0.4 / 60
    assert len(blinks(spoken(LONG), seed=seed)) / minutes == pytest.approx(BLINKS_PER_MINUTE, rel=0.2)


def test_blinks_do_not_crowd() -> None:
    times = [blink.at_s for blink in blinks(spoken(LONG), tuple(range(0, 600, 4)))]
    assert min(later - earlier for earlier, later in pairwise(times)) >= 0.8


def test_blinks_prefer_phrase_ends() -> None:
    words = spoken(LONG)
    ends = tuple(range(3, 600, 4))
    at_ends = [blink for blink in blinks(words, ends) if blink.reason == "blinks as a phrase ends"]
    assert len(at_ends) > 0.8 * len(blinks(words, ends))
    ends_s = {words[word].interval.end_s for word in ends} | {words[-1].interval.end_s}  # type: ignore[union-attr]
    assert {blink.at_s for blink in at_ends} <= ends_s


def test_blinks_prefer_pauses() -> None:
    words = tuple(Word(index, "word", Interval(index * 1.2, index * 1.2 + 0.9)) for index in range(100))
    in_pauses = [blink for blink in blinks(words) if blink.reason == "blinks in a pause"]
    assert len(in_pauses) > 0.8 * len(blinks(words))


def test_seeds_blink_differently_and_the_same_seed_the_same() -> None:
    words = spoken(LONG)
    assert blinks(words, seed=1) == blinks(words, seed=1) != blinks(words, seed=2)


def test_breath_is_taken_in_long_pauses() -> None:
    times = ((0.0, 0.5), (0.6, 1.0), (1.5, 2.0))
    words = tuple(Word(index, "word", Interval(*each)) for index, each in enumerate(times))
    (breath,) = (each for each in idle_behaviors(utterance(words), words, 0) if each.name == "breath")
    assert (breath.at_s, breath.word) == (1.25, 1)


def test_breaths_are_not_taken_at_every_comma() -> None:
    words = tuple(Word(index, "word,", Interval(index * 0.9, index * 0.9 + 0.5)) for index in range(100))
    breaths = [each.at_s for each in idle_behaviors(utterance(words), words, 0) if each.name == "breath"]
    assert min(later - earlier for earlier, later in pairwise(breaths)) >= 4


def test_a_blink_asked_for_counts_as_one() -> None:
    words, asked_s = spoken(LONG), tuple(6.0 * place for place in range(40))
    line, counted = utterance(words, phrase_ends=range(0, 600, 4)), 0
    for seed in range(20):
        behaviors = idle_behaviors(line, words, seed, blinks_asked_s=asked_s)
        own = [each.at_s for each in behaviors if each.name == "blink"]
        assert min(abs(at_s - other_s) for at_s in own for other_s in asked_s) >= 0.8
        counted += len(own) + len(asked_s)
    assert 15 <= counted / (20 * 4) <= 25


def test_posture_shifts_where_a_sentence_begins_after_a_pause() -> None:
    texts = ("Yes.", "Well,", "I", "think.", "You", "know.", "Then.")
    starts_s = (0.0, 1.0, 9.0, 9.4, 10.0, 18.0, 19.0)
    words = tuple(
        Word(index, text, Interval(starts_s[index], starts_s[index] + 0.3)) for index, text in enumerate(texts)
    )
    behaviors = idle_behaviors(utterance(words), words, 0, rest_poses=("left", "right"))
    shifts = [(each.name, each.word) for each in behaviors if each.name in ("left", "right")]
    assert shifts == [("right", 1), ("left", 4), ("right", 6)]


def test_without_rest_poses_the_posture_stays() -> None:
    words = tuple(Word(index, "Yes.", Interval(index * 9.0, index * 9.0 + 1)) for index in range(4))
    assert {each.name for each in idle_behaviors(utterance(words), words, 0)} == {
        "gaze_opening",
        "breath",
        "blink",
    }

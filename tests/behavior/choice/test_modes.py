import random
from itertools import pairwise

import pytest

from tests.support.characters import DEFAULT
from tests.support.words.by_hand import function, movement, offered, spoken, utterance
from understudy.behavior.choice.scheduling import BEAT, schedule
from understudy.model import Behavior, BehaviorCandidates, Channel, Mode

LINE = utterance(spoken(" ".join(["word"] * 60), stressed=(8, 9, 30)))


def candidates() -> tuple[BehaviorCandidates, ...]:
    meant = [offered(movement(name, word)) for name, word in (("gesture_me", 4), ("gesture_high", 20), ("shake", 40))]
    stressed = [offered(movement("small_nod", word)) for word in (8, 9, 30)]
    emphases = [
        BehaviorCandidates(function("emphasis", "plain", word, word), each.alternatives)
        for word, each in zip((8, 9, 30), stressed, strict=True)
    ]
    return (*meant, *emphases)


def scheduled(mode: Mode, seed: int = 0) -> list[Behavior]:
    return [behavior for behavior in schedule(candidates(), LINE, DEFAULT, seed=seed, mode=mode) if behavior.kept]


def gestures(mode: Mode, seed: int = 0) -> list[Behavior]:
    return [behavior for behavior in scheduled(mode, seed) if behavior.kind is Channel.GESTURE]


@pytest.mark.parametrize("mode", [Mode.PROSODY, Mode.RANDOM])
def test_head_and_face_are_the_same_in_every_mode(mode: Mode) -> None:
    semantic, other = (
        [behavior for behavior in scheduled(each) if behavior.kind is not Channel.GESTURE]
        for each in (Mode.SEMANTIC, mode)
    )
    assert semantic == other


def test_meaning_gives_the_gestures_by_itself() -> None:
    assert [gesture.lexeme for gesture in gestures(Mode.SEMANTIC)] == ["ME", "HEIGHT_HIGH"]


def test_prosody_beats_on_stressed_words() -> None:
    beats = gestures(Mode.PROSODY)
    assert {beat.lexeme for beat in beats} == {DEFAULT.entries[BEAT].lexeme}
    assert [beat.first for beat in beats] == [8, 9, 30]
    assert all(beat.reason and beat.rule is None for beat in beats)


def test_chance_moves_where_meaning_does_but_shows_nothing() -> None:
    drawn = [gestures(Mode.RANDOM, seed) for seed in range(10)]
    assert all([each.first for each in line] == [4, 20] for line in drawn)
    assert all(each.function is None and each.reason for line in drawn for each in line)
    assert len({line[0].lexeme for line in drawn}) > 5


@pytest.mark.parametrize("seed", range(5))
def test_beats_are_spread_over_the_stressed_words_of_the_whole_line(seed: int) -> None:
    stressed = tuple(range(4, 116, 4))
    line = utterance(spoken(" ".join(["word"] * 120), stressed=stressed))
    offers = [
        BehaviorCandidates(function("emphasis", "plain", word, word), offered(movement("small_nod", word)).alternatives)
        for word in stressed
    ]
    random.Random(seed).shuffle(offers)
    behaviors = schedule(offers, line, DEFAULT, seed=seed, mode=Mode.PROSODY)
    beaten = [each.first for each in behaviors if each.kept and each.kind is Channel.GESTURE]
    assert len(beaten) < len(stressed), "the character makes fewer gestures than there are stressed words"
    assert 0.4 < sum(word < 60 for word in beaten) / len(beaten) < 0.6
    assert max(later - earlier for earlier, later in pairwise(beaten)) <= 3 * 120 / len(beaten)


def test_chance_draws_anew_for_lines_of_the_same_length() -> None:
    drawn = set()
    for text in ("ebb", "flow", "tide", "wave", "surf", "spray", "foam", "swell"):
        line = utterance(spoken(" ".join([text] * 60)))
        behaviors = schedule(candidates(), line, DEFAULT, seed=0, mode=Mode.RANDOM)
        drawn.add(next(each.lexeme for each in behaviors if each.kept and each.kind is Channel.GESTURE))
    assert len(drawn) >= 4


@pytest.mark.parametrize("mode", [Mode.PROSODY, Mode.RANDOM])
def test_what_a_mode_replaced_is_told(mode: Mode) -> None:
    behaviors = schedule(candidates(), LINE, DEFAULT, seed=0, mode=mode)
    replaced = [behavior.lexeme for behavior in behaviors if behavior.reason == f"not used in mode {mode}"]
    assert replaced == ["ME", "HEIGHT_HIGH"]
    assert len({behavior.id for behavior in behaviors}) == len(behaviors)

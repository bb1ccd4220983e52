from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest

from tests.support.by_hand import movement, spoken, utterance
from understudy.bml.choice.candidates import asked
from understudy.bml.choice.characters import Characters
from understudy.bml.choice.filling import Rest, fillers, free
from understudy.bml.choice.saccades import TALKING
from understudy.model import Behavior, Channel, Interval

DEFAULT = Characters.load(Path(__file__).resolve().parents[3] / "lexicon").named("default")
WORDS = spoken(" ".join(["word"] * 60), start_s=0.0)
NODS = tuple(
    asked(movement("big_nod", word), DEFAULT.entries["big_nod"], WORDS, f"nod{word}") for word in range(3, 60, 8)
)


def filled(stillness: float = 0.0) -> list[Behavior]:
    rest = Rest.of(utterance(WORDS), WORDS, replace(DEFAULT, stillness=stillness), "seed")
    return [each.behavior for each in fillers(NODS, rest, TALKING)]


def test_what_is_free_is_what_the_kept_leave() -> None:
    first = NODS[0].behavior.sync
    assert list(free(NODS[:1], Channel.HEAD, 24.2)) == [Interval(0.0, first.start), Interval(first.end, 24.2)]
    assert list(free(NODS, Channel.GAZE, 24.2)) == [Interval(0.0, 24.2)]


def test_the_head_is_hardly_ever_still() -> None:
    drifts = [behavior for behavior in filled() if behavior.kind is Channel.HEAD]
    moved_s = sum(each.sync.end - each.sync.start for each in [*drifts, *(nod.behavior for nod in NODS)])
    assert moved_s / 24.2 > 0.75
    assert all(drift.amount is not None and drift.amount <= 0.1 for drift in drifts)


def test_a_still_character_drifts_less() -> None:
    counts = [sum(each.kind is Channel.HEAD for each in filled(stillness)) for stillness in (0.0, 0.5, 1.0)]
    assert counts[0] > counts[1] > counts[2] == 0


@pytest.mark.parametrize("channel", [Channel.HEAD, Channel.GAZE])
def test_fillers_leave_the_rest_alone(channel: Channel) -> None:
    behaviors = [*filled(), *(nod.behavior for nod in NODS)]
    in_time = sorted((each.sync for each in behaviors if each.kind is channel), key=lambda sync: sync.start)
    assert all(one.end <= other.start for one, other in pairwise(in_time))
    assert all(each.reason and each.rule is None for each in filled())

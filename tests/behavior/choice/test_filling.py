from dataclasses import replace
from itertools import pairwise

import pytest

from tests.support.characters import DEFAULT
from tests.support.words.by_hand import movement, spoken, utterance
from understudy.behavior.choice.filling import GAZE_RANGE_DEGREES, LOOK_DEGREES, LOOK_S, FillingContext, fillers, free
from understudy.behavior.idle.idle_behaviors import TALKING
from understudy.behavior.reading.player import Ban
from understudy.behavior.timing.anchoring import asked
from understudy.model import Behavior, Channel, Interval
from understudy.model.tables import GLANCE, LOOK

WORDS = spoken(" ".join(["word"] * 60), start_s=0.0)
NODS = tuple(
    asked(movement("big_nod", word), DEFAULT.entries["big_nod"], WORDS, f"nod{word}") for word in range(3, 60, 8)
)


def filled(stillness: float = 0.0, seed: int = 0) -> list[Behavior]:
    rest = FillingContext.of(utterance(WORDS), WORDS, replace(DEFAULT, stillness=stillness), f"seed {seed}")
    return [each.behavior for each in fillers(NODS, rest, TALKING)]


def test_what_is_forbidden_does_not_come_by_itself() -> None:
    turns = Ban(0, 59, frozenset({"drift_turn_left", "drift_turn_right"}), "never")
    early = Ban(0, 29, frozenset({"saccade", "look_aside"}), "never")
    rest = FillingContext.of(utterance(WORDS), WORDS, DEFAULT, "seed 0", (turns, early))
    found = [each.behavior for each in fillers((), rest, TALKING)]
    assert {each.lexeme for each in found if each.kind is Channel.HEAD} == {"TILT_LEFT", "TILT_RIGHT", "RAISE", "LOWER"}
    aside = [each for each in found if each.kind is Channel.GAZE]
    assert aside
    assert {each.lexeme for each in aside} == {GLANCE}
    assert min(each.first for each in aside) > 29


def test_what_is_free_is_what_the_kept_leave() -> None:
    first = NODS[0].behavior.sync
    assert list(free(NODS[:1], Channel.HEAD, 24.2)) == [Interval(0.0, first.start), Interval(first.end, 24.2)]
    assert list(free(NODS, Channel.GAZE, 24.2)) == [Interval(0.0, 24.2)]


def takes_the_head(behavior: Behavior) -> bool:
    return behavior.kind is Channel.HEAD or behavior.lexeme == LOOK


def test_the_head_is_hardly_ever_still() -> None:
    moving = [each for each in (*filled(), *(nod.behavior for nod in NODS)) if takes_the_head(each)]
    assert sum(each.sync.end - each.sync.start for each in moving) / 24.2 > 0.75
    drifts = [behavior for behavior in filled() if behavior.kind is Channel.HEAD]
    assert all(drift.amount is not None and drift.amount <= 0.1 for drift in drifts)


def test_a_still_character_drifts_less() -> None:
    counts = [
        sum(each.kind is Channel.HEAD for seed in range(5) for each in filled(stillness, seed))
        for stillness in (0.0, 0.5, 1.0)
    ]
    assert counts[0] > counts[1] > counts[2] == 0


def test_the_head_goes_along_with_a_longer_look_aside_where_nothing_else_is_asked_of_it() -> None:
    behaviors = [each for seed in range(8) for each in filled(seed=seed)]
    looks = [each for each in behaviors if each.lexeme == LOOK]
    assert len(looks) > 8
    for look in looks:
        assert look.sync.end - look.sync.start >= LOOK_S - 0.001
        assert (look.amount or 0) * GAZE_RANGE_DEGREES >= LOOK_DEGREES - 1e-9
        assert all(nod.behavior.sync.end <= look.sync.start or nod.behavior.sync.start >= look.sync.end for nod in NODS)
    alone = [each for each in behaviors if each.kind is Channel.GAZE and each.lexeme != LOOK]
    assert {each.lexeme for each in alone} == {GLANCE}


@pytest.mark.parametrize("seed", range(5))
def test_nothing_competes_for_the_head(seed: int) -> None:
    taking = [each.sync for each in (*filled(seed=seed), *(nod.behavior for nod in NODS)) if takes_the_head(each)]
    in_time = sorted(taking, key=lambda sync: sync.start)
    assert all(one.end <= other.start for one, other in pairwise(in_time))


@pytest.mark.parametrize("channel", [Channel.HEAD, Channel.GAZE])
def test_fillers_leave_the_rest_alone(channel: Channel) -> None:
    behaviors = [*filled(), *(nod.behavior for nod in NODS)]
    in_time = sorted((each.sync for each in behaviors if each.kind is channel), key=lambda sync: sync.start)
    assert all(one.end <= other.start for one, other in pairwise(in_time))
    assert all(each.reason and each.rule is None for each in filled())

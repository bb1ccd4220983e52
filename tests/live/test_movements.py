"""Announcements made movements."""

from random import Random

import pytest

from understudy.live.events import LiveEvent
from understudy.live.models import LiveModels
from understudy.live.movements import LONGEST_HOLD_S, PREPARATION_S, Movements
from understudy.live.placing import Placer
from understudy.model import Behavior, Channel


@pytest.fixture
def movements(models: LiveModels) -> Movements:
    character = models.understudy.behavior.characters.named("default")
    return Movements(models.table, Placer(character, 0, Random(0)))


def announced(movements: Movements, part: str, state: str, now_s: float) -> list[Behavior]:
    return list(movements.moved(LiveEvent(part, state, now_s - 0.34, now_s), now_s))


def test_a_preparation_begins_a_beat_whose_stroke_comes_when_it_is_announced(movements: Movements) -> None:
    [begun] = announced(movements, "hands", "preparation", 1.0)
    assert begun.kind is Channel.GESTURE
    assert begun.sync.start == 1.0
    assert begun.sync.stroke_start == pytest.approx(1.0 + PREPARATION_S)
    [struck] = announced(movements, "hands", "stroke", 1.3)
    assert struck.id == begun.id
    assert struck.sync.stroke_start == pytest.approx(1.3)
    assert struck.sync.start == 1.0
    assert struck.sync.end - struck.sync.start < begun.sync.end - begun.sync.start


def test_one_gesture_at_a_time_and_not_too_many(movements: Movements) -> None:
    announced(movements, "hands", "stroke", 1.0)
    assert not announced(movements, "hands", "preparation", 1.2)
    [another] = announced(movements, "hands", "stroke", 4.0)
    assert another.sync.start == 4.0


def test_holds_and_retractions_change_when_it_relaxes(movements: Movements) -> None:
    [begun] = announced(movements, "hands", "stroke", 1.0)
    assert begun.sync.stroke_end is not None
    [held] = announced(movements, "hands", "hold", 1.4)
    assert held.sync.relax == pytest.approx(max(begun.sync.stroke_end, 1.4) + LONGEST_HOLD_S)
    [relaxed] = announced(movements, "hands", "retraction", 2.0)
    assert relaxed.sync.relax == 2.0
    assert not announced(movements, "hands", "rest", 2.5)


def test_heads_nod_and_brows_rise_until_they_are_neutral(movements: Movements) -> None:
    [nod] = announced(movements, "head", "nod", 1.0)
    assert (nod.kind, nod.lexeme) == (Channel.HEAD, "NOD")
    assert not announced(movements, "head", "still", 1.5)
    [raised] = announced(movements, "brows", "raised", 1.0)
    [lowered] = announced(movements, "brows", "neutral", 1.8)
    assert raised.id == lowered.id
    assert lowered.sync.relax == 1.8


def test_what_is_forgotten_does_not_change_any_more(movements: Movements) -> None:
    announced(movements, "hands", "stroke", 1.0)
    movements.forget()
    assert not announced(movements, "hands", "retraction", 1.5)

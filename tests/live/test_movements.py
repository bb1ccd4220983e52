"""Announcements made movements."""

from random import Random

import numpy as np
import pytest

from understudy.live.agenda import Placer
from understudy.live.models import LiveModels
from understudy.live.movements import HELD_AHEAD_S, LONGEST_HOLD_S, PREPARATION_S, LiveEvent, Movements
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
    assert (struck.sync.relax, struck.sync.end) == (begun.sync.relax, begun.sync.end)


def test_one_gesture_at_a_time_and_not_too_many(movements: Movements) -> None:
    announced(movements, "hands", "stroke", 1.0)
    assert not announced(movements, "hands", "preparation", 1.2)
    [another] = announced(movements, "hands", "stroke", 4.0)
    assert another.sync.start == 4.0


def told(movements: Movements, from_s: float, to_s: float) -> list[Behavior]:
    """What is told while a stretch passes in chunks."""
    return [each for now_s in np.arange(from_s, to_s, 0.04) for each in movements.passed(float(now_s))]


def test_a_hold_goes_on_little_by_little_and_never_comes_back(movements: Movements) -> None:
    [begun] = announced(movements, "hands", "stroke", 1.0)
    begun_relax_s = begun.sync.relax or 0.0
    assert not announced(movements, "hands", "hold", 1.2)
    while_held = told(movements, 1.2, 2.4)
    reliefs_s = [each.sync.relax or 0.0 for each in (begun, *while_held)]
    assert reliefs_s == sorted(reliefs_s)
    assert reliefs_s[-1] > begun_relax_s
    assert max(np.diff(reliefs_s)) <= HELD_AHEAD_S + 1e-6
    assert not announced(movements, "hands", "retraction", 2.4)
    assert not told(movements, 2.4, 6.0)


def test_nothing_is_held_for_longer_than_holds_are_or_after_the_voice(movements: Movements) -> None:
    announced(movements, "hands", "stroke", 1.0)
    announced(movements, "hands", "hold", 1.2)
    held = told(movements, 1.2, 9.0)
    assert held[-1].sync.relax == pytest.approx(1.2 + LONGEST_HOLD_S)
    announced(movements, "hands", "stroke", 10.0)
    announced(movements, "hands", "hold", 10.2)
    told(movements, 10.2, 10.8)
    movements.release()
    assert not told(movements, 10.8, 14.0)


def test_heads_nod_and_brows_rise_until_they_are_neutral(movements: Movements) -> None:
    [nod] = announced(movements, "head", "nod", 1.0)
    assert (nod.kind, nod.lexeme) == (Channel.HEAD, "NOD")
    assert not announced(movements, "head", "still", 1.5)
    [raised] = announced(movements, "brows", "raised", 1.0)
    later = told(movements, 1.0, 1.8)
    assert {each.id for each in later} == {raised.id}
    assert not announced(movements, "brows", "neutral", 1.8)
    assert not told(movements, 1.8, 4.0)
    assert (later[-1].sync.relax or 9.0) <= 1.8 + HELD_AHEAD_S


def test_what_is_forgotten_does_not_change_any_more(movements: Movements) -> None:
    announced(movements, "hands", "stroke", 1.0)
    movements.forget()
    assert not announced(movements, "hands", "retraction", 1.5)

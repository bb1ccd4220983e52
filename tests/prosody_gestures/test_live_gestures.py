"""Gestures while the voice goes on: the same as from its recording where nothing hurries, in time where it does."""

from itertools import pairwise

import numpy as np
import pytest

from tests.prosody_gestures.test_prosody import spoken
from tests.prosody_gestures.test_voice_model import SHIPPED
from understudy.model import FRAME_SHIFT_S
from understudy.prosody_gestures.live_decoder import Commitment
from understudy.prosody_gestures.live_gestures import (
    ANNOUNCED_S,
    COMMITMENT,
    DECIDED_S,
    EARLY,
    LEAD,
    Announcing,
    LiveGestures,
    LivePhase,
)
from understudy.prosody_gestures.semi_markov import FRAME_S
from understudy.prosody_gestures.trellis import EVERYTHING
from understudy.prosody_gestures.voice_model import VoiceModel

ENERGY_DB, F0_HZ = spoken(9.0, 4)
MODEL = VoiceModel.load(SHIPPED)


def heard(chunk: int, commitment: Commitment) -> tuple[list[LivePhase], float]:
    """All decided phases, and the longest that the end of one was waited for."""
    live, phases, latest_s = LiveGestures(MODEL, EVERYTHING, commitment), list[LivePhase](), 0.0
    decided_s = dict.fromkeys(("hands", "head", "brows"), 0.0)
    for first in range(0, len(F0_HZ), chunk):
        told = live.hear(ENERGY_DB[first : first + chunk], F0_HZ[first : first + chunk])
        found = [phase for phase in told if phase.decided]
        phases += found
        decided_s |= {phase.part: phase.end_s for phase in found}
        latest_s = max(latest_s, first * FRAME_SHIFT_S - min(decided_s.values()))
    return [*phases, *(phase for phase in live.finish() if phase.decided)], latest_s


@pytest.mark.parametrize("chunk", [1, 4, 7, 1000])
def test_unhurried_it_is_the_decode_of_the_recording(chunk: int) -> None:
    phases, _ = heard(chunk, Commitment(at_once=40))
    for part, path in MODEL.decode(ENERGY_DB, F0_HZ).items():
        begun = [phase for phase in phases if phase.part == part and phase.begins]
        assert [round(phase.start_s / FRAME_S) for phase in begun] == [segment.start for segment in path]


def test_every_moment_is_decided_once_and_in_time() -> None:
    phases, latest_s = heard(1, COMMITMENT)
    for part in ("hands", "head", "brows"):
        own = [phase for phase in phases if phase.part == part]
        assert all(one.end_s == other.start_s for one, other in pairwise(own))
        assert own[0].start_s == 0
        assert own[-1].end_s == pytest.approx(len(F0_HZ) * FRAME_SHIFT_S, abs=2 * FRAME_S)
    assert latest_s <= DECIDED_S + FRAME_S


def test_what_is_announced_comes_in_time_and_in_order_and_never_twice() -> None:
    live, last = LiveGestures(MODEL), dict[str, LivePhase]()
    for first in range(len(F0_HZ)):
        for phase in live.hear(ENERGY_DB[first : first + 1], F0_HZ[first : first + 1]):
            if phase.decided:
                continue
            before = last.get(phase.part)
            assert before is None or (before.state != phase.state and before.start_s < phase.start_s)
            assert first * FRAME_SHIFT_S - phase.start_s <= ANNOUNCED_S + FRAME_S
            last[phase.part] = phase
    assert last.keys() == {"hands", "head", "brows"}


@pytest.mark.parametrize(
    ("scores", "told"),
    [
        ([(0, -9, -9), (0, -EARLY - 0.1, -9)], ["rest"]),
        ([(0, -9, -9), (0, -9, -EARLY + 0.1)], ["rest", "preparation"]),
        ([(0, -9, -9), (0, -2, -9), (0, -EARLY - LEAD + 0.1, -9)], ["rest", "preparation"]),
        ([(0, -9, -9), (0, -2, -9), (0, -EARLY - LEAD - 0.1, -9)], ["rest", "preparation", "rest"]),
        ([(0, -9, -9), (0, -2, -9), (-9, -LEAD - 0.1, 0)], ["rest", "preparation", "stroke"]),
        ([(0, -9, -9), (-LEAD - 0.1, -9, 0), (-2, -2, 0)], ["rest", "stroke"]),
    ],
)
def test_a_gesture_is_prepared_before_it_is_likelier_than_none(
    scores: list[tuple[float, ...]], told: list[str]
) -> None:
    states = ("rest", "preparation", "stroke")
    announcing = Announcing(states)
    found = [announcing.changed(np.array(row)) for row in scores]
    assert [states[each] for each in found if each is not None] == told


def test_states_of_other_names_need_a_lead() -> None:
    announcing = Announcing(("phrase 0", "phrase 1"))
    assert [announcing.changed(np.array(row)) for row in ((0, -1), (-LEAD + 0.1, 0), (-LEAD - 0.1, 0))] == [0, None, 1]


def test_chunks_do_not_matter() -> None:
    assert heard(3, COMMITMENT)[0] == heard(50, COMMITMENT)[0]


def test_little_is_kept() -> None:
    live = LiveGestures(MODEL)
    for _ in range(20):
        live.hear(ENERGY_DB, F0_HZ)
        assert len(live._levels_db) < 20


def test_nothing_heard_is_nothing_done() -> None:
    live = LiveGestures(MODEL)
    assert live.hear(np.empty(0), np.empty(0)) == ()
    assert live.finish() == ()

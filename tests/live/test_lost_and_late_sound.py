"""Sound as networks and cheap clocks deliver it: uneven, late, lost, a little too fast or too slow."""

from itertools import cycle, pairwise

import numpy as np
import pytest

from tests.acoustic.pitch.test_streaming import LINE
from tests.live.streams import CHUNK, behaviors
from understudy.live.messages import LiveMessage, LiveOptions, MouthMessage
from understudy.live.models import LiveModels
from understudy.live.session import LiveSession
from understudy.model import SAMPLE_RATE_HZ, Channel, FloatArray

LOST_FROM, LOST = 50 * CHUNK, 10 * CHUNK
LOST_S = LOST / SAMPLE_RATE_HZ


def told(models: LiveModels, parts: list[FloatArray]) -> list[LiveMessage]:
    session = LiveSession(models, LiveOptions())
    return [each for part in parts for each in session.hear(part)]


def cut(samples: FloatArray, *sizes: int) -> list[FloatArray]:
    """In parts of these sizes, over and over."""
    edges, size = [0], cycle(sizes)
    while edges[-1] < len(samples):
        edges.append(edges[-1] + next(size))
    return [samples[first:last] for first, last in pairwise(edges)]


def mouths(found: list[LiveMessage]) -> list[tuple[float, str]]:
    return [(round(each.shape.at_s, 3), each.shape.viseme) for each in found if isinstance(each, MouthMessage)]


def gestures_s(found: list[LiveMessage]) -> list[float]:
    """Where gestures were begun."""
    return [
        each.sync.start
        for each in {each.id: each for each in behaviors(found) if each.kind is Channel.GESTURE}.values()
    ]


def test_uneven_chunks_and_bursts_change_nothing_but_when_it_is_told(models: LiveModels) -> None:
    even = told(models, cut(LINE, CHUNK))
    uneven = told(models, cut(LINE, 320, 1, 1599, 640, 77))
    assert mouths(uneven) == mouths(even)
    assert gestures_s(uneven) == pytest.approx(gestures_s(even), abs=0.1)


def test_lost_sound_that_is_told_as_silence_leaves_the_clock_right(models: LiveModels) -> None:
    """Long after the loss everything is where it would have been."""
    whole, session = mouths(told(models, cut(LINE, CHUNK))), LiveSession(models, LiveOptions())
    found = [each for part in cut(LINE[:LOST_FROM], CHUNK) for each in session.hear(part)]
    found += session.silence(LOST_S)
    found += [each for part in cut(LINE[LOST_FROM + LOST :], CHUNK) for each in session.hear(part)]
    later_s = LOST_FROM / SAMPLE_RATE_HZ + LOST_S + 0.5
    assert session.heard_s == pytest.approx(len(LINE) / SAMPLE_RATE_HZ)
    assert [each for each in mouths(found) if each[0] > later_s] == [each for each in whole if each[0] > later_s]


def test_lost_sound_of_which_nothing_is_told_closes_up(models: LiveModels) -> None:
    whole = mouths(told(models, cut(LINE, CHUNK)))
    found = mouths(told(models, cut(np.concatenate([LINE[:LOST_FROM], LINE[LOST_FROM + LOST :]]), CHUNK)))
    later_s = LOST_FROM / SAMPLE_RATE_HZ + LOST_S + 0.5
    expected = [(round(at_s - LOST_S, 3), viseme) for at_s, viseme in whole if at_s > later_s]
    assert [each for each in found if each[0] > later_s - LOST_S] == expected


@pytest.mark.parametrize("clock", [0.995, 0.9998, 1.0002, 1.005])
def test_a_clock_that_drifts_moves_what_is_told_by_as_much_and_no_more(models: LiveModels, clock: float) -> None:
    """A sender whose clock is fast takes more samples of the same sound than it says."""
    taken = np.arange(0, len(LINE) - 1, 1 / clock)
    drifted = np.interp(taken, np.arange(len(LINE)), LINE)
    even, found = gestures_s(told(models, cut(LINE, CHUNK))), gestures_s(told(models, cut(drifted, CHUNK)))
    assert found == pytest.approx([clock * each for each in even], abs=0.1)

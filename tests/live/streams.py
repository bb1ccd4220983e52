"""What tests of live speech share: a line as sound, and steps of a session."""

from collections.abc import Iterator

from tests.acoustic.pitch.test_streaming import LINE
from understudy.live.body import BodyFrame
from understudy.live.messages import BehaviorMessage, LiveMessage
from understudy.live.session import LiveSession
from understudy.model import Behavior, FloatArray

CHUNK = 640


def heard(session: LiveSession, samples: FloatArray = LINE, chunk: int = CHUNK) -> Iterator[tuple[float, LiveMessage]]:
    """What is told, each with how much had been heard by then."""
    for first in range(0, len(samples), chunk):
        for told in session.hear(samples[first : first + chunk]):
            yield session.heard_s, told


def behaviors(told: list[LiveMessage]) -> list[Behavior]:
    return [each.behavior for each in told if isinstance(each, BehaviorMessage)]


def frames(told: list[LiveMessage]) -> list[BodyFrame]:
    return [each for each in told if isinstance(each, BodyFrame)]

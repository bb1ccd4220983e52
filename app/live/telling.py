"""What a stream is asked to do, and what it tells."""

from dataclasses import dataclass

from ..model import DEFAULT_CHARACTER, SAMPLE_RATE_HZ, Behavior
from .body import BodyFrame
from .mouth import MouthShape


@dataclass(frozen=True, slots=True)
class LiveOptions:
    """Who performs and how; `frame_rate_hz` is 30 or 60, None for events alone."""

    sample_rate_hz: int = SAMPLE_RATE_HZ
    character: str = DEFAULT_CHARACTER
    seed: int = 0
    frame_rate_hz: int | None = None
    stillness: float = 0.0


@dataclass(frozen=True, slots=True)
class Moved:
    """A behaviour begins or, if told before, is `revised`; told when `heard_s` had been heard."""

    behavior: Behavior
    heard_s: float
    revised: bool


@dataclass(frozen=True, slots=True)
class Withdrawn:
    """A behaviour that was told is not done, or no more."""

    id: str
    heard_s: float


@dataclass(frozen=True, slots=True)
class Mouthed:
    """The mouth takes a shape."""

    shape: MouthShape
    heard_s: float


Told = Moved | Withdrawn | Mouthed | BodyFrame

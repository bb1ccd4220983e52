"""Options and output messages of a live stream. `heard_s` is the stream's time at which a message was sent."""

from dataclasses import dataclass

from ..model import DEFAULT_CHARACTER, SAMPLE_RATE_HZ, Behavior
from ..motion_models.playing import AnnouncedPhrase
from ..prosody_gestures.trellis import EVERYTHING, Search
from .body import BodyFrame
from .mouth import MouthShape


@dataclass(frozen=True, slots=True)
class LiveOptions:
    """Who performs and how; `frame_rate_hz` is 30 or 60, None for no frames; `search` is how a motion model's path is
    searched (RTS' m and n)."""

    sample_rate_hz: int = SAMPLE_RATE_HZ
    character: str = DEFAULT_CHARACTER
    seed: int = 0
    frame_rate_hz: int | None = None
    stillness: float = 0.0
    search: Search = EVERYTHING


@dataclass(frozen=True, slots=True)
class BehaviorMessage:
    """A behaviour that begins or, if it was sent before, is `revised`."""

    behavior: Behavior
    heard_s: float
    revised: bool


@dataclass(frozen=True, slots=True)
class WithdrawalMessage:
    """A behaviour that was sent is cancelled, or cut off."""

    id: str
    heard_s: float


@dataclass(frozen=True, slots=True)
class MouthMessage:
    """The mouth takes a shape."""

    shape: MouthShape
    heard_s: float


@dataclass(frozen=True, slots=True)
class PhraseMessage:
    """A phrase of a motion model begins."""

    phrase: AnnouncedPhrase
    heard_s: float


LiveMessage = BehaviorMessage | WithdrawalMessage | MouthMessage | PhraseMessage | BodyFrame

"""The input of a performance, a line with a director's notes (docs/directing.md), and the result of analysing it
before any movement is chosen."""

from dataclasses import dataclass, field

from ..errors import InputError
from .choice import Demand
from .functions import Fact, Function, GivenFunction
from .language import Utterance
from .performance import Notice
from .voice.affect import Affect
from .voice.signal import PLAINLY_SPOKEN, Audio, Contours, FloatArray, Speaking, VoiceQuality
from .voice.speech import Agitation, Filler, Word


@dataclass(frozen=True, slots=True)
class DirectedMoment:
    """A director's note: over words `first` to `last` the body should express something, with the hand's stroke on
    `stroke`.

    `gesture` are families of gestures (docs/directing.md), any of which would be right, the best first; `head`, `face`
    and `gaze` likewise. An empty tuple leaves the channel to the rules, ("still",) keeps it still. `importance` is 1
    (nice) to 3 (the line fails without it).
    """

    first: int
    last: int
    stroke: int
    importance: int = 2
    gesture: tuple[str, ...] = ()
    head: tuple[str, ...] = ()
    face: tuple[str, ...] = ()
    gaze: tuple[str, ...] = ()
    idea: str = ""


@dataclass(frozen=True, slots=True)
class Avoidance:
    """A director's note: over words `first` to `last` nothing of `what` (families of any channel; "hands" is every
    gesture, "any" everything)."""

    first: int
    last: int
    what: tuple[str, ...]
    why: str = ""


@dataclass(frozen=True, slots=True)
class Direction:
    """A director's notes on a line, with what is to come always or never (`demands`). If it is `complete`, the hands do
    only what the notes say."""

    moments: tuple[DirectedMoment, ...] = ()
    avoid: tuple[Avoidance, ...] = ()
    demands: tuple[Demand, ...] = ()
    complete: bool = False


@dataclass(frozen=True, slots=True)
class Timings:
    """Words timed elsewhere: the file's content and its format, "json", "textgrid" or "ctm"."""

    content: bytes
    format: str


@dataclass(frozen=True, slots=True)
class Line:
    """The input: the audio file's bytes, the transcript and, if the caller has them, word timings, communicative
    functions and a director's notes. Without audio the line is timed as `speaking` and the words have it."""

    audio: bytes | None
    text: str
    timings: Timings | None = None
    functions: tuple[GivenFunction, ...] = ()
    direction: Direction | None = None
    speaking: Speaking = PLAINLY_SPOKEN

    @property
    def recording(self) -> bytes:
        """The audio; raises InputError `field_missing` if there is none."""
        if self.audio is None:
            raise InputError("field_missing", "audio: this needs a recording of the line", field="audio")
        return self.audio


@dataclass(frozen=True, slots=True, eq=False)
class SignalAnalysis:
    """What is measured in the signal alone; `features` describe the voice in it
    (`understudy.acoustic.agitation.utterance_features`)."""

    audio: Audio
    contours: Contours
    quality: VoiceQuality
    features: FloatArray
    agitation: Agitation
    affect: Affect
    notices: tuple[Notice, ...]


@dataclass(frozen=True, slots=True)
class AlignedLine:
    """The words with their times, and the fillers heard between them; `duration_s` is the audio's."""

    words: tuple[Word, ...]
    duration_s: float
    notices: tuple[Notice, ...]
    fillers: tuple[Filler, ...] = ()


@dataclass(frozen=True, slots=True)
class Analysis:
    """The utterance and its communicative functions, before any movement is chosen; `heard` is what was measured in the
    recording, if there is one, `facts` are the facts that the rules derived."""

    utterance: Utterance
    functions: tuple[Function, ...]
    notices: tuple[Notice, ...] = ()
    heard: SignalAnalysis | None = field(default=None, repr=False, compare=False)
    facts: tuple[Fact, ...] = field(default=(), repr=False, compare=False)

"""The input and output of a worker: plain frozen values, small enough to send."""

from dataclasses import dataclass, field
from pathlib import Path

from ...errors import InputError
from ...model import Direction, Notice
from ...options import Options
from ..audio import AudioSource
from .formats import OutputFormat


@dataclass(frozen=True, slots=True)
class OutputTarget:
    """A file to be written: its format and its path relative to the output folder, with forward slashes."""

    form: OutputFormat
    path: str


@dataclass(frozen=True, slots=True)
class MotionForm:
    """How motion is made and written: frames per second, the rig whose joint names are used (None: the format's
    default), and whether bodies have mass."""

    frame_rate_hz: int = 60
    skeleton: str | None = None
    physics: bool = False


@dataclass(frozen=True, slots=True)
class LineJob:
    """A line to be performed.

    The worker writes to `folder`; if that is None it sends the files' content back.
    """

    id: str
    text: str
    audio: AudioSource
    options: Options
    targets: tuple[OutputTarget, ...]
    direction: Direction | None = None
    motion: MotionForm = MotionForm()
    folder: Path | None = None


@dataclass(frozen=True, slots=True)
class Measures:
    """The figures about a performance in a report. `functions` counts the kept ones by class, `gestures_dropped` those
    that lost conflicts, `unplayed` the movements that the realizer left out or made late; `pitch_spread_st` is the
    standard deviation of the voice's pitch, in semitones, None if it has none."""

    duration_s: float
    words: int
    agitation: str
    functions: dict[str, int]
    gestures: int
    gestures_dropped: int
    behaviors: int
    emphasised: int
    pitch_spread_st: float | None
    unplayed: int | None = None


@dataclass(frozen=True, slots=True)
class OutputFile:
    """A file that was written, or that is to be (`content`); `listener` is whose it is, empty for the speaker's."""

    form: OutputFormat
    path: str
    size: int
    listener: str = ""
    content: bytes | None = field(default=None, repr=False)


@dataclass(frozen=True, slots=True)
class Failure:
    """Why a line failed, with a code of docs/errors.md."""

    code: str
    message: str

    @classmethod
    def of(cls, error: InputError) -> "Failure":
        return cls(error.code, error.message)


@dataclass(frozen=True, slots=True)
class LineOutcome:
    """The result of a job: files and measures, or a failure; `seconds` is how long it took."""

    id: str
    seconds: float
    files: tuple[OutputFile, ...] = ()
    notices: tuple[Notice, ...] = ()
    measures: Measures | None = None
    failure: Failure | None = None


@dataclass(frozen=True, slots=True)
class ReferenceJob:
    """A speaker whose usual voice is to be learnt, with recordings."""

    speaker: str
    recordings: tuple[AudioSource, ...]

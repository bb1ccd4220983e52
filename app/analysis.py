"""The input of a performance, its options, and the result of analysing a line before any movement is chosen: values
only."""

from dataclasses import dataclass, field, fields, replace
from typing import Self

from .acoustic.agitation.speaker import SpeakerReference
from .behavior.characters.overlays import DEFAULT_CHARACTER
from .behavior.idle.stillness import check_stillness
from .behavior.speech.lead_in import LONGEST_LEAD_IN_S
from .bml.writing.writer import CORE_FORM, BmlForm
from .edits.values import NO_EDITS, Edits
from .errors import InputError
from .model import (
    Agitation,
    Audio,
    Contours,
    Direction,
    Filler,
    Function,
    GivenFunction,
    Level,
    Mode,
    Notice,
    Target,
    Utterance,
    Word,
)
from .model.targets import check_targets
from .profiles.profile import Profile
from .rules.knowledge import Fact


@dataclass(frozen=True, slots=True)
class Timings:
    """Words timed elsewhere: the file's content and its format, "json", "textgrid" or "ctm"."""

    content: bytes
    format: str


@dataclass(frozen=True, slots=True)
class Line:
    """The input: the audio file's bytes, the transcript and, if the caller has them, word timings, communicative
    functions and a director's notes."""

    audio: bytes
    text: str
    timings: Timings | None = None
    functions: tuple[GivenFunction, ...] = ()
    direction: Direction | None = None


@dataclass(frozen=True, slots=True)
class Options:
    """How the line is to be performed, and who listens.

    `agitation` overrides the measured level, `reference` describes how the speaker usually sounds. `lead_in_s` is how
    long before the recording the performance begins, `stillness` (0 to 1) reduces all movement, `targets` are the
    positions of things and listeners. `played_by` maps names of listeners that are not characters of ours to characters
    that play them. `profile` is a gesture profile, or the name of one in the lexicon; `listener_profiles` are
    those of listeners, by name. `contours` says whether f0 and
    energy are returned with the performance, `edits` are an author's changes to it (`with_edits`).

    Raises InputError `value_wrong` and `target_wrong`.
    """

    character: str = DEFAULT_CHARACTER
    agitation: Level | None = None
    seed: int = 0
    mode: Mode = Mode.SEMANTIC
    listeners: tuple[str, ...] = ()
    form: BmlForm = CORE_FORM
    reference: SpeakerReference | None = None
    lead_in_s: float = 0.0
    stillness: float = 0.0
    played_by: tuple[tuple[str, str], ...] = ()
    targets: tuple[Target, ...] = ()
    profile: Profile | str | None = None
    listener_profiles: tuple[tuple[str, Profile | str], ...] = ()
    contours: bool = False
    edits: Edits = NO_EDITS

    def __post_init__(self) -> None:
        if not 0 <= self.lead_in_s <= LONGEST_LEAD_IN_S:
            message = f"lead_in_s: {self.lead_in_s:g}; give 0 to {LONGEST_LEAD_IN_S:g} seconds"
            raise InputError("value_wrong", message, field="lead_in_s")
        if self.profile is not None and self.mode is not Mode.SEMANTIC:
            message = f"profile: a profile's gestures show what is meant; mode {self.mode} has others"
            raise InputError("value_wrong", message, field="profile")
        check_stillness(self.stillness)
        check_targets(self.targets)

    def with_edits(self, edits: Edits) -> Self:
        """The options with an author's edits, whose settings for the line override these."""
        settings = {part.name: getattr(edits.line, part.name) for part in fields(edits.line)}
        return replace(self, edits=edits, **{name: told for name, told in settings.items() if told is not None})


@dataclass(frozen=True, slots=True, eq=False)
class SignalAnalysis:
    """What is measured in the signal alone."""

    audio: Audio
    contours: Contours
    agitation: Agitation
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

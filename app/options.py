"""How a line is to be performed: the options of a performance, whichever door they come through."""

from dataclasses import dataclass, fields, replace
from typing import Literal, Self

from .errors import InputError
from .model import (
    DEFAULT_CHARACTER,
    AffectTrack,
    Level,
    Mode,
    Target,
)
from .model.edits import NO_EDITS, Edits
from .model.formats.bml_form import CORE_FORM, BmlForm
from .model.lead_in import LONGEST_LEAD_IN_S
from .model.targets import check_targets
from .model.voice.speaker_reference import SpeakerReference
from .profiles.profile import Profile


@dataclass(frozen=True, slots=True)
class Options:
    """How the line is to be performed, and who listens.

    `choice` says how movements are chosen, where the caller does: `terms`, the one choice, or the paper's `priority`.
    `agitation` overrides the measured level, `affect` the feeling that is heard, `reference` describes how the speaker
    usually sounds, `seed` is the take: 0 is the best one. `lead_in_s` is how
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
    choice: Literal["terms", "priority"] | None = None
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
    affect: AffectTrack | None = None

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


def check_stillness(stillness: float) -> None:
    """Raises InputError `value_wrong`."""
    if not 0 <= stillness <= 1:
        message = (
            f"stillness: {stillness:g}; give 0 (as lively as usual) to 1 (nothing moves but breath, blinks and lips)"
        )
        raise InputError("value_wrong", message, field="stillness")

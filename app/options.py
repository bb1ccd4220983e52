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
from .model.formats import CORE_FORM, BmlForm
from .model.targets import check_targets
from .model.voice.signal import SpeakerReference
from .option_table import PERFORMANCE
from .profiles.profile import Profile


@dataclass(frozen=True, slots=True)
class Options:
    """The options of `option_table.PERFORMANCE` as values, and what only some doors have.

    `played_by` maps names of listeners that are not characters of ours to characters that play them. `profile` is a
    gesture profile, or the name of one in the lexicon; `listener_profiles` are those of listeners, by name. `edits` are
    an author's changes to the performance (`with_edits`).

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
        PERFORMANCE["lead_in_s"].check(self.lead_in_s)
        if self.profile is not None and self.mode is not Mode.SEMANTIC:
            message = f"profile: mode {self.mode} uses none; leave it out, or take mode semantic"
            raise InputError("value_wrong", message, field="profile")
        PERFORMANCE["stillness"].check(self.stillness)
        check_targets(self.targets)

    def with_edits(self, edits: Edits) -> Self:
        """The options with an author's edits, whose settings for the line override these."""
        settings = {part.name: getattr(edits.line, part.name) for part in fields(edits.line)}
        return replace(self, edits=edits, **{name: told for name, told in settings.items() if told is not None})


AS_USUAL = Options()

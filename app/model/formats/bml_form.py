"""The form in which a schedule is written as BML: its dialect, how times are written, names of files and visemes."""

from dataclasses import dataclass
from enum import StrEnum
from pathlib import PurePath


class DialectName(StrEnum):
    """The supported dialects of BML."""

    BML = "bml"
    SMARTBODY = "smartbody"


class TimeForm(StrEnum):
    """How times are written: in seconds, or relative to the sync marks of the speech."""

    ABSOLUTE = "absolute"
    SYNC = "sync"


class VisemeNames(StrEnum):
    """The vocabulary of mouth shapes."""

    SMARTBODY = "smartbody"
    FACEFX = "facefx"


@dataclass(frozen=True, slots=True)
class BmlForm:
    """The output format. Absolute times are the default, because realizers do not know the word times of recorded
    speech. `audio_file` is the name of the recording's file, with which SmartBody finds it, and ASAP if `bmlt_audio`
    adds an element that plays it, which strict readers of the core refuse. `visemes` selects the names of visemes for
    SmartBody."""

    dialect: DialectName = DialectName.BML
    timing: TimeForm = TimeForm.ABSOLUTE
    audio_file: str | None = None
    bmlt_audio: bool = False
    visemes: VisemeNames = VisemeNames.SMARTBODY

    @property
    def audio_name(self) -> str | None:
        """The name of the recording's file without its extension."""
        return PurePath(self.audio_file).stem if self.audio_file else None


CORE_FORM = BmlForm()
"""BML 1.0 core with absolute times."""

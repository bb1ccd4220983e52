"""A script as lines, whatever file it was."""

from dataclasses import dataclass


class ScriptError(ValueError):
    """A file that is not a script; the message says why, and where."""


@dataclass(frozen=True, slots=True)
class ScriptLine:
    """A line: its id, its words, who speaks it, when it begins and ends in the script's one recording (seconds; None
    where each line has its own), and the file that the script names for it."""

    id: str
    text: str
    character: str = ""
    start_s: float | None = None
    end_s: float | None = None
    audio: str = ""

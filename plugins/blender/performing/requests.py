"""Requests to Understudy and its answers, whether a service or a local install does the work."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from ..motion.clip import Clip

Json = dict[str, Any]
Progress = Callable[[str], None]
"""Told the name of each stage as it begins."""
Cancellation = Callable[[], bool]
"""Tells whether the result is no longer wanted; asked between steps."""


class PerformingError(Exception):
    """The work failed; the message is for the user."""


class CancelledError(Exception):
    """The person who asked wants it no more."""


@dataclass(frozen=True, slots=True)
class Line:
    """A recording, its words, and how they are performed; `options` are those of `POST /perform`, `edits` the
    notes on it (docs/edits.md)."""

    audio: Path
    text: str
    options: Json = field(default_factory=dict)
    edits: Json | None = None


@dataclass(frozen=True, slots=True)
class Sheet:
    """BML to be played, its recording if there is one, and how; `options` are those of `POST /realize`."""

    bml: bytes
    audio: Path | None = None
    options: Json = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Remark:
    """A warning for the user, with its code (docs/errors.md)."""

    code: str
    message: str


@dataclass(frozen=True, slots=True)
class Performed:
    """A performance: its BML, all that is known of it (the JSON of `POST /perform`), what was warned of, and the BML
    of those who listen, by name."""

    bml: bytes
    trace: Json
    warnings: tuple[Remark, ...] = ()
    listeners: Mapping[str, bytes] = field(default_factory=dict)


class Connection(Protocol):
    """Whoever performs. Both methods raise PerformingError and CancelledError."""

    def perform(self, line: Line, progress: Progress, cancelled: Cancellation) -> Performed:
        """A line to BML."""

    def realize(self, sheet: Sheet, progress: Progress, cancelled: Cancellation) -> Clip:
        """BML to motion."""

    def mannequin(self, character: str) -> bytes:
        """A character's own body as GLB."""

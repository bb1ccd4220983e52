"""A whole performance, notices about it, and the callback by which work reports its progress."""

from collections.abc import Callable
from dataclasses import dataclass

from .choice import Moment
from .functions import Function
from .language import Utterance
from .schedule import Behavior, Listening, Target, Viseme

Progress = Callable[[str], None]
"""Called with the name of each stage as it begins."""


def no_progress(_stage: str) -> None:
    """Ignores progress."""


@dataclass(frozen=True, slots=True)
class Notice:
    """Something that was degraded, dropped or guessed; `code` is stable, `message` is for people."""

    code: str
    message: str


@dataclass(frozen=True, slots=True)
class Performance:
    """The whole performance of a line: its analysis, the behaviours, and every reason."""

    utterance: Utterance
    functions: tuple[Function, ...]
    behaviors: tuple[Behavior, ...]
    character: str
    seed: int
    notices: tuple[Notice, ...] = ()
    visemes: tuple[Viseme, ...] = ()
    listeners: tuple[Listening, ...] = ()
    moments: tuple[Moment, ...] = ()
    stillness: float = 0.0
    targets: tuple[Target, ...] = ()

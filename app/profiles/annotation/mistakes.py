"""Mistakes in annotations. The mistakes of all files are reported at once, each with its file, time and track."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from ...errors import InputError


@dataclass(frozen=True, slots=True)
class AnnotationMistake:
    """A mistake in an annotation; `time_s` is None if it concerns a whole track, `track` is empty if a whole file."""

    path: Path
    message: str
    track: str = ""
    time_s: float | None = None

    def __str__(self) -> str:
        time = "" if self.time_s is None else f" at {self.time_s:.3f} s"
        track = f" {self.track}{time}:" if self.track else ""
        return f"{self.path}:{track} {self.message}"


class AnnotationError(InputError):
    """Mistakes in annotation files; `mistakes` contains all of them."""

    def __init__(self, mistakes: Iterable[AnnotationMistake]) -> None:
        self.mistakes = tuple(mistakes)
        super().__init__("annotation_wrong", "\n".join(map(str, self.mistakes)), field="annotation")

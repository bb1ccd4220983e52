"""The behaviours that a voice alone triggers, read from `lexicon/live.yaml`; all mistakes in it are reported at once,
with their places."""

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Self

from pydantic import Field

from ..errors import AuthoringError, Mistake, did_you_mean
from ..yaml_files import Entry, Source

FILE = "live.yaml"

_Names = Annotated[tuple[str, ...], Field(min_length=1, strict=False)]


@dataclass(frozen=True, slots=True)
class LiveTable:
    """Alternatives by occasion, names of behaviours; one is drawn each time."""

    hands: tuple[str, ...]
    nod: tuple[str, ...]
    shake: tuple[str, ...]
    tilt: tuple[str, ...]
    turn: tuple[str, ...]
    raised: tuple[str, ...]
    lowered: tuple[str, ...]
    look_away: tuple[str, ...]
    look_at: tuple[str, ...]
    blink: tuple[str, ...]
    listener_nod: tuple[str, ...]

    @classmethod
    def load(cls, path: Path, behavior_names: Collection[str]) -> Self:
        """Raises AuthoringError with every mistake, behaviours that are not in the table among them."""
        source = Source(path)
        read = source.validated(_LiveFile).model_dump()
        if mistakes := tuple(_unknown(source, read, behavior_names)):
            raise AuthoringError(mistakes)
        return cls(**read)


class _LiveFile(Entry):
    hands: _Names
    nod: _Names
    shake: _Names
    tilt: _Names
    turn: _Names
    raised: _Names
    lowered: _Names
    look_away: _Names
    look_at: _Names
    blink: _Names
    listener_nod: _Names


def _unknown(source: Source, read: dict[str, tuple[str, ...]], known: Collection[str]) -> Iterator[Mistake]:
    for key, names in read.items():
        for place, name in enumerate(names):
            if name not in known:
                yield source.mistake((key, place), f"no behaviour is called {name!r}{did_you_mean(name, known)}")

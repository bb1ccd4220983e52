"""Reads `cast.yaml`: which of our characters performs each of the script's. docs/batch.md has an example."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from pydantic import Field, RootModel

from ...errors import AuthoringError, InputError, Mistake, did_you_mean
from ...model import AffectTrack, Level, Target
from ...model.targets import targets_of
from ...model.voice.signal import SpeakerReference
from ...models import usable_profile
from ...profiles.profile import Profile
from ...schemas.affect import affect_track, read_affect_track
from ...schemas.options import Positions
from ...schemas.references import read_reference
from ...yaml_files import Entry, Source

EVERYONE_ELSE = "*"
LEARN, NONE = "learn", "none"


class _CastEntry(Entry):
    """An entry of the file."""

    character: str | None = None
    seed: int | None = None
    agitation: Level | None = None
    affect: str | tuple[float, float, float] | None = None
    stillness: float | None = Field(default=None, ge=0, le=1)
    reference: str = LEARN
    listener: list[str] | None = None
    profile: str | None = None
    target: Positions = Field(default_factory=dict)


class _Cast(RootModel[dict[str, _CastEntry]]):
    """The file: parts by the names of the script's characters."""


@dataclass(frozen=True, slots=True)
class CastPart:
    """How a character of the script is performed; None leaves it to the command's options.

    `reference` is the speaker's usual voice if a file is given, `is_learnt` says whether it is learnt from the batch.
    `listeners` are the characters of the script addressed, None those of the scene; `targets` are the positions of
    things, `profile` is a gesture profile.
    """

    character: str | None = None
    seed: int | None = None
    agitation: Level | None = None
    affect: AffectTrack | None = None
    stillness: float | None = None
    reference: SpeakerReference | None = None
    is_learnt: bool = True
    listeners: tuple[str, ...] | None = None
    targets: tuple[Target, ...] = ()
    profile: Profile | str | None = None


@dataclass(frozen=True, slots=True)
class Cast:
    """The parts by folded name; `names` are spelt as in the file."""

    parts: Mapping[str, CastPart]
    names: tuple[str, ...] = ()

    def part(self, name: str) -> CastPart:
        """The part of a script's character."""
        return self.parts.get(folded(name)) or self.parts.get(EVERYONE_ELSE) or CastPart()


NOBODY_CAST = Cast(MappingProxyType({}))


def read_cast(path: Path, characters: frozenset[str]) -> Cast:
    """The cast in a file; `characters` are ours. Raises AuthoringError with every mistake and its place."""
    source = Source(path)
    told = source.validated(_Cast).root
    mistakes = [*_doubles(source, told)]
    parts: dict[str, CastPart] = {}
    for name, part in told.items():
        if part.character is not None and part.character not in characters:
            hint = did_you_mean(part.character, characters)
            mistakes.append(source.mistake((name, "character"), f"there is no character {part.character!r}{hint}"))
        try:
            parts[folded(name)] = _part(part, path.parent)
        except InputError as error:
            keys = {"target_wrong": "target", "unknown_profile": "profile", "affect_wrong": "affect"}
            key = keys.get(error.code, "reference")
            mistakes.append(source.mistake((name, key), error.message))
        except AuthoringError as error:
            mistakes += error.mistakes
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return Cast(MappingProxyType(parts), tuple(told))


def folded(name: str) -> str:
    """A name of the script in lower case and with single spaces, for comparison."""
    return " ".join(name.split()).casefold()


def _part(part: _CastEntry, folder: Path) -> CastPart:
    """Raises InputError for a reference that cannot be read, `target_wrong`, `unknown_profile`; AuthoringError for a
    profile with mistakes."""
    reference = None
    if part.reference not in {LEARN, NONE}:
        try:
            reference = read_reference((folder / part.reference).read_bytes(), part.reference)
        except OSError as error:
            message = f"{part.reference}: cannot be read: {error.strerror}; give learn, none, or a REF.json"
            raise InputError("file_unreadable", message, field="cast") from None
    return CastPart(
        part.character,
        part.seed,
        part.agitation,
        None if part.affect is None else _affect(part.affect, folder),
        part.stillness,
        reference,
        part.reference == LEARN,
        None if part.listener is None else tuple(part.listener),
        targets_of(part.target),
        None if part.profile is None else usable_profile(part.profile, folder),
    )


def _affect(told: str | tuple[float, float, float], folder: Path) -> AffectTrack:
    """A tone, three numbers, or the name of a track beside the cast; raises InputError `affect_wrong`."""
    if not isinstance(told, str) or not told.casefold().endswith(".csv"):
        return affect_track(told)
    try:
        return read_affect_track((folder / told).read_bytes(), told)
    except OSError as error:
        message = f"{told}: cannot be read: {error.strerror}"
        raise InputError("affect_wrong", message, field="cast") from None


def _doubles(source: Source, told: Mapping[str, _CastEntry]) -> Iterator[Mistake]:
    seen: set[str] = set()
    for name in told:
        if folded(name) in seen:
            yield source.mistake((name,), f"{name!r} stands here a second time; capitals do not count")
        seen.add(folded(name))

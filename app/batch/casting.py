"""The cast (`cast.yaml`: which of our characters performs each of the script's; docs/batch.md has an example) and with
it the options of each line: those of the command, overridden by cast, scene and finally the line's own row.

The listeners of a line are those who speak next to it in its scene, under the names of their characters.
"""

import re
import unicodedata
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

from pydantic import Field, RootModel

from ..errors import AuthoringError, InputError, Mistake, did_you_mean
from ..files import read_regular, require_regular
from ..model import AffectTrack, Level, Target
from ..model.targets import targets_of
from ..model.voice.signal import SpeakerReference
from ..models import usable_profile
from ..option_table import MOST_LISTENERS
from ..options import Options
from ..profiles.profile import Profile
from ..schemas.affect import affect_track, read_affect_track
from ..schemas.options import Positions
from ..schemas.references import read_reference
from ..yaml_files import Entry, Source
from .model import ScriptLine, Take

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
    """The cast in a file; `characters` are ours. Raises AuthoringError with every mistake and its place, InputError
    `file_unreadable`."""
    try:
        require_regular(path)
    except OSError as error:
        raise InputError("file_unreadable", f"{path}: cannot be read: {error.strerror}", field="cast") from None
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
            reference = read_reference(read_regular(folder / part.reference), part.reference)
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
        return read_affect_track(read_regular(folder / told), told)
    except OSError as error:
        message = f"{told}: cannot be read: {error.strerror}"
        raise InputError("affect_wrong", message, field="cast") from None


def _doubles(source: Source, told: Mapping[str, _CastEntry]) -> Iterator[Mistake]:
    seen: set[str] = set()
    for name in told:
        if folded(name) in seen:
            yield source.mistake((name,), f"{name!r} is listed twice; case is ignored")
        seen.add(folded(name))


@dataclass(frozen=True, slots=True)
class CastingPlan:
    """Decides each line's options. `characters` are ours; `partners` are the neighbouring speakers in the scene, by
    the id of the line."""

    cast: Cast
    common: Options
    characters: Collection[str]
    partners: Mapping[str, tuple[str, ...]]

    @classmethod
    def of(
        cls,
        cast: Cast,
        common: Options,
        characters: Collection[str],
        lines: Sequence[ScriptLine],
        *,
        has_partners: bool,
    ) -> "CastingPlan":
        """With `has_partners`, those who speak next to a line become its listeners."""
        return cls(cast, common, characters, neighbours(lines) if has_partners else {})

    def options(self, take: Take) -> Options:
        """How a line is performed, except for the speaker's usual voice if that is learnt."""
        line, part = take.line, self.cast.part(take.line.character)
        listeners = self._listeners(line, part)
        return replace(
            self.common,
            character=self._performer(line.character),
            agitation=line.agitation or part.agitation or self.common.agitation,
            affect=line.affect or part.affect or self.common.affect,
            seed=next(seed for seed in (line.seed, part.seed, self.common.seed) if seed is not None),
            stillness=self.common.stillness if part.stillness is None else part.stillness,
            reference=part.reference,
            profile=part.profile or self.common.profile,
            listeners=tuple(listener_name(name) for name in listeners),
            played_by=tuple((listener_name(name), self._performer(name)) for name in listeners),
            listener_profiles=tuple(self._listener_profiles(listeners)),
            targets=_together(self.common.targets, part.targets, line.targets),
            form=replace(self.common.form, audio_file=take.recording.path.name),
        )

    def is_learnt(self, name: str) -> bool:
        """Whether the usual voice of a script's character is to be learnt."""
        return bool(name) and self.cast.part(name).is_learnt

    def remarks(self, lines: Sequence[ScriptLine]) -> tuple[str, ...]:
        """Remarks about names in the cast that the script does not have."""
        known = {folded(line.character): line.character for line in lines}
        unknown = [name for name in self.cast.names if name != "*" and folded(name) not in known]
        messages = [f"nobody in the script is called {name!r}{did_you_mean(name, known.values())}" for name in unknown]
        return tuple(messages)

    def _performer(self, name: str) -> str:
        """The character named in the cast, else ours of the same name, else the command's."""
        told = self.cast.part(name).character
        ours = folded(name)
        return told or (ours if ours in self.characters else self.common.character)

    def _listener_profiles(self, listeners: Iterable[str]) -> Iterator[tuple[str, Profile | str]]:
        for name in listeners:
            profile = self.cast.part(name).profile
            if profile is not None:
                yield listener_name(name), profile

    def _listeners(self, line: ScriptLine, part: CastPart) -> tuple[str, ...]:
        """The listeners without duplicates: those of the line, else of the cast, else of the scene."""
        told = next(
            names for names in (line.listeners, part.listeners, self.partners.get(line.id, ())) if names is not None
        )
        by_name = {listener_name(name).casefold(): name for name in told}
        by_name.pop(listener_name(line.character).casefold(), None)
        return tuple(by_name.values())[:MOST_LISTENERS]


def _together(*placed: Sequence[Target]) -> tuple[Target, ...]:
    """The targets of all sources; for each name the last source wins."""
    return tuple({target.name: target for targets in placed for target in targets}.values())


_NO_NAME = re.compile(r"[\W_]+")
_LONGEST = 64


def neighbours(lines: Sequence[ScriptLine]) -> dict[str, tuple[str, ...]]:
    """For each line in a scene, by its id, the nearest other speakers before and after it, the one before first."""
    partners: dict[str, tuple[str, ...]] = {}
    for scene in _scenes(lines):
        for place, line in enumerate(scene):
            found = [_nearest(line, reversed(scene[:place])), _nearest(line, iter(scene[place + 1 :]))]
            partners[line.id] = tuple(dict.fromkeys(name for name in found if name))
    return partners


def listener_name(name: str) -> str:
    """A name of the script as a valid listener's name, for BML and file names: with its letters, whatever they are,
    and underscores between words (Zoë, Jörg_Müller)."""
    plain = _NO_NAME.sub("_", unicodedata.normalize("NFC", name)).strip("_")[: _LONGEST - 2] or "listener"
    return plain if plain[0].isalpha() else f"L_{plain}"


def _scenes(lines: Sequence[ScriptLine]) -> Iterator[list[ScriptLine]]:
    """The lines of each scene; lines without a scene or a character have no partners."""
    by_scene: dict[str, list[ScriptLine]] = {}
    for line in lines:
        if line.scene and line.character:
            by_scene.setdefault(line.scene, []).append(line)
    yield from by_scene.values()


def _nearest(line: ScriptLine, others: Iterator[ScriptLine]) -> str:
    return next((other.character for other in others if folded(other.character) != folded(line.character)), "")

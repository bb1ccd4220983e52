"""Loads which behaviours show what a director asks for: families of gestures, kinds of head movement, kinds of face.

Read from `lexicon/acting/families.yaml`. A family ("self", "size_big", "list_item") is what an audience reads in a
gesture, whatever its form; `shows` is the converse, what a gesture lexeme may be read as, the likeliest first. A
behaviour may be listed under a gesture family only if its lexeme shows that family. All mistakes in the file are
reported at once, with their places.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Protocol

from pydantic import BeforeValidator, Field

from ...authored_folders import tables_of
from ...errors import AuthoringError, Mistake, did_you_mean
from ...model import Channel, Level
from ...yaml_files import Entry, Source

OTHER_FAMILY = 0.5
"""The worth of a lexeme for a family that it shows, but not first: a right choice that is not the first is worth half
to a director."""

POINT = "point"
POINTINGS = ("point_there", "point_here", "point_up")
"""Families that are one family in a plan: the scene and the words' lemmas decide where a thing is, not the reading."""


def merged(family: str) -> str:
    """The family as named in plans."""
    return POINT if family in POINTINGS else family


class Playable(Protocol):
    """What this stage needs to know of an entry of the behaviour table."""

    @property
    def channel(self) -> Channel: ...
    @property
    def lexeme(self) -> str: ...


@dataclass(frozen=True, slots=True)
class FamilyBehavior:
    """A behaviour that shows a family, `name` in the table.

    With `lemmas` it is for moments that have one of them, and is preferred to those without; `levels` are the levels of
    agitation for which it is suitable.
    """

    name: str
    lemmas: frozenset[str] = frozenset()
    levels: frozenset[Level] = frozenset(Level)

    def fits(self, lemmas: Collection[str], level: Level) -> bool:
        """Whether it suits a moment with these lemmas, said at this level of agitation."""
        return level in self.levels and (not self.lemmas or not self.lemmas.isdisjoint(lemmas))


@dataclass(frozen=True, slots=True)
class Families:
    """Behaviours by family of gesture, kind of head movement and kind of face, the best first.

    `shows` gives the families that a gesture lexeme may be read as, the likeliest first.
    """

    gesture: Mapping[str, tuple[FamilyBehavior, ...]]
    head: Mapping[str, tuple[FamilyBehavior, ...]]
    face: Mapping[str, tuple[FamilyBehavior, ...]]
    gaze: Mapping[str, tuple[FamilyBehavior, ...]]
    shows: Mapping[str, tuple[str, ...]]

    @property
    def gesture_names(self) -> frozenset[str]:
        """The behaviours of all families of gestures."""
        return frozenset(each.name for listed in self.gesture.values() for each in listed)

    @property
    def kinds(self) -> Mapping[str, tuple[FamilyBehavior, ...]]:
        """The kinds of movement of head, face and eyes; some are called as a family of gestures is."""
        return MappingProxyType({**self.head, **self.face, **self.gaze})


def family_rule(channel: str, family: str) -> str:
    """The name given in place of a rule in the reason for a behaviour that shows a planned family and that no rule
    offered."""
    return f"{channel}_family_{family}"


def fitting(behaviors: Collection[FamilyBehavior], lemmas: Collection[str], level: Level) -> tuple[str, ...]:
    """The names of the behaviours that suit a moment: those that one of its lemmas asks for, then the general ones."""
    fit = [behavior for behavior in behaviors if behavior.fits(lemmas, level)]
    return tuple(behavior.name for behavior in sorted(fit, key=lambda behavior: not behavior.lemmas))


def load_families(path: Path, behaviors: Mapping[str, Playable]) -> Families:
    """The families in `path`, with what authors add to them (`tables_of`), shown by entries of the table `behaviors`;
    raises AuthoringError with every mistake."""
    source, *added = map(Source, tables_of(path))
    written = [(source, source.validated(_FamiliesFile)), *((each, each.validated(_FamilyAddition)) for each in added)]
    whole = _joined([file for _source, file in written])
    mistakes = [mistake for each, file in written for mistake in _mistakes(each, file, whole, behaviors)]
    mistakes += [written[-1][0].mistake(("shows",), message) for message in _unlisted(whole, behaviors)]
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return Families(
        gesture=_behaviors(whole.gesture),
        head=_behaviors(whole.head),
        face=_behaviors(whole.face),
        gaze=_behaviors(whole.gaze),
        shows=MappingProxyType(dict(whole.shows)),
    )


def _named(value: object) -> object:
    """Lets a behaviour without conditions be written as its name alone."""
    return {"behavior": value} if isinstance(value, str) else value


_Name = Annotated[str, Field(pattern=r"^[a-z][a-z_]*$")]
_Lexeme = Annotated[str, Field(pattern=r"^[A-Z][A-Z0-9_]*$")]
_Lemma = Annotated[str, Field(pattern=r"^[^A-Z\s]+$")]


class _FamilyLine(Entry):
    behavior: str
    lemmas: Annotated[tuple[_Lemma, ...], Field(min_length=1)] | None = None
    agitation: Annotated[tuple[Level, ...], Field(min_length=1)] | None = None


_Lines = tuple[Annotated[_FamilyLine, BeforeValidator(_named)], ...]
"""Empty for a family that is shown by not moving, such as `still`."""


class _FamiliesFile(Entry):
    gesture: dict[_Name, _Lines]
    head: dict[_Name, _Lines]
    face: dict[_Name, _Lines]
    gaze: dict[_Name, _Lines] = Field(default_factory=dict)
    shows: dict[_Lexeme, Annotated[tuple[_Name, ...], Field(min_length=1)]]


class _FamilyAddition(_FamiliesFile):
    """A file of an author's: further behaviours of families, which come before the others, and further lexemes."""

    gesture: dict[_Name, _Lines] = Field(default_factory=dict)
    head: dict[_Name, _Lines] = Field(default_factory=dict)
    face: dict[_Name, _Lines] = Field(default_factory=dict)
    shows: dict[_Lexeme, Annotated[tuple[_Name, ...], Field(min_length=1)]] = Field(default_factory=dict)


def _joined(files: Sequence[_FamiliesFile]) -> _FamiliesFile:
    """All files as one, the behaviours of later ones first."""
    parts = {
        part: {
            family: tuple(line for file in reversed(files) for line in getattr(file, part).get(family, ()))
            for family in dict.fromkeys(chain.from_iterable(getattr(file, part) for file in files))
        }
        for part in _CHANNELS
    }
    shows = {lexeme: families for file in files for lexeme, families in file.shows.items()}
    return _FamiliesFile.model_construct(None, **parts, shows=shows)


_CHANNELS: Mapping[str, frozenset[Channel]] = MappingProxyType(
    {
        "gesture": frozenset({Channel.GESTURE}),
        "head": frozenset({Channel.HEAD, Channel.POSTURE}),
        "face": frozenset({Channel.FACE}),
        "gaze": frozenset({Channel.GAZE}),
    }
)
"""What the behaviours of each part of the file may move: a lean of the trunk counts as a movement of the head."""


def _behaviors(listed: Mapping[str, tuple[_FamilyLine, ...]]) -> Mapping[str, tuple[FamilyBehavior, ...]]:
    return MappingProxyType({family: tuple(map(_behavior, lines)) for family, lines in listed.items()})


def _behavior(line: _FamilyLine) -> FamilyBehavior:
    levels = frozenset(Level if line.agitation is None else line.agitation)
    return FamilyBehavior(line.behavior, frozenset(line.lemmas or ()), levels)


def _mistakes(
    source: Source, file: _FamiliesFile, whole: _FamiliesFile, behaviors: Mapping[str, Playable]
) -> Iterator[Mistake]:
    """The mistakes in one file, which is read as a part of the whole."""
    for part in _CHANNELS:
        for family, lines in getattr(file, part).items():
            for position, line in enumerate(lines):
                for message in _line_mistakes(part, line, behaviors):
                    yield source.mistake((part, family, position), message)
    for family, position, message in _unshown(file, whole.shows, behaviors):
        yield source.mistake(("gesture", family, position), message)
    for lexeme, families in file.shows.items():
        for position, family in enumerate(families):
            if family not in whole.gesture:
                told = f"{family!r} is not a family of gestures{did_you_mean(family, whole.gesture)}"
                yield source.mistake(("shows", lexeme, position), told)


def _line_mistakes(part: str, line: _FamilyLine, behaviors: Mapping[str, Playable]) -> Iterator[str]:
    if line.behavior not in behaviors:
        yield f"no behaviour is called {line.behavior!r}{did_you_mean(line.behavior, behaviors)}"
    elif behaviors[line.behavior].channel not in _CHANNELS[part]:
        allowed = " or ".join(sorted(_CHANNELS[part]))
        yield f"{line.behavior} is a behaviour of {behaviors[line.behavior].channel}; {part} wants one of {allowed}"


def _unshown(
    file: _FamiliesFile, shows: Mapping[str, Collection[str]], behaviors: Mapping[str, Playable]
) -> Iterator[tuple[str, int, str]]:
    """Behaviours listed under a family that `shows` does not give for their lexeme."""
    for family, lines in file.gesture.items():
        for position, line in enumerate(lines):
            lexeme = behaviors[line.behavior].lexeme if line.behavior in behaviors else None
            if lexeme is not None and lexeme in shows and family not in shows[lexeme]:
                told = ", ".join(shows[lexeme])
                yield family, position, f"{line.behavior} is a {lexeme}, which `shows` says is read as {told}"


def _unlisted(file: _FamiliesFile, behaviors: Mapping[str, Playable]) -> Iterator[str]:
    """Gesture lexemes of the table that are missing in `shows`."""
    lexemes = {each.lexeme for each in behaviors.values() if each.channel is Channel.GESTURE}
    for lexeme in sorted(lexemes - file.shows.keys()):
        yield f"{lexeme} is missing: say which families an audience may read in it, the likeliest first"

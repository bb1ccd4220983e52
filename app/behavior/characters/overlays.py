"""Characters: overlays on the one behaviour table, which holds for everything that a character does not override.

`lexicon/characters/NAME.yaml` defines the character NAME. All mistakes in the table and in all characters are reported
at once.

A character who never does something does something else instead, where its file says what (docs/characters.md).
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import chain
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Literal, TypeVar

from pydantic import BeforeValidator, Field

from ...errors import AuthoringError, InputError, Mistake, collected, did_you_mean, shown
from ...model import CallableNames, Channel, Demand, Hand
from ...model.figure import AVERAGE_HEIGHT_M, PLAIN, Figure, GestureManner, Hair, Legwear, Looks, Physique, Sex, Wait
from ...yaml_files import Entry, Source
from ..candidates.demands import banned_by, meant
from ..candidates.vocabulary import BANNABLE, DEMANDABLE
from ..idle.idle_behaviors import TALKING
from ..reading.families import Families
from ..table.behavior_table import BehaviorChange, BehaviorEntry, BehaviorTable, changed, load_table, mistakes_of

Value = TypeVar("Value")

LIVELY_PER_MINUTE = 21.0
"""Strokes per minute of a lively talker."""


@dataclass(frozen=True, slots=True)
class Character:
    """How one character moves: its own entries of the table, the hand it prefers, strokes per minute of speech.

    `strokes_per_unit` is the most before the hands rest, `amplitude` how large its movements are (1 as in the table;
    already applied to `entries`), `stillness` how little it moves without need (0 to 1), `eye_contact` the share of
    time in which it looks at the listener while it talks, `rest_poses` the postures between which it changes, `figure`
    its body. `always` is what it shows wherever a rule offers it, `never` what it never shows, each with
    the behaviour that comes instead; `choice` is how its movements are chosen, if it says, `stands_for` the
    lexemes, by behaviour, that it shows by others.
    """

    name: str
    description: str
    handedness: Hand
    gestures_per_minute: float
    strokes_per_unit: int
    amplitude: float
    stillness: float
    eye_contact: float
    rest_poses: tuple[str, ...]
    entries: Mapping[str, BehaviorEntry]
    figure: Figure
    always: tuple[str, ...] = ()
    never: Mapping[str, str | None] = field(default_factory=dict)
    choice: str | None = None
    stands_for: Mapping[str, str] = field(default_factory=dict)

    @property
    def liveliness(self) -> float:
        """Its gesture rate relative to a lively talker's, which the plan takes as 1."""
        return self.gestures_per_minute / LIVELY_PER_MINUTE

    @property
    def lexemes(self) -> Mapping[str, tuple[Channel, str]]:
        """The channel and lexeme of each of its behaviours."""
        return {name: (entry.channel, entry.lexeme) for name, entry in self.entries.items()}


@dataclass(frozen=True, slots=True)
class Characters:
    """All characters by name, in alphabetical order."""

    by_name: Mapping[str, Character]
    callable_names: CallableNames

    @classmethod
    def load(cls, lexicon: Path) -> "Characters":
        """The table and the characters of a lexicon folder. Raises AuthoringError with every mistake."""
        mistakes: list[Mistake] = []
        table = collected(partial(load_table, lexicon / "behaviors.yaml"), mistakes)
        paths = sorted((lexicon / "characters").glob("*.yaml"))
        sheets = [collected(partial(_ValidFile.read, path), mistakes) for path in paths]
        characters = [collected(partial(sheet.overlaid, table), mistakes) for sheet in sheets if sheet and table]
        if table is None or mistakes:
            raise AuthoringError(tuple(mistakes))
        by_name = {character.name: character for character in characters if character}
        lexemes = frozenset(line.lexeme for line in table.lines.values())
        names = CallableNames(frozenset(table.lines), demandable=DEMANDABLE | lexemes, bannable=BANNABLE | lexemes)
        return cls(MappingProxyType(by_name), names)

    @property
    def behavior_names(self) -> frozenset[str]:
        """The names of the table."""
        return self.callable_names.behaviors

    @property
    def gesture_lexemes(self) -> frozenset[str]:
        """The lexemes of all gestures of all characters."""
        entries = chain.from_iterable(each.entries.values() for each in self.by_name.values())
        return frozenset(entry.lexeme for entry in entries if entry.channel is Channel.GESTURE)

    def named(self, name: str) -> Character:
        """The character of that name; raises InputError `unknown_character`."""
        if name not in self.by_name:
            raise InputError(
                "unknown_character",
                f"there is no character {shown(name)}{did_you_mean(name, self.by_name)}; "
                f"there are {', '.join(self.by_name) or 'none'}",
                field="character",
            )
        return self.by_name[name]


class _Body(Entry):
    sex: Literal["female", "male", "neutral"] = "neutral"
    age_years: int = Field(default=35, ge=16, le=100)
    height_m: float = Field(default=AVERAGE_HEIGHT_M, ge=1.45, le=2.05)
    build: float = Field(default=1.0, ge=0.85, le=1.4)
    shoulder_width: float = Field(default=1.0, ge=0.85, le=1.2)
    hip_width: float = Field(default=1.0, ge=0.85, le=1.2)


_Colour = Annotated[str, Field(pattern=r"^#[0-9a-fA-F]{6}$")]


class _Looks(Entry):
    hair: Literal["bald", "short", "bob", "long", "bun"] = "short"
    legwear: Literal["trousers", "skirt"] = "trousers"
    hair_colour: _Colour = PLAIN.looks.hair_colour
    skin_colour: _Colour = PLAIN.looks.skin_colour
    eye_colour: _Colour = PLAIN.looks.eye_colour
    top_colour: _Colour = PLAIN.looks.top_colour
    legwear_colour: _Colour = PLAIN.looks.legwear_colour
    shoe_colour: _Colour = PLAIN.looks.shoe_colour


class _Gestures(Entry):
    space: float = Field(default=1.0, ge=0.7, le=1.3)
    pace: float = Field(default=1.0, ge=0.8, le=1.25)
    elbow_deg: float = Field(default=0.0, ge=-20, le=30)
    wrist_deg: float = Field(default=0.0, ge=-20, le=20)


def _without_instead(value: object) -> object:
    """Lets what never comes be a list, where nothing comes instead, and have nothing after its colon."""
    if isinstance(value, list):
        return dict.fromkeys(value)
    return {what: instead or None for what, instead in value.items()} if isinstance(value, dict) else value


class _CharacterFile(Entry):
    description: str = Field(min_length=1)
    handedness: Literal["left", "right"]
    gestures_per_minute: float = Field(ge=0, le=60)
    strokes_per_unit: int = Field(default=3, ge=1, le=20)
    amplitude: float = Field(default=1.0, ge=0.1, le=2)
    stillness: float = Field(default=0.0, ge=0, le=1)
    eye_contact: float = Field(default=TALKING.eye_contact, ge=0.05, le=0.95)
    rest_poses: tuple[str, ...] = ("rest_on_left_leg", "rest_on_right_leg")
    between_gestures: tuple[Literal["belly", "uneven", "one", "hip", "pocket", "forearm", "open"], ...] = ()
    behaviors: dict[str, BehaviorChange] = Field(default_factory=dict)
    always: tuple[str, ...] = ()
    never: Annotated[dict[str, str | None], BeforeValidator(_without_instead)] = Field(default_factory=dict)
    choice: Literal["terms", "priority"] | None = None
    body: _Body = _Body()
    looks: _Looks = _Looks()
    gestures: _Gestures = _Gestures()

    def figure(self) -> Figure:
        body, looks = self.body.model_dump(), self.looks.model_dump()
        return Figure(
            Physique(**body | {"sex": Sex(self.body.sex)}),
            Looks(**looks | {"hair": Hair(self.looks.hair), "legwear": Legwear(self.looks.legwear)}),
            GestureManner(**self.gestures.model_dump()),
            Hand(self.handedness),
            tuple(map(Wait, self.between_gestures)),
        )


@dataclass(frozen=True, slots=True)
class _ValidFile:
    """A character's file, valid by itself."""

    source: Source
    file: _CharacterFile

    @classmethod
    def read(cls, path: Path) -> "_ValidFile":
        if not _NAME.fullmatch(path.stem):
            raise AuthoringError(
                (Mistake(path, 1, 1, "a character's file is named in letters, digits and _, a letter first"),)
            )
        source = Source(path)
        return cls(source, source.validated(_CharacterFile))

    def overlaid(self, table: BehaviorTable) -> Character:
        """The character over `table`; raises AuthoringError for changes of missing entries and contradictory ones."""
        mistakes = [self.source.mistake(tuple(place), message) for *place, message in self._mistakes(table)]
        if mistakes:
            raise AuthoringError(tuple(mistakes))
        entries = {
            name: _sized(table.entry(name, self.file.behaviors.get(name)), self.file.amplitude) for name in table.lines
        }
        return Character(
            name=self.source.path.stem,
            description=self.file.description,
            handedness=Hand(self.file.handedness),
            gestures_per_minute=self.file.gestures_per_minute,
            strokes_per_unit=self.file.strokes_per_unit,
            amplitude=self.file.amplitude,
            stillness=self.file.stillness,
            eye_contact=self.file.eye_contact,
            rest_poses=self.file.rest_poses,
            entries=MappingProxyType(entries),
            figure=self.file.figure(),
            always=self.file.always,
            never=MappingProxyType(self.file.never),
            choice=self.file.choice,
        )

    def _mistakes(self, table: BehaviorTable) -> Iterator[tuple[str, ...]]:
        for name, change in self.file.behaviors.items():
            if name not in table.lines:
                yield "behaviors", name, f"the table has no behaviour {name!r}{did_you_mean(name, table.lines)}"
                continue
            for key, message in mistakes_of(changed(table.lines[name], change), table.timings):
                yield "behaviors", name, key, message
        yield from self._demand_mistakes(table)
        for name in self.file.rest_poses:
            if name not in table.lines or table.lines[name].channel is not Channel.POSTURE:
                postures = [each for each, line in table.lines.items() if line.channel is Channel.POSTURE]
                yield "rest_poses", f"{name!r} is not a posture of the table{did_you_mean(name, postures)}"

    def _demand_mistakes(self, table: BehaviorTable) -> Iterator[tuple[str, ...]]:
        known = {*BANNABLE, *table.lines, *(line.lexeme for line in table.lines.values())}
        for key, listed in (("always", self.file.always), ("never", self.file.never)):
            for what in (each for each in listed if each not in known):
                message = f"{what!r} is not a behaviour, lexeme, family or channel{did_you_mean(what, known)}"
                yield (key, what, message) if key == "never" else (key, message)
        for what, instead in self.file.never.items():
            if instead is not None and instead not in table.lines:
                message = f"the table has no behaviour {instead!r}{did_you_mean(instead, table.lines)}"
                yield "never", what, message


_USUAL_GESTURE = 0.5
"""The size of a gesture whose entry has none."""


def _sized(entry: BehaviorEntry, amplitude: float) -> BehaviorEntry:
    """The entry with the character's amplitude applied, except for gazes and eyes, which have no size."""
    if entry.channel not in (Channel.GESTURE, Channel.HEAD, Channel.FACE):
        return entry
    amount = _USUAL_GESTURE if entry.channel is Channel.GESTURE and entry.amount is None else entry.amount
    return entry if amount is None else replace(entry, amount=min(1.0, amount * amplitude))


_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


WHOLE_LINE = 1_000_000
"""A last word that no line has."""


def abstaining(character: Character, families: Families) -> Character:
    """The character with the behaviours it never shows replaced by those it shows instead; whatever asks for them
    (rules, the reading, targets) then has the others."""
    entries, stands_for = dict(character.entries), dict[str, str]()
    for what, instead in character.never.items():
        if instead is not None:
            for name in meant(what, families, character.entries):
                if character.entries[name].channel is character.entries[instead].channel:
                    entries[name] = replace(character.entries[instead], name=name)
                    stands_for[name] = character.entries[name].lexeme
    return replace(character, entries=MappingProxyType(entries), stands_for=stands_for) if stands_for else character


def forbidden(character: Character) -> Iterator[Demand]:
    """What the character never shows, on any word."""
    for what in character.never:
        yield Demand(what, 0, WHOLE_LINE, always=False, by=f"the character {character.name}")


def never_shown(character: Character, families: Families) -> Iterator[tuple[Channel, str]]:
    """The channels and lexemes of what the character never shows."""
    for ban in banned_by(forbidden(character), families, character.entries):
        yield from (character.lexemes[name] for name in ban.names)

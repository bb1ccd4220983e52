"""JSON responses about authored resources: rules and words, characters, gestures; see `understudy.schemas.responses`
for the conventions."""

from collections.abc import Iterable
from typing import Self

from pydantic import Field

from ..authoring.catalogue import Character, Item, ItemKind, shown_path
from ..behavior.characters.overlays import Characters
from ..behavior.reading.families import Families
from ..model import Channel, Hand, Level
from ..realizer.gestures.gesture import Definition
from ..realizer.gestures.library import clip
from .response_model import Number, ResponseModel


class RuleResponse(ResponseModel):
    """A rule, lexicon word, mapping or table entry, with the function it concerns and its place in the files."""

    kind: ItemKind
    name: str
    class_name: str | None = Field(default=None, serialization_alias="class")
    subtype: str | None = None
    file: str
    line: int


class RulesResponse(ResponseModel):
    """All rules, words, mappings and table entries."""

    rules: list[RuleResponse]

    @classmethod
    def of(cls, items: Iterable[Item]) -> Self:
        return cls(rules=[RuleResponse.model_validate(item) for item in items])


class TableEntryResponse(ResponseModel):
    """An entry of the behaviour table, as one character overrides it."""

    name: str
    channel: str
    lexeme: str
    hand: str | None = None
    amount: Number | None = None
    repetitions: int | None = None
    target: str | None = None
    direction: str | None = None


class BodyResponse(ResponseModel):
    """The proportions of a body; widths and build are relative to the average of its height and sex."""

    sex: str
    age_years: int
    height_m: Number
    build: Number
    shoulder_width: Number
    hip_width: Number


class LooksResponse(ResponseModel):
    """Hair, clothes and sRGB colours."""

    hair: str
    legwear: str
    hair_colour: str
    skin_colour: str
    eye_colour: str
    top_colour: str
    legwear_colour: str
    shoe_colour: str


class MannerResponse(ResponseModel):
    """How a character varies every gesture."""

    space: Number
    pace: Number
    elbow_deg: Number
    wrist_deg: Number


class CharacterResponse(ResponseModel):
    """A character; `behaviors` are its overrides of the table's entries."""

    name: str
    description: str
    handedness: str
    gestures_per_minute: Number
    strokes_per_unit: int
    amplitude: Number
    stillness: Number
    eye_contact: Number
    rest_poses: list[str]
    body: BodyResponse
    looks: LooksResponse
    gestures: MannerResponse
    behaviors: list[TableEntryResponse]

    @classmethod
    def of(cls, character: Character) -> Self:
        figure = character.figure
        others = {
            "body": figure.physique,
            "looks": figure.looks,
            "gestures": figure.manner,
            "behaviors": list(character.entries.values()),
        }
        taken = {name: getattr(character, name) for name in cls.model_fields if name not in others}
        return cls.model_validate({**taken, **others})


class CharactersResponse(ResponseModel):
    """All characters."""

    characters: list[CharacterResponse]

    @classmethod
    def of(cls, characters: Iterable[Character]) -> Self:
        return cls(characters=[CharacterResponse.of(character) for character in characters])


class GestureLevelResponse(ResponseModel):
    """The expressivity of a gesture at one level of agitation; `markers_s` are relative to its start."""

    amplitude: Number
    tempo: Number
    fluidity: Number
    power: Number
    repetition: Number
    markers_s: dict[str, Number]
    stroke_speed_m_s: Number


class GestureResponse(ResponseModel):
    """A gesture of the library; `arms` is absent if either hand may make it."""

    name: str
    gesture_class: str = Field(serialization_alias="class")
    categories: list[str]
    arms: Hand | None = None
    aimed: bool
    duration_s: Number
    levels: dict[Level, GestureLevelResponse]
    file: str | None = None
    line: int

    @classmethod
    def of(cls, definition: Definition) -> Self:
        return cls(
            name=definition.name,
            gesture_class=definition.gesture_class,
            categories=list(definition.categories),
            arms=definition.hand,
            aimed=definition.aimed,
            duration_s=definition.duration_s,
            levels={level: _at_level(definition, level) for level in definition.levels},
            file=shown_path(definition.path) if definition.path else None,
            line=definition.line,
        )


class GesturesResponse(ResponseModel):
    """All gestures of the library. `families` are what each lexeme may be read as, the likeliest first; `lexemes` are
    those of the behaviour table by channel."""

    gestures: list[GestureResponse]
    families: dict[str, list[str]]
    lexemes: dict[Channel, list[str]]

    @classmethod
    def of(cls, definitions: Iterable[Definition], families: Families, characters: Characters) -> Self:
        lexemes: dict[Channel, set[str]] = {channel: set() for channel in Channel}
        for character in characters.by_name.values():
            for channel, lexeme in character.lexemes.values():
                lexemes[channel].add(lexeme)
        return cls(
            gestures=[GestureResponse.of(definition) for definition in definitions],
            families={lexeme: list(shown) for lexeme, shown in families.shows.items()},
            lexemes={channel: sorted(found) for channel, found in lexemes.items()},
        )


def _at_level(definition: Definition, level: Level) -> GestureLevelResponse:
    made = clip(definition, level, definition.hand or Hand.RIGHT, definition.categories[0])
    return GestureLevelResponse(
        **{name: getattr(made.expressivity, name) for name in made.expressivity.__slots__},
        markers_s={name: getattr(made.markers, name) for name in made.markers.__slots__},
        stroke_speed_m_s=made.stroke_speed_m_s,
    )

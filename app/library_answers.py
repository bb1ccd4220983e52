"""The JSON shapes of what authors edit: rules and words, characters, gestures; by the conventions of `app.answers`."""

from collections.abc import Iterable
from typing import Self

from pydantic import Field

from app.answers import Answer, Number
from app.catalogue import Character, Item, Kind, shown_path
from app.model import Hand, Level
from app.realizer.clips import clip
from app.realizer.gesture import Definition


class RuleAnswer(Answer):
    """A rule, word, mapping or table entry, by the function it speaks of, and where an author finds it."""

    kind: Kind
    name: str
    class_name: str | None = Field(default=None, serialization_alias="class")
    subtype: str | None = None
    file: str
    line: int


class RulesAnswer(Answer):
    """All that authors edit."""

    rules: list[RuleAnswer]

    @classmethod
    def of(cls, items: Iterable[Item]) -> Self:
        return cls(rules=[RuleAnswer.model_validate(item) for item in items])


class TableEntryAnswer(Answer):
    """A movement as one character makes it."""

    name: str
    channel: str
    lexeme: str
    hand: str | None = None
    amount: Number | None = None
    repetitions: int | None = None
    target: str | None = None
    direction: str | None = None


class CharacterAnswer(Answer):
    """Who performs; `behaviors` are the character's own versions of the table's entries."""

    name: str
    description: str
    handedness: str
    gestures_per_minute: Number
    strokes_per_unit: int
    amplitude: Number
    stillness: Number
    eye_contact: Number
    rest_poses: list[str]
    behaviors: list[TableEntryAnswer]

    @classmethod
    def of(cls, character: Character) -> Self:
        told = {name: getattr(character, name) for name in cls.model_fields if name != "behaviors"}
        return cls.model_validate({**told, "behaviors": list(character.entries.values())})


class CharactersAnswer(Answer):
    """All who can perform."""

    characters: list[CharacterAnswer]

    @classmethod
    def of(cls, characters: Iterable[Character]) -> Self:
        return cls(characters=[CharacterAnswer.of(character) for character in characters])


class GestureLevelAnswer(Answer):
    """How a gesture is made at one level of agitation; `markers_s` count from its start."""

    amplitude: Number
    tempo: Number
    fluidity: Number
    power: Number
    repetition: Number
    markers_s: dict[str, Number]
    stroke_speed_m_s: Number


class GestureAnswer(Answer):
    """A gesture of the library; `arms` is absent when either hand may make it."""

    name: str
    gesture_class: str = Field(serialization_alias="class")
    categories: list[str]
    arms: Hand | None = None
    aimed: bool
    duration_s: Number
    levels: dict[Level, GestureLevelAnswer]
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


class GesturesAnswer(Answer):
    """All gestures of the library."""

    gestures: list[GestureAnswer]

    @classmethod
    def of(cls, definitions: Iterable[Definition]) -> Self:
        return cls(gestures=[GestureAnswer.of(definition) for definition in definitions])


def _at_level(definition: Definition, level: Level) -> GestureLevelAnswer:
    made = clip(definition, level, definition.hand or Hand.RIGHT, definition.categories[0])
    return GestureLevelAnswer(
        **{name: getattr(made.expressivity, name) for name in made.expressivity.__slots__},
        markers_s={name: getattr(made.markers, name) for name in made.markers.__slots__},
        stroke_speed_m_s=made.stroke_speed_m_s,
    )

"""An author's edits of a line (`--edits FILE`, the part `edits` of a request): checks their format, and reports every
mistake with its place. docs/edits.md explains them, docs/edits.schema.json is their JSON schema.

Whether the words, behaviours and lexemes exist is checked where the line is known (`understudy.edits`).
"""

import json
from collections.abc import Sequence
from typing import Annotated, Literal, Self

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, model_validator

from ..errors import InputError
from ..model import AffectTrack, Channel, Hand
from ..model.edits import (
    MARKS,
    BehaviorEdit,
    BehaviorReference,
    Edge,
    Edits,
    HeardTime,
    LineSettings,
    MarkPlace,
    Marks,
    Omission,
    WordEdit,
    WordMark,
    WordReference,
)
from ..model.tables import GazeDirection
from .affect import affect_rows, affect_track
from .options import AffectValue, LevelName, ModeName, Seed
from .requests import mistakes_told, read_object

FIELD = "edits"
MOST_EDITS = 500
"""The most edits of words, and the most of behaviours."""
LONGEST_OFFSET_S = 60.0
LONGEST_NAME = 100
_MOST_IN_MESSAGE = 20


def _counted(edits: object) -> object:
    """The edits, after checking their number, before any is validated: each mistake takes a kilobyte to report."""
    if isinstance(edits, Sequence) and len(edits) > MOST_EDITS:
        raise ValueError(f"{len(edits)} edits; {MOST_EDITS} at most")
    return edits


def _affect_given(given: object) -> object:
    """The JSON of a feeling, or of a value that is to be written."""
    return affect_rows(given) if isinstance(given, AffectTrack) else given


def _usable_affect(given: AffectValue) -> AffectValue:
    """Raises ValueError for a value that is not a feeling."""
    try:
        affect_track(given)
    except InputError as error:
        raise ValueError(error.message) from None
    return given


_Affect = Annotated[AffectValue, BeforeValidator(_affect_given), AfterValidator(_usable_affect)]
_Counted = BeforeValidator(_counted)
_Name = Annotated[str, Field(min_length=1, max_length=LONGEST_NAME)]
_Offset = Annotated[float, Field(ge=-LONGEST_OFFSET_S, le=LONGEST_OFFSET_S, allow_inf_nan=False)]
_Second = Annotated[float, Field(ge=0, le=36_000, allow_inf_nan=False)]


class _EditForm(BaseModel):
    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", strict=True, from_attributes=True)


class WordReferenceForm(_EditForm):
    """A word by its number and text. If there is another text, the nearest word with this one is meant."""

    word: Annotated[int, Field(ge=0, le=1_000_000, description="The first is 0.")]
    text: _Name | None = None

    def to_value(self) -> WordReference:
        return WordReference(self.word, self.text)


class MarkPlaceForm(_EditForm):
    """A time: `offset_s` after an edge of a word."""

    at: WordReferenceForm
    edge: Annotated[Edge, Field(strict=False)] = Edge.START
    offset_s: _Offset = 0.0

    def to_value(self) -> MarkPlace:
        return MarkPlace(self.at.to_value(), self.offset_s, self.edge)


class MarksForm(_EditForm):
    """The sync points that were moved; the others follow."""

    start: MarkPlaceForm | None = None
    ready: MarkPlaceForm | None = None
    stroke_start: MarkPlaceForm | None = None
    stroke: MarkPlaceForm | None = None
    stroke_end: MarkPlaceForm | None = None
    relax: MarkPlaceForm | None = None
    end: MarkPlaceForm | None = None

    def to_value(self) -> Marks:
        places = ((name, getattr(self, name)) for name in MARKS)
        return Marks(**{name: place.to_value() for name, place in places if place is not None})


class BehaviorReferenceForm(_EditForm):
    """One of the line's behaviours as it is without edits: its channel, its first word, and what identifies it."""

    channel: Annotated[Channel, Field(strict=False)]
    at: WordReferenceForm
    function: Annotated[_Name | None, Field(description="The class of the function that it shows.")] = None
    family: Annotated[_Name | None, Field(description="What it is meant to be read as.")] = None
    lexeme: Annotated[_Name | None, Field(description="Its BML word.")] = None
    offset_s: Annotated[_Offset | None, Field(description="How long after its word it began.")] = None

    @model_validator(mode="after")
    def _says_what(self) -> Self:
        if self.function is None and self.family is None and self.lexeme is None:
            raise ValueError("say what it is: give function, family or lexeme")
        return self

    def to_value(self) -> BehaviorReference:
        return BehaviorReference(
            self.channel, self.at.to_value(), self.function, self.family, self.lexeme, self.offset_s
        )


class BehaviorEditForm(_EditForm):
    """The changes to one behaviour: `of` refers to an existing one; `add` and `on` make a new one."""

    of: BehaviorReferenceForm | None = None
    add: Annotated[Channel | None, Field(strict=False)] = None
    on: WordReferenceForm | None = None
    lexeme: _Name | None = None
    hand: Annotated[Hand | None, Field(strict=False)] = None
    amount: Annotated[float | None, Field(ge=0, le=1, allow_inf_nan=False)] = None
    direction: Annotated[GazeDirection | None, Field(strict=False, description="Of a gaze, beside its target.")] = None
    marks: MarksForm = MarksForm()
    omit: Annotated[Omission | None, Field(strict=False)] = None
    lock: Annotated[bool, Field(description="Made as given here, even where the choice would not make it.")] = False

    @model_validator(mode="after")
    def _makes_sense(self) -> Self:
        listed = "; ".join(self._mistakes())
        if listed:
            raise ValueError(listed)
        return self

    def _mistakes(self) -> list[str]:
        channel = self.of.channel if self.of else self.add
        says = [name for name in ("lexeme", "hand", "amount", "direction", "omit") if getattr(self, name) is not None]
        named = self.lexeme or (self.of.lexeme if self.of else None)
        found = {
            "give either `of`, or both `add` and `on`": (self.of is None) == (self.add is None),
            "`on` goes with `add`, not with `of`": (self.add is None) != (self.on is None),
            "what is added needs a lexeme": self.add is not None and self.lexeme is None,
            "a lock needs a lexeme, its own or that of `of`": self.lock and named is None,
            "an edit with omit takes no other fields": self.omit is not None and (len(says) > 1 or self.lock),
            "it changes nothing": bool(self.of) and not (says or self.lock or self.marks != MarksForm()),
            f"hand is for gesture, this is {channel}": self.hand is not None and channel is not Channel.GESTURE,
            f"direction is for gaze, this is {channel}": self.direction is not None and channel is not Channel.GAZE,
            "a posture has no amount": self.amount is not None and channel is Channel.POSTURE,
        }
        return [message for message, wrong in found.items() if wrong]

    def to_value(self) -> BehaviorEdit:
        return BehaviorEdit(
            of=self.of.to_value() if self.of else None,
            add=self.add,
            on=self.on.to_value() if self.on else None,
            lexeme=self.lexeme,
            hand=self.hand,
            amount=self.amount,
            direction=self.direction.value if self.direction else None,
            marks=self.marks.to_value(),
            omit=self.omit,
            lock=self.lock,
        )


class HeardTimeForm(_EditForm):
    """When the aligner heard a word."""

    start_s: _Second
    end_s: _Second


class WordEditForm(_EditForm):
    """The changes to one word: marked `important` or `still`, or its corrected time."""

    at: WordReferenceForm
    mark: Annotated[WordMark | None, Field(strict=False)] = None
    start_s: Annotated[_Second | None, Field(description="Seconds of the recording.")] = None
    end_s: _Second | None = None
    heard: Annotated[
        HeardTimeForm | None,
        Field(description="When it was heard; if it is now heard at another time, it is not corrected."),
    ] = None

    @model_validator(mode="after")
    def _makes_sense(self) -> Self:
        if (self.start_s is None) != (self.end_s is None):
            raise ValueError("give start_s and end_s together")
        if self.start_s is not None and self.end_s is not None and self.start_s >= self.end_s:
            raise ValueError(f"it starts at {self.start_s:g} s and ends at {self.end_s:g} s")
        if self.start_s is None and self.mark is None:
            raise ValueError("it changes nothing")
        return self

    def to_value(self) -> WordEdit:
        heard = HeardTime(self.heard.start_s, self.heard.end_s) if self.heard else None
        return WordEdit(self.at.to_value(), self.mark, self.start_s, self.end_s, heard)


class LineSettingsForm(_EditForm):
    """Options that the author set for the line; they override those of the request."""

    character: _Name | None = None
    agitation: LevelName | None = None
    seed: Seed | None = None
    stillness: Annotated[float | None, Field(ge=0, le=1, allow_inf_nan=False)] = None
    mode: ModeName | None = None
    affect: _Affect | None = None

    def to_value(self) -> LineSettings:
        affect = None if self.affect is None else affect_track(self.affect)
        return LineSettings(self.character, self.agitation, self.seed, self.stillness, self.mode, affect)


class EditsForm(_EditForm):
    """All changes that an author made to a line."""

    version: Literal[1] = 1
    line: LineSettingsForm = LineSettingsForm()
    words: Annotated[tuple[WordEditForm, ...], Field(strict=False, max_length=MOST_EDITS), _Counted] = ()
    behaviors: Annotated[tuple[BehaviorEditForm, ...], Field(strict=False, max_length=MOST_EDITS), _Counted] = ()

    def to_value(self) -> Edits:
        return Edits(
            self.line.to_value(),
            tuple(edit.to_value() for edit in self.words),
            tuple(edit.to_value() for edit in self.behaviors),
        )


def read_edits(content: bytes) -> Edits:
    """Raises UndecodableError `not_json`, InputError `not_an_object` and `edits_wrong` with every mistake, all with the
    field "edits"."""
    fields = read_object(content, FIELD)
    try:
        return EditsForm.model_validate(fields).to_value()
    except ValidationError as error:
        listed = mistakes_told(error, most=_MOST_IN_MESSAGE)
    raise InputError("edits_wrong", f"{FIELD}: {listed}", field=FIELD)


def write_edits(edits: Edits) -> bytes:
    """The edits as `read_edits` reads them: UTF-8 JSON."""
    return EditsForm.model_validate(edits).model_dump_json(exclude_defaults=True).encode()


def edits_schema() -> str:
    """The JSON schema of the edits, as in docs/edits.schema.json."""
    schema = {"$schema": "https://json-schema.org/draft/2020-12/schema", **EditsForm.model_json_schema()}
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"

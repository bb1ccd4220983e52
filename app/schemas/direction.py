"""A director's notes that come with a line (`--direction FILE`, the part `direction` of a request): checks their
format. docs/directing.md explains them, docs/direction.schema.json is their JSON schema.

Whether the families and words exist is checked where the line is known (`understudy.behavior.candidates.notes`).
"""

import json
from dataclasses import asdict
from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from ..behavior.candidates.vocabulary import AVOIDABLE, FACES, GAZES, GESTURES, HEADS
from ..errors import InputError
from ..model import Avoidance, Demand, DirectedMoment, Direction
from .requests import mistakes_told, read_object

FIELD = "direction"
MOST_NOTES = 1000
MOST_KINDS = 20
LONGEST_TEXT = 1000
NO_NEGATION = "no_negation"
"""A synonym for `negation` among what a note avoids."""

_MOST_IN_MESSAGE = 5


def _counted(notes: object) -> object:
    """The notes, after checking their number, before any is validated: each mistake takes a kilobyte to report."""
    if isinstance(notes, list) and len(notes) > MOST_NOTES:
        raise ValueError(f"{len(notes)} notes; {MOST_NOTES} at most")
    return notes


_Counted = BeforeValidator(_counted)

_Word = Annotated[int, Field(ge=0, le=1_000_000, description="The number of a word; the first is 0.")]
_Text = Annotated[str, Field(max_length=LONGEST_TEXT)]


_Gesture = Annotated[str, Field(json_schema_extra={"enum": list(GESTURES)})]
_Head = Annotated[str, Field(json_schema_extra={"enum": list(HEADS)})]
_Face = Annotated[str, Field(json_schema_extra={"enum": list(FACES)})]
_Gaze = Annotated[str, Field(json_schema_extra={"enum": list(GAZES)})]
_Avoided = Annotated[str, Field(json_schema_extra={"enum": sorted({*AVOIDABLE, NO_NEGATION})})]


class _NoteForm(BaseModel):
    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", strict=True)


class DirectedMomentRequest(_NoteForm):
    """Words over which the body should express something. Each kind listed would be right, the best first; an empty
    list leaves that part of the body to the rules."""

    first: _Word
    last: _Word
    stroke: Annotated[_Word | None, Field(description="Where the hand's stroke falls; left out: on `last`.")] = None
    importance: Annotated[
        int, Field(ge=1, le=3, description="3: the line fails without it, 2: clearly better with it, 1: nice.")
    ] = 2
    idea: Annotated[_Text, Field(description="What it shows, for people.")] = ""
    gesture: Annotated[tuple[_Gesture, ...], Field(strict=False, max_length=MOST_KINDS)] = ()
    head: Annotated[tuple[_Head, ...], Field(strict=False, max_length=MOST_KINDS)] = ()
    face: Annotated[tuple[_Face, ...], Field(strict=False, max_length=MOST_KINDS)] = ()
    gaze: Annotated[tuple[_Gaze, ...], Field(strict=False, max_length=MOST_KINDS)] = ()

    def to_moment(self) -> DirectedMoment:
        return DirectedMoment(
            first=self.first,
            last=self.last,
            stroke=self.last if self.stroke is None else self.stroke,
            importance=self.importance,
            gesture=self.gesture,
            head=self.head,
            face=self.face,
            gaze=self.gaze,
            idea=self.idea,
        )


class AvoidanceRequest(_NoteForm):
    """Words over which something would be wrong."""

    first: _Word
    last: _Word
    what: Annotated[
        tuple[_Avoided, ...],
        Field(
            strict=False,
            min_length=1,
            max_length=len(AVOIDABLE),
            description="`hands` is every gesture, `any` everything; `no_negation` is the same as `negation`.",
        ),
    ]
    why: Annotated[_Text, Field(description="For people.")] = ""

    def to_avoidance(self) -> Avoidance:
        return Avoidance(self.first, self.last, tuple(map(_plain, self.what)), self.why)


class DemandRequest(_NoteForm):
    """Words over which something always comes, or never."""

    first: _Word
    last: _Word
    what: Annotated[
        str,
        Field(
            max_length=100,
            description="A behaviour, lexeme or family. Never: also a channel, `hands` or `any`.",
        ),
    ]

    def to_demand(self, number: int, *, always: bool) -> Demand:
        by = f"the note {'always' if always else 'never'}[{number}]"
        return Demand(self.what, self.first, self.last, always, by)


class DirectionRequest(_NoteForm):
    """A director's notes on one line."""

    id: Annotated[str | int | None, Field(description="Not read.")] = None
    moments: Annotated[tuple[DirectedMomentRequest, ...], Field(strict=False, max_length=MOST_NOTES), _Counted] = ()
    avoid: Annotated[tuple[AvoidanceRequest, ...], Field(strict=False, max_length=MOST_NOTES), _Counted] = ()
    always: Annotated[tuple[DemandRequest, ...], Field(strict=False, max_length=MOST_NOTES), _Counted] = ()
    never: Annotated[tuple[DemandRequest, ...], Field(strict=False, max_length=MOST_NOTES), _Counted] = ()
    complete: Annotated[bool, Field(description="The hands do nothing but what the notes say.")] = False

    def to_direction(self) -> Direction:
        return Direction(
            moments=tuple(moment.to_moment() for moment in self.moments),
            avoid=tuple(avoidance.to_avoidance() for avoidance in self.avoid),
            demands=(
                *(each.to_demand(number, always=True) for number, each in enumerate(self.always)),
                *(each.to_demand(number, always=False) for number, each in enumerate(self.never)),
            ),
            complete=self.complete,
        )


def read_direction(content: bytes) -> Direction:
    """Raises UndecodableError `not_json`, InputError `not_an_object` and `direction_wrong` with the first mistakes, all
    with the field "direction"."""
    fields = read_object(content, FIELD)
    try:
        return DirectionRequest.model_validate(fields).to_direction()
    except ValidationError as error:
        listed = mistakes_told(error, most=_MOST_IN_MESSAGE)
    raise InputError("direction_wrong", f"{FIELD}: {listed}", field=FIELD)


def direction_fields(direction: Direction) -> dict[str, Any]:
    """The notes as they are sent: what `read_direction` reads."""
    demands: dict[bool, list[dict[str, object]]] = {True: [], False: []}
    for each in direction.demands:
        demands[each.always].append({"first": each.first, "last": each.last, "what": each.what})
    fields = asdict(direction)
    del fields["demands"]
    return {**fields, "always": demands[True], "never": demands[False]}


def direction_schema() -> str:
    """The JSON schema of the notes, as in docs/direction.schema.json."""
    schema = {"$schema": "https://json-schema.org/draft/2020-12/schema", **DirectionRequest.model_json_schema()}
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"


def _plain(word: str) -> str:
    return "negation" if word == NO_NEGATION else word

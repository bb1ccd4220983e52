"""Reads JSON objects that users send, and says what is wrong with them: the key, the reason, the nearest right name.

Each mistake is reported with its place, up to the first few.

A line without a recording (`understudy say`, `POST /perform` without audio) comes as marked text.

Communicative functions supplied with a line (`--functions FILE`, the part `functions` of a request) are a JSON list:
`[{"class": "deixis", "subtype": "self", "first": 0, "last": 0, "priority": 5}, …]`; `subtype` is omitted where the
class has none, `priority` is for a function that takes precedence over all derived ones. Only the format is checked
here; `understudy.rules.derivation` checks functions and words against the rules and the transcript.
"""

import json
import re
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import PurePath
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError
from pydantic_core import ErrorDetails

from ..errors import (
    LONGEST_SHOWN,
    InputError,
    UndecodableError,
    UnsupportedFormatError,
    did_you_mean,
    shown,
    why_not_json,
)
from ..model import PLAIN, Direction, GivenFunction, Line, Timings
from ..models import load_tag_table
from ..text.reading import read_marked

_ALLOWED = re.compile(r"'([^']*)'")
Checked = TypeVar("Checked", bound=BaseModel)

MOST_WRONG = 5
"""Parts of a request about which an error tells what is wrong."""


class FunctionsRequest(BaseModel):
    """A text to analyse; other keys are ignored."""

    model_config = ConfigDict(defer_build=True, frozen=True, strict=True)

    id: Annotated[str | int | None, Field(description="Returned as sent.")] = None
    text: Annotated[
        str,
        Field(
            description="The words.",
            examples=["No, I have never seen those."],
            json_schema_extra={"minLength": 1},
        ),
    ]


def read_object(content: bytes, field: str) -> dict[str, Any]:
    """The JSON object in `content`, called `field` in errors.

    Raises as `read_json` does, and InputError `not_an_object`.
    """
    value = read_json(content, field)
    if not isinstance(value, dict):
        raise InputError("not_an_object", f"{field} must be a JSON object in braces", field=field)
    return value


def read_json(content: bytes, field: str) -> object:
    """The JSON value in `content`, called `field` in errors.

    Raises UndecodableError `not_json`, InputError `text_surrogate` (anywhere in it).
    """
    try:
        value = json.loads(content, object_pairs_hook=partial(_once, field))
        json.dumps(value, ensure_ascii=False).encode()
    except UnicodeEncodeError as error:
        message = f"{field} holds the lone surrogate {error.object[error.start]!a}; send well-formed Unicode"
        raise InputError("text_surrogate", message, field=field) from None
    except (ValueError, RecursionError) as error:
        raise UndecodableError("not_json", f"{field} is not JSON: {why_not_json(error)}", field=field) from None
    return value


def _once(field: str, pairs: Sequence[tuple[str, object]]) -> dict[str, object]:
    """An object's keys and values; raises InputError `value_wrong` for a key that comes twice, which would be lost."""
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _value in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise InputError("value_wrong", f"{field}: the key {shown(twice)} comes twice", field=field)
    return found


def read_request(fields: dict[str, Any]) -> FunctionsRequest:
    """The validated request. Raises InputError `value_wrong` with the key's name in `field`."""
    return checked(FunctionsRequest, fields)


def line_id(fields: dict[str, Any]) -> str | int | None:
    """The `id` of a request that may otherwise be invalid; None if there is none that can be returned."""
    found = fields.get("id")
    return found if isinstance(found, (str, int)) else None


def read_timings(file_name: str, content: bytes) -> Timings:
    """Word timings of another tool, in the format that the file's extension indicates.

    Raises UnsupportedFormatError `timings_format`.
    """
    ending = PurePath(file_name).suffix.lower().removeprefix(".")
    if ending not in {"json", "textgrid", "ctm"}:
        raise UnsupportedFormatError(
            "timings_format",
            f"timed words are read from .json, .TextGrid or .ctm, not from {shown(file_name)}",
            field="words",
        )
    return Timings(content=content, format=ending)


def checked(model: type[Checked], fields: dict[str, Any]) -> Checked:
    """The fields as `model`; raises InputError `value_wrong` with all parts that are wrong, the first as `field`."""
    try:
        return model.model_validate(fields)
    except ValidationError as error:
        found = error.errors()
    mistakes = [f"{'.'.join(_where(each)) or repr('')}: {_reason(each, model)}" for each in found[:MOST_WRONG]]
    more = [f"and {len(found) - MOST_WRONG} more"] if len(found) > MOST_WRONG else []
    raise InputError("value_wrong", "; ".join((*mistakes, *more)), field=_where(found[0])[0])


def _where(found: ErrorDetails) -> list[str]:
    return [str(part)[:LONGEST_SHOWN] for part in found["loc"]]


def _reason(found: ErrorDetails, model: type[BaseModel]) -> str:
    """What is wrong with a key or its value, with the nearest name that would be right."""
    if found["type"] == "extra_forbidden" and len(found["loc"]) == 1:
        near = did_you_mean(str(found["loc"][0]), model.model_fields)
        return f"there is no such key{near or '; there are ' + ', '.join(model.model_fields)}"
    reason = f"{found['msg'][0].lower()}{found['msg'][1:]}"
    if isinstance(found["input"], str):
        return reason + did_you_mean(found["input"], _ALLOWED.findall(str(found.get("ctx", {}).get("expected", ""))))
    return reason


_OURS = "Value error, "
"""The prefix that pydantic puts before our messages."""


def mistakes_told(error: ValidationError, *, most: int) -> str:
    """The first `most` mistakes, and how many more there are."""
    found = error.errors(include_url=False)
    listed = "; ".join(_told(tuple(each["loc"]), each["msg"].removeprefix(_OURS)) for each in found[:most])
    return f"{listed}; and {len(found) - most} more" if len(found) > most else listed


def _told(location: tuple[int | str, ...], message: str) -> str:
    """A mistake with its place, such as `moments[2].stroke`."""
    parts = (f"[{part}]" if isinstance(part, int) else f".{part[:LONGEST_SHOWN]}" for part in location)
    where = "".join(parts).removeprefix(".")
    return f"{where}: {message[0].lower()}{message[1:]}"


def spoken_line(
    text: str,
    timings: Timings | None = None,
    functions: Sequence[GivenFunction] = (),
    direction: Direction | None = None,
) -> Line:
    """The line; what its tags ask for comes beside the functions and notes that were given.

    Raises InputError `tags_wrong`, AuthoringError for the table of tags.
    """
    spoken = read_marked(text, load_tag_table)
    if spoken.demands:
        notes = direction or Direction()
        direction = replace(notes, demands=(*notes.demands, *spoken.demands))
    return Line(None, spoken.text, timings, (*functions, *spoken.functions), direction, spoken.speaking)


FIELD = "functions"
MOST_FUNCTIONS = 1000
MOST_WORDS = 20_000
"""The most words of all functions together: each word is listed as a support of its function."""


Position = Annotated[int, Field(ge=0)]


class GivenFunctionRequest(BaseModel):
    """One supplied function, with the field names of the responses."""

    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", strict=True)

    class_name: str = Field(alias="class")
    subtype: str = ""
    first: Position
    last: Position
    priority: Annotated[float, Field(ge=0, le=100, allow_inf_nan=False)] | None = None

    def to_function(self) -> GivenFunction:
        return GivenFunction(self.class_name, self.subtype or PLAIN, self.first, self.last, self.priority)


def read_functions(content: bytes) -> tuple[GivenFunction, ...]:
    """The functions in a JSON list. Raises UndecodableError `not_json`, InputError `functions_wrong`, with the field
    "functions"."""
    items = read_json(content, FIELD)
    if not isinstance(items, list):
        raise InputError("functions_wrong", "functions must be a JSON list in brackets", field=FIELD)
    if len(items) > MOST_FUNCTIONS:
        raise InputError("functions_wrong", f"functions: {len(items)} are more than {MOST_FUNCTIONS}", field=FIELD)
    functions = tuple(_function(number, item) for number, item in enumerate(items))
    words = sum(max(each.last - each.first + 1, 0) for each in functions)
    if words > MOST_WORDS:
        message = f"functions: they are over {words} words together; {MOST_WORDS} at most"
        raise InputError("functions_wrong", message, field=FIELD)
    return functions


def _function(number: int, item: object) -> GivenFunction:
    try:
        return GivenFunctionRequest.model_validate(item).to_function()
    except ValidationError as error:
        found = error.errors()[0]
    where = ".".join((f"functions[{number}]", *(str(part)[:LONGEST_SHOWN] for part in found["loc"])))
    reason = f"{found['msg'][0].lower()}{found['msg'][1:]}"
    raise InputError("functions_wrong", f"{where}: {reason}", field=FIELD)

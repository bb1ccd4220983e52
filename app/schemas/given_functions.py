"""Validates communicative functions supplied with a line (`--functions FILE`, the part `functions` of a request).

A JSON list: `[{"class": "deixis", "subtype": "self", "first": 0, "last": 0, "priority": 5}, …]`; `subtype` is omitted
where the class has none, `priority` for a function that takes precedence over all derived ones. Only the format is
checked here; `understudy.rules.given` checks functions and words against the rules and the transcript.
"""

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from ..errors import LONGEST_SHOWN, InputError
from ..model import PLAIN, GivenFunction
from .requests import read_json

FIELD = "functions"
MOST_FUNCTIONS = 1000
MOST_WORDS = 20_000
"""The most words of all functions together: each word is listed as a support of its function."""


Position = Annotated[int, Field(ge=0)]


class GivenFunctionRequest(BaseModel):
    """One supplied function, with the field names of the responses."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)

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

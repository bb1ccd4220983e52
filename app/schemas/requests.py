"""Validates input of command line and HTTP API other than audio and plain text, and converts it to option values."""

import json
import re
from collections.abc import Sequence
from pathlib import PurePath
from typing import Annotated, Any, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from ..analysis import Options, Timings
from ..bml.markup.documents import DialectName, TimeForm
from ..bml.writing.writer import BmlForm
from ..errors import InputError, UndecodableError, UnsupportedFormatError
from ..model import Level, Mode
from .references import ReferenceForm

MOST_LISTENERS = 16
_LISTENER = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,63}", re.ASCII)

LARGEST_SEED = 2**63 - 1

Seed = Annotated[int, Field(ge=-LARGEST_SEED, le=LARGEST_SEED)]
Checked = TypeVar("Checked", bound=BaseModel)


class PerformOptions(BaseModel):
    """The part `options` of a request, with the names of the command line's options."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)

    character: str = "default"
    agitation: Level | None = None
    seed: Seed = 0
    reference: ReferenceForm | None = None
    mode: Annotated[Mode, Field(strict=False)] = Mode.SEMANTIC
    listener: Annotated[tuple[str, ...], Field(strict=False)] = ()
    dialect: Annotated[DialectName, Field(strict=False)] = DialectName.BML
    timing: Annotated[TimeForm, Field(strict=False)] = TimeForm.ABSOLUTE
    lead_in_s: float = 0.0
    stillness: float = 0.0

    def to_options(self) -> Options:
        return Options(
            character=self.character,
            agitation=self.agitation,
            seed=self.seed,
            reference=self.reference.to_reference() if self.reference else None,
            mode=self.mode,
            listeners=listener_names(self.listener),
            form=BmlForm(self.dialect, self.timing),
            lead_in_s=self.lead_in_s,
            stillness=self.stillness,
        )


class RealizeOptions(BaseModel):
    """The part `options` of a request for motion, with the names of the command line's options."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)

    agitation: Level | None = None
    character: str | None = None
    fps: Literal[30, 60] = 60
    seed: Seed = 0
    skeleton: str | None = None
    stillness: float = 0.0


class FunctionsRequest(BaseModel):
    """A text to analyse; other keys are ignored."""

    model_config = ConfigDict(frozen=True, strict=True)

    id: str | int | None = None
    text: str


def read_options(content: bytes) -> Options:
    """The options of a request.

    Raises UndecodableError `not_json`, InputError `not_an_object`, `value_wrong` with the option's name in `field`.
    """
    return check_options(read_object(content, "options"))


def check_options(fields: dict[str, Any]) -> Options:
    """The options in `fields`, with the names of a request's options; raises InputError as `read_options` does."""
    return _checked(PerformOptions, _with_level(fields)).to_options()


def read_realize_options(content: bytes) -> RealizeOptions:
    """The options of a request for motion; raises as `read_options` does."""
    return check_realize_options(read_object(content, "options"))


def check_realize_options(fields: dict[str, Any]) -> RealizeOptions:
    """The options for motion in `fields`; raises InputError as `read_options` does."""
    return _checked(RealizeOptions, _with_level(fields))


def _with_level(fields: dict[str, Any]) -> dict[str, Any]:
    """The fields, with the name of the agitation replaced by its value."""
    level = fields.get("agitation")
    return fields | {"agitation": _level(level)} if isinstance(level, str) else fields


def listener_names(names: Sequence[str]) -> tuple[str, ...]:
    """The validated names of listeners, which are used as file names and as BML character ids.

    Raises InputError `value_wrong` for an invalid or repeated name, or more than `MOST_LISTENERS`.
    """
    for number, name in enumerate(names):
        if not _LISTENER.fullmatch(name):
            message = f"listener {name!r}: a name has letters, digits and _, a letter first, 64 at most"
            raise InputError("value_wrong", message, field="listener")
        if name in names[:number]:
            raise InputError("value_wrong", f"listener {name!r} comes twice; name each once", field="listener")
    if len(names) > MOST_LISTENERS:
        raise InputError("value_wrong", f"{len(names)} listeners; {MOST_LISTENERS} at most", field="listener")
    return tuple(names)


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
        value = json.loads(content)
        json.dumps(value, ensure_ascii=False).encode()
    except UnicodeEncodeError as error:
        message = f"{field} holds the lone surrogate {error.object[error.start]!a}; send well-formed Unicode"
        raise InputError("text_surrogate", message, field=field) from None
    except (ValueError, RecursionError) as error:
        raise UndecodableError("not_json", f"{field} is not JSON: {error}", field=field) from None
    return value


def read_request(fields: dict[str, Any]) -> FunctionsRequest:
    """The validated request. Raises InputError `value_wrong` with the key's name in `field`."""
    return _checked(FunctionsRequest, fields)


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
            f"words in time are read from .json, .TextGrid or .ctm, not from {file_name!r}",
            field="words",
        )
    return Timings(content=content, format=ending)


def _level(name: str) -> Level | str:
    return Level(name) if name in set(Level) else name


def _checked(model: type[Checked], fields: dict[str, Any]) -> Checked:
    try:
        return model.model_validate(fields)
    except ValidationError as error:
        found = error.errors()[0]
    name = str(found["loc"][0])
    raise InputError("value_wrong", f"{name}: {found['msg'][0].lower()}{found['msg'][1:]}", field=name)

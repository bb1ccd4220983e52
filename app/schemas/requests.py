"""Validates input of command line and HTTP API other than audio and plain text, and converts it to option values."""

import json
import re
from collections.abc import Sequence
from functools import partial
from pathlib import PurePath
from typing import Annotated, Any, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError
from pydantic_core import ErrorDetails

from ..acoustic.affect.given import affect_track
from ..errors import LONGEST_SHOWN, InputError, UndecodableError, UnsupportedFormatError, shown
from ..model import Level, Mode, Timings
from ..model.formats.bml_form import BmlForm, DialectName, TimeForm, VisemeNames
from ..model.formats.motion_formats import FileOptions, Keys
from ..model.lead_in import LONGEST_LEAD_IN_S
from ..model.targets import MOST_TARGETS, NAME, targets_of
from ..options import Options
from ..suggestions import did_you_mean
from .references import ReferenceForm

MOST_LISTENERS = 16
_LISTENER = re.compile(r"[^\W\d_]\w{0,63}")
"""Letters of any language, as names have them."""
_ALLOWED = re.compile(r"'([^']*)'")

LARGEST_SEED = 2**63 - 1

Seed = Annotated[
    int, Field(ge=-LARGEST_SEED, le=LARGEST_SEED, description="Another number chooses other movements.", examples=[7])
]
Stillness = Annotated[
    float,
    Field(
        description="Reduces movement; at 1 only breath, blinks and lips are left.",
        json_schema_extra={"minimum": 0, "maximum": 1},
    ),
]
AgitationName = Annotated[
    Annotated[Level, Field(strict=False)] | None, Field(description="Omitted or null: as measured in the voice.")
]
AffectValue = Annotated[
    str
    | Annotated[tuple[float, float, float], Field(strict=False)]
    | Annotated[tuple[Annotated[tuple[float, float, float, float], Field(strict=False)], ...], Field(strict=False)]
    | None,
    Field(
        description="How the voice sounds instead of as heard: a tone, [activation, valence, dominance] from -1 to 1, "
        "or a track of [time_s, activation, valence, dominance]. Omitted or null: as heard.",
        examples=["sad", [0.6, -0.5, 0.3]],
    ),
]
ListenerNames = Annotated[
    tuple[str, ...],
    Field(
        strict=False,
        description="The listeners, each with BML of their own; in JSON responses only.",
        json_schema_extra={
            "maxItems": MOST_LISTENERS,
            "items": {"type": "string", "pattern": f"^{_LISTENER.pattern}$"},
        },
    ),
]
Positions = Annotated[
    dict[str, Annotated[tuple[float, float, float], Field(strict=False)]],
    Field(
        description="Positions of things and listeners, to look and point at: metres, Y up, the character at 0, 0, 0, "
        "facing +Z, its left +X.",
        examples=[{"door": [1.2, 1.4, 2.0]}],
        json_schema_extra={
            "maxProperties": MOST_TARGETS,
            "propertyNames": {"pattern": f"^{NAME.pattern}$"},
        },
    ),
]
Checked = TypeVar("Checked", bound=BaseModel)

MOST_WRONG = 5
"""Parts of a request about which an error tells what is wrong."""


class PerformOptions(BaseModel):
    """How a line is performed, with the names of the command line's options."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)

    character: Annotated[str, Field(description="One of `GET /characters`.", examples=["reserved"])] = "default"
    agitation: AgitationName = None
    seed: Seed = 0
    choice: Annotated[
        Literal["terms", "priority"] | None,
        Field(description="`terms`: the one choice, `priority`: the paper's; null: as character or service say."),
    ] = None
    reference: Annotated[ReferenceForm | None, Field(description="What `understudy reference` writes.")] = None
    mode: Annotated[Mode, Field(strict=False, description="Gestures from the meaning, the stress, or chance.")] = (
        Mode.SEMANTIC
    )
    listener: ListenerNames = ()
    dialect: Annotated[DialectName, Field(strict=False, description="BML 1.0 core, or SmartBody's.")] = DialectName.BML
    timing: Annotated[
        TimeForm, Field(strict=False, description="Times in seconds, or as sync points of the speech.")
    ] = TimeForm.ABSOLUTE
    visemes: Annotated[VisemeNames, Field(strict=False, description="The names of visemes for SmartBody.")] = (
        VisemeNames.SMARTBODY
    )
    bmlt_audio: Annotated[
        bool, Field(description="Adds to BML 1.0 an element with which ASAP plays the recording; others refuse it.")
    ] = False
    lead_in_s: Annotated[
        float,
        Field(
            description="How long before the recording the performance begins, seconds.",
            json_schema_extra={"minimum": 0, "maximum": LONGEST_LEAD_IN_S},
        ),
    ] = 0.0
    stillness: Stillness = 0.0
    targets: Positions = {}
    profile: Annotated[str | None, Field(description="The name of a gesture profile.", examples=["sweeping"])] = None
    contours: Annotated[bool, Field(description="Adds f0 and energy every 10 ms to JSON.")] = False
    affect: AffectValue = None

    def to_options(self) -> Options:
        return Options(
            character=self.character,
            agitation=self.agitation,
            affect=None if self.affect is None else affect_track(self.affect),
            seed=self.seed,
            choice=self.choice,
            reference=self.reference.to_reference() if self.reference else None,
            mode=self.mode,
            listeners=listener_names(self.listener),
            form=BmlForm(self.dialect, self.timing, bmlt_audio=self.bmlt_audio, visemes=self.visemes),
            lead_in_s=self.lead_in_s,
            stillness=self.stillness,
            targets=targets_of(self.targets),
            profile=self.profile,
            contours=self.contours,
        )


class RealizeOptions(BaseModel):
    """How BML is played, with the names of the command line's options."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)

    agitation: AgitationName = None
    character: Annotated[str | None, Field(description="Omitted or null: the one named in the BML.")] = None
    fps: Annotated[Literal[30, 60], Field(description="Frames per second.")] = 60
    seed: Annotated[Seed | None, Field(description="Omitted or null: that of the performance, or 0.")] = None
    skeleton: Annotated[
        str | None, Field(description="The rig whose joint names are used.", examples=["mixamo", "vrm"])
    ] = None
    stillness: Stillness = 0.0
    targets: Positions = {}
    tail_s: Annotated[float, Field(description="Seconds of motion after the recording, at most 10.")] = 0.0
    physics: Annotated[
        bool | None,
        Field(description="Whether the body has mass: arms swing, wrists overshoot. Null: the service's setting."),
    ] = None
    t_pose: Annotated[bool, Field(description="Whether BVH begins with a frame in the T-pose.")] = False
    root_at_origin: Annotated[
        bool, Field(description="Whether the root's OFFSET in BVH is zero, for readers that add it, such as three.js.")
    ] = False
    keys: Annotated[
        Keys,
        Field(strict=False, description="Keys in GLB: one in every frame, or few that can be edited, with markers."),
    ] = Keys.BAKED

    @property
    def files(self) -> FileOptions:
        """The options of file formats."""
        return FileOptions(self.t_pose, self.root_at_origin, self.keys)


class FunctionsRequest(BaseModel):
    """A text to analyse; other keys are ignored."""

    model_config = ConfigDict(frozen=True, strict=True)

    id: Annotated[str | int | None, Field(description="Returned as sent.")] = None
    text: Annotated[
        str,
        Field(
            description="The words.",
            examples=["No, I have never seen those."],
            json_schema_extra={"minLength": 1},
        ),
    ]


def read_options(content: bytes) -> Options:
    """The options of a request.

    Raises UndecodableError `not_json`, InputError `not_an_object`, `value_wrong` with the option's name in `field`.
    """
    return check_options(read_object(content, "options"))


def check_options(fields: dict[str, Any]) -> Options:
    """The options in `fields`, with the names of a request's options; raises InputError as `read_options` does."""
    return checked(PerformOptions, fields).to_options()


def read_realize_options(content: bytes) -> RealizeOptions:
    """The options of a request for motion; raises as `read_options` does."""
    return check_realize_options(read_object(content, "options"))


def check_realize_options(fields: dict[str, Any]) -> RealizeOptions:
    """The options for motion in `fields`; raises InputError as `read_options` does."""
    return checked(RealizeOptions, fields)


def listener_names(names: Sequence[str]) -> tuple[str, ...]:
    """The validated names of listeners, which are used in file names and as targets in BML.

    Raises InputError `value_wrong` for an invalid or repeated name, or more than `MOST_LISTENERS`.
    """
    if len(names) > MOST_LISTENERS:
        raise InputError("value_wrong", f"{len(names)} listeners; {MOST_LISTENERS} at most", field="listener")
    for number, name in enumerate(names):
        if not _LISTENER.fullmatch(name):
            message = f"listener {shown(name)}: a name has letters, digits and _, a letter first, 64 at most"
            raise InputError("value_wrong", message, field="listener")
        if name in names[:number]:
            raise InputError("value_wrong", f"listener {name!r} comes twice; name each once", field="listener")
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
        value = json.loads(content, object_pairs_hook=partial(_once, field))
        json.dumps(value, ensure_ascii=False).encode()
    except UnicodeEncodeError as error:
        message = f"{field} holds the lone surrogate {error.object[error.start]!a}; send well-formed Unicode"
        raise InputError("text_surrogate", message, field=field) from None
    except (ValueError, RecursionError) as error:
        raise UndecodableError("not_json", f"{field} is not JSON: {error}", field=field) from None
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
            f"words in time are read from .json, .TextGrid or .ctm, not from {shown(file_name)}",
            field="words",
        )
    return Timings(content=content, format=ending)


def checked(model: type[Checked], fields: dict[str, Any]) -> Checked:
    """The fields as `model`; raises InputError `value_wrong` with all parts that are wrong, the first as `field`."""
    try:
        return model.model_validate(fields)
    except ValidationError as error:
        found = error.errors()
    told = [f"{'.'.join(_where(each)) or repr('')}: {_reason(each, model)}" for each in found[:MOST_WRONG]]
    more = [f"and {len(found) - MOST_WRONG} more"] if len(found) > MOST_WRONG else []
    raise InputError("value_wrong", "; ".join((*told, *more)), field=_where(found[0])[0])


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

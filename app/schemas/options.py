"""The options of a performance and of a motion as JSON objects, checked and converted to values.

Names, ranges, defaults and descriptions are those of `option_table.py`; here they get types.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError, ValidatorFunctionWrapHandler, WrapValidator
from pydantic.config import JsonDict
from pydantic_core import PydanticCustomError

from ..errors import InputError, shown
from ..model import Level, Mode
from ..model.formats import BapVersion, BmlForm, DialectName, FileOptions, Keys, TimeForm, VisemeNames
from ..model.targets import MOST_TARGETS, NAME, targets_of
from ..option_table import LARGEST_SEED, MOST_LISTENERS, MOTION, PERFORMANCE, Option
from ..options import Options
from .affect import AFFECT_FORMS, affect_track
from .references import ReferenceForm
from .requests import checked, read_object

_LISTENER = re.compile(r"[^\W\d_]\w{0,63}(=\w{1,64})?")
"""Letters of any language, as names have them; after = the character that the listener moves as."""

Seed = Annotated[int, Field(ge=-LARGEST_SEED, le=LARGEST_SEED)]
LevelName = Annotated[Level, Field(strict=False)]
ModeName = Annotated[Mode, Field(strict=False)]


def _in_a_form_of_affect(given: object, read: ValidatorFunctionWrapHandler) -> object:
    """What `read` makes of it; where it has none of the forms, an error that names them instead of one for each."""
    try:
        return read(given)
    except ValidationError as error:
        raise PydanticCustomError("affect_wrong", f"give {AFFECT_FORMS}") from error


AffectValue = Annotated[
    str
    | Annotated[tuple[float, float, float], Field(strict=False)]
    | Annotated[tuple[Annotated[tuple[float, float, float, float], Field(strict=False)], ...], Field(strict=False)],
    WrapValidator(_in_a_form_of_affect),
]
ListenerNames = Annotated[
    tuple[str, ...],
    Field(
        strict=False,
        json_schema_extra={
            "maxItems": MOST_LISTENERS,
            "items": {"type": "string", "pattern": f"^{_LISTENER.pattern}$"},
        },
    ),
]
Positions = Annotated[
    dict[str, Annotated[tuple[float, float, float], Field(strict=False)]],
    Field(json_schema_extra={"maxProperties": MOST_TARGETS, "propertyNames": {"pattern": f"^{NAME.pattern}$"}}),
]


def field_of(option: Option) -> Any:  # noqa: ANN401 - what pydantic's own Field returns
    """The field of a request for an option: its default, description, examples and range, which is checked where it is
    used, so that the message is the same at every door."""
    limits: JsonDict = {}
    if option.limits and option.kind is float:
        limits = {"minimum": option.limits[0], "maximum": option.limits[1]}
    return Field(
        default=dict(option.default) if isinstance(option.default, Mapping) else option.default,
        description=option.told_in_request(),
        examples=list(option.examples) or None,
        json_schema_extra=limits or None,
    )


class PerformOptions(BaseModel):
    """How a line is performed, with the names of the command line's options."""

    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", strict=True)

    character: str = field_of(PERFORMANCE["character"])
    agitation: LevelName | None = field_of(PERFORMANCE["agitation"])
    seed: Seed = field_of(PERFORMANCE["seed"])
    choice: Literal["terms", "priority"] | None = field_of(PERFORMANCE["choice"])
    reference: ReferenceForm | None = field_of(PERFORMANCE["reference"])
    mode: ModeName = field_of(PERFORMANCE["mode"])
    listener: ListenerNames = field_of(PERFORMANCE["listener"])
    dialect: Annotated[DialectName, Field(strict=False)] = field_of(PERFORMANCE["dialect"])
    timing: Annotated[TimeForm, Field(strict=False)] = field_of(PERFORMANCE["timing"])
    visemes: Annotated[VisemeNames, Field(strict=False)] = field_of(PERFORMANCE["visemes"])
    bmlt_audio: bool = field_of(PERFORMANCE["bmlt_audio"])
    lead_in_s: float = field_of(PERFORMANCE["lead_in_s"])
    stillness: float = field_of(PERFORMANCE["stillness"])
    targets: Positions = field_of(PERFORMANCE["targets"])
    profile: str | None = field_of(PERFORMANCE["profile"])
    contours: bool = field_of(PERFORMANCE["contours"])
    affect: AffectValue | None = field_of(PERFORMANCE["affect"])

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
            played_by=listener_characters(self.listener),
            form=BmlForm(self.dialect, self.timing, bmlt_audio=self.bmlt_audio, visemes=self.visemes),
            lead_in_s=self.lead_in_s,
            stillness=self.stillness,
            targets=targets_of(self.targets),
            profile=self.profile,
            contours=self.contours,
        )


class RealizeOptions(BaseModel):
    """How BML is played, with the names of the command line's options."""

    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", strict=True)

    agitation: LevelName | None = field_of(MOTION["agitation"])
    character: str | None = field_of(MOTION["character"])
    fps: Literal[30, 60] = field_of(MOTION["fps"])
    seed: Seed | None = field_of(MOTION["seed"])
    skeleton: str | None = field_of(MOTION["skeleton"])
    stillness: float = field_of(MOTION["stillness"])
    targets: Positions = field_of(MOTION["targets"])
    tail_s: float = field_of(MOTION["tail_s"])
    physics: bool | None = field_of(MOTION["physics"])
    t_pose: bool = field_of(MOTION["t_pose"])
    root_at_origin: bool = field_of(MOTION["root_at_origin"])
    keys: Annotated[Keys, Field(strict=False)] = field_of(MOTION["keys"])
    bap_version: Annotated[BapVersion, Field(strict=False)] = field_of(MOTION["bap_version"])

    @property
    def files(self) -> FileOptions:
        """The options of file formats."""
        return FileOptions(self.t_pose, self.root_at_origin, self.keys, bap=self.bap_version)


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
    """The validated names of listeners (`NAME` or `NAME=CHARACTER`), which are used in file names and as targets in
    BML.

    Raises InputError `value_wrong` for an invalid or repeated name, or more than `MOST_LISTENERS`.
    """
    if len(names) > MOST_LISTENERS:
        raise InputError("value_wrong", f"{len(names)} listeners; {MOST_LISTENERS} at most", field="listener")
    found: list[str] = []
    for written in names:
        if not _LISTENER.fullmatch(written):
            message = f"listener {shown(written)}: a name has letters, digits and _, a letter first, 64 at most"
            raise InputError("value_wrong", message, field="listener")
        name = written.partition("=")[0]
        if name in found:
            raise InputError("value_wrong", f"listener {name!r} comes twice; name each once", field="listener")
        found.append(name)
    return tuple(found)


def listener_characters(names: Sequence[str]) -> tuple[tuple[str, str], ...]:
    """The characters that listeners move as, by name, where they are given as `NAME=CHARACTER`."""
    parts = (written.partition("=") for written in names)
    return tuple((name, character) for name, equals, character in parts if equals)

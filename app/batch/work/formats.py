"""The output formats of a line: the schedule in several formats, or the motion in any of its formats."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from pathlib import PurePosixPath

from ...errors import InputError, did_you_mean
from ...library.motion_checks import require_writer
from ...model.formats import PICTURES, MotionFormat
from ...settings import Settings


class LineFormat(StrEnum):
    """The formats that need no motion, by file extension."""

    BML = "bml"
    BML_JSON = "bml.json"
    PERFORMANCE = "json"
    TEXTGRID = "TextGrid"
    CTM = "ctm"
    WAV = "wav"


OutputFormat = LineFormat | MotionFormat

_ACT = ".xml"
_CLIP = "clip.json"
"""The motion as JSON, as distinct from the performance as JSON."""
_TIERS = "tiers.TextGrid"
"""Functions and behaviours as tiers, as distinct from words and phones alone."""


def extension_of(form: OutputFormat) -> str:
    """The extension of a format's files, without the dot; also the format's name."""
    if form is MotionFormat.JSON:
        return _CLIP
    if form is MotionFormat.TEXTGRID:
        return _TIERS
    return form.value.removeprefix(".")


FORMATS = (*LineFormat, *(form for form in MotionFormat if extension_of(form) not in set(LineFormat)))


def formats_named(names: Sequence[str]) -> tuple[OutputFormat, ...]:
    """The formats of `--format` without duplicates; BML if none is named. Raises InputError `format_unknown`."""
    by_name = {extension_of(form).casefold(): form for form in FORMATS}
    found = []
    for name in names or [LineFormat.BML]:
        form = by_name.get(name.removeprefix(".").casefold())
        if form is None:
            listed = ", ".join(extension_of(each) for each in FORMATS)
            message = f"--format {name}: give one of {listed}{did_you_mean(name, by_name)}"
            raise InputError("format_unknown", message, field="format")
        found.append(form)
    return tuple(dict.fromkeys(found))


def needs_motion(formats: Sequence[OutputFormat]) -> bool:
    return any(isinstance(form, MotionFormat) for form in formats)


def needs_pictures(formats: Sequence[OutputFormat]) -> bool:
    return any(form in PICTURES for form in formats)


def require_writers(formats: Sequence[OutputFormat], settings: Settings) -> None:
    """Raises ServiceError where something that a format needs is not installed."""
    for form in formats:
        if isinstance(form, MotionFormat):
            require_writer(form, settings.blender)


def act_path(path: str) -> str:
    """The path of SmartBody's act, given `path`, that of the file beside its recording, which has to end in .bml."""
    return f"{path.removesuffix('.bml')}{_ACT}"


def recording_name(path: str) -> str:
    """The name of the recording whose words and visemes are in the file at `path`."""
    return f"{PurePosixPath(path).name.removesuffix('.bml')}.wav"


def beside(path: str, listener: str, form: OutputFormat) -> str:
    """The path of a listener's file: `OUT.NAME.bml` for `OUT.bml`."""
    ending = _ACT if path.endswith(_ACT) else f".{extension_of(form)}"
    return f"{path.removesuffix(ending)}.{listener}{ending}"

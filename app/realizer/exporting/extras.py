"""Whether what a format needs beside our own code is there, before any work is done."""

from importlib.util import find_spec

from ...errors import ServiceError
from ...model.formats import SCENES, MotionFormat
from .fbx import blender_command


def require_writer(form: MotionFormat, blender: str | None = None) -> None:
    """Raises ServiceError `usd_missing` and `blender_missing`."""
    if form in SCENES:
        require_usd()
    if form is MotionFormat.FBX:
        blender_command(blender)


def require_usd() -> None:
    """Raises ServiceError `usd_missing`."""
    if find_spec("pxr") is None:
        raise ServiceError("usd_missing", "USD needs usd-core, which is not installed: pip install '.[usd]'")

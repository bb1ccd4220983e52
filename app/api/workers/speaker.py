"""The form's part `reference`: how the speaker usually sounds, stored or recorded."""

from dataclasses import replace
from pathlib import PurePath

from ...errors import InputError
from ...library.hearing import make_reference
from ...models import Understudy
from ...options import Options
from ...schemas.references import read_reference
from .form import Part


def with_reference(options: Options, part: Part | None, understudy: Understudy) -> Options:
    """The options with the speaker's reference that the part holds: the file of `understudy reference`, if its name
    ends in .json, else a recording of the speaker, which is heard here.

    Raises InputError `field_repeated` where the options have one already, `reference_unreadable`, and as `hear` does.
    """
    if part is None:
        return options
    if options.reference is not None:
        message = "the speaker's reference came in options and as a file; send one of them"
        raise InputError("field_repeated", message, field="reference")
    name = part.file_name or ""
    if PurePath(name).suffix.lower() == ".json":
        return replace(options, reference=read_reference(part.content, name))
    try:
        reference = make_reference(understudy, [part.content])
    except InputError as error:
        raise type(error)(error.code, f"reference: {error.message}", field="reference") from None
    return replace(options, reference=reference)

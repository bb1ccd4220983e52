"""The parts of a form that describe the speaker: `reference`, how the voice usually sounds, stored or recorded, and
`profile`, a gesture profile's file.
"""

from dataclasses import replace
from pathlib import PurePath

from ...errors import AuthoringError, InputError
from ...library.hearing import make_reference
from ...models import Understudy, load_tags
from ...options import Options
from ...profiles.files.reading import read_profile_text
from ...schemas.references import read_reference
from .form import FormPart

FIELD = "profile"


def with_reference(options: Options, part: FormPart | None, understudy: Understudy) -> Options:
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


def with_profile(options: Options, part: FormPart | None, understudy: Understudy) -> Options:
    """The options with the gesture profile that the part holds, as YAML; its name is that of the file.

    Raises InputError `field_repeated` where the options name one already, `profile_wrong`, and UndecodableError
    `text_not_utf8`.
    """
    if part is None:
        return options
    if options.profile is not None:
        message = "a profile was named in options and came as a file; send one of them"
        raise InputError("field_repeated", message, field=FIELD)
    name = PurePath(part.file_name or FIELD).stem
    try:
        profile = read_profile_text(part.text, name, understudy.behavior.characters.gesture_lexemes, load_tags())
    except AuthoringError as error:
        told = "; ".join(f"line {each.line}, column {each.column}: {each.message}" for each in error.mistakes)
        raise InputError("profile_wrong", f"{name}.yaml: {told}", field=FIELD) from None
    return replace(options, profile=profile)

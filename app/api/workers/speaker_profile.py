"""The form's part `profile`: a gesture profile's file, where the service has none of that name."""

from dataclasses import replace
from pathlib import PurePath

from ...errors import AuthoringError, InputError
from ...models import Understudy, load_tags
from ...options import Options
from ...profiles.files.reading import read_profile_text
from .form import Part

FIELD = "profile"


def with_profile(options: Options, part: Part | None, understudy: Understudy) -> Options:
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

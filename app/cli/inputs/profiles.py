"""Gesture profiles as the command line names them: by name in the lexicon, or as a file."""

from pathlib import Path

from ...loading import load_characters, load_profile, load_profile_file
from ...profiles.profile import Profile

SUFFIX = ".yaml"


def named_profile(name: str) -> Profile:
    """The profile of that name, or in the file of that name, which ends in .yaml.

    Raises InputError `unknown_profile`, and AuthoringError with every mistake in its file.
    """
    lexemes = load_characters().gesture_lexemes
    return load_profile_file(Path(name), lexemes) if name.endswith(SUFFIX) else load_profile(name, lexemes)

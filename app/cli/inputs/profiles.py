"""Gesture profiles on the command line: by name in the lexicon, or as a file that ends in .yaml."""

from ...models import load_characters, load_profile, usable_profile
from ...profiles.profile import Profile


def named_profile(name: str) -> Profile:
    """The profile of that name, or in the file of that name.

    Raises InputError `unknown_profile`, and AuthoringError with every mistake in its file.
    """
    found = usable_profile(name)
    return load_profile(found, load_characters().gesture_lexemes) if isinstance(found, str) else found


def optional_profile(name: str | None) -> Profile | str | None:
    """The profile named by an option, None if it is not given; raises as `named_profile` does."""
    return None if name is None else usable_profile(name)

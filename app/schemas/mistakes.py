"""Formats the mistakes in a JSON value for people: each with its place, cut after the first few."""

from pydantic import ValidationError

from ..errors import LONGEST_SHOWN

_OURS = "Value error, "
"""The prefix that pydantic puts before our messages."""


def mistakes_told(error: ValidationError, *, most: int) -> str:
    """The first `most` mistakes, and how many more there are."""
    found = error.errors(include_url=False)
    told = "; ".join(_told(tuple(each["loc"]), each["msg"].removeprefix(_OURS)) for each in found[:most])
    return f"{told}; and {len(found) - most} more" if len(found) > most else told


def _told(location: tuple[int | str, ...], message: str) -> str:
    """A mistake with its place, such as `moments[2].stroke`."""
    parts = (f"[{part}]" if isinstance(part, int) else f".{part[:LONGEST_SHOWN]}" for part in location)
    where = "".join(parts).removeprefix(".")
    return f"{where}: {message[0].lower()}{message[1:]}"

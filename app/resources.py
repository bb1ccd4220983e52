"""Finds the files that belong to the code: in a checkout they are beside the package, in a wheel inside it."""

from pathlib import Path

from .errors import ServiceError

_PACKAGE = Path(__file__).resolve().parent

RULES = _PACKAGE / "rules"
"""The rule files, which are inside the package."""


def resource_folder(name: str) -> Path:
    """The folder `name` ("lexicon", "models", "examples"), wherever the package is installed.

    Raises ServiceError with code `installation_incomplete` when it is in neither place.
    """
    for parent in (_PACKAGE, _PACKAGE.parent):
        if (parent / name).is_dir():
            return parent / name
    raise ServiceError(
        "installation_incomplete", f"the folder {name!r} is missing beside {_PACKAGE}; reinstall understudy"
    )

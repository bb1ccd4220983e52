"""The callback by which work reports its progress."""

from collections.abc import Callable

Progress = Callable[[str], None]
"""Called with the name of each stage as it begins."""


def no_progress(_stage: str) -> None:
    """Ignores progress."""

"""How work tells at what stage it is."""

from collections.abc import Callable

Progress = Callable[[str], None]
"""Told the name of each stage as it begins."""


def no_progress(_stage: str) -> None:
    """The progress of work that nobody watches."""

"""Who is told how a batch goes on."""

from typing import Protocol

from .manifest.entries import Entry
from .planning import Plan


class Watcher(Protocol):
    """Who is told how a batch goes on."""

    def planned(self, plan: Plan) -> None:
        """The script was read and its lines have their recordings."""

    def learning(self, voices: int) -> None:
        """The voices of so many speakers are learnt first."""

    def begun(self, entries: int, done: int) -> None:
        """So many lines can be performed, and so many of them are done already."""

    def ended(self, entry: Entry) -> None:
        """A line is done, or failed."""


class Nobody:
    """Nobody is told."""

    def planned(self, plan: Plan) -> None:
        pass

    def learning(self, voices: int) -> None:
        pass

    def begun(self, entries: int, done: int) -> None:
        pass

    def ended(self, entry: Entry) -> None:
        pass

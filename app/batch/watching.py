"""The interface by which a batch reports its progress."""

from typing import Protocol

from .manifest.entries import Entry
from .planning import Plan


class Watcher(Protocol):
    """Is notified of a batch's progress."""

    def planned(self, plan: Plan) -> None:
        """The script has been read and its lines matched with recordings."""

    def learning(self, voices: int) -> None:
        """So many voices are about to be learnt."""

    def begun(self, entries: int, done: int) -> None:
        """So many lines can be performed, and so many of them are done already."""

    def ended(self, entry: Entry) -> None:
        """A line is done, or has failed."""


class Nobody:
    """Ignores all notifications."""

    def planned(self, plan: Plan) -> None:
        pass

    def learning(self, voices: int) -> None:
        pass

    def begun(self, entries: int, done: int) -> None:
        pass

    def ended(self, entry: Entry) -> None:
        pass

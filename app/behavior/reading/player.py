"""Who plays a line, for the plan and its candidates: the character's behaviours, what it never does, how much it does,
and which take it is."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from ...model import Channel
from .families import Families, Playable


@dataclass(frozen=True, slots=True)
class Ban:
    """The behaviours `names` never come on words `first` to `last`, for the reason `why`."""

    first: int
    last: int
    names: frozenset[str]
    why: str

    def covers(self, first: int, last: int) -> bool:
        """Whether a movement over these words touches it."""
        return self.first <= last and first <= self.last


@dataclass(frozen=True, slots=True)
class Player:
    """The families of behaviours, the character's table by name, the seed of the take, how much is played (1 is as much
    as directors want, 0 nothing), and what is forbidden where."""

    families: Families
    behaviors: Mapping[str, Playable]
    seed: int = 0
    quantity: float = 1.0
    bans: tuple[Ban, ...] = ()

    def banned(self, name: str, first: int, last: int) -> Ban | None:
        """What forbids a behaviour over these words, if anything does."""
        return next((ban for ban in self.bans if name in ban.names and ban.covers(first, last)), None)

    def lexemes(self) -> frozenset[str]:
        """The lexemes of its gestures."""
        return frozenset(each.lexeme for each in self.behaviors.values() if each.channel is Channel.GESTURE)

    def banned_lexemes(self) -> Iterator[tuple[Ban, frozenset[str]]]:
        """The gesture lexemes that each ban leaves no behaviour for."""
        for ban in self.bans:
            free = self._gestures(name for name in self.behaviors if name not in ban.names)
            yield ban, self._gestures(ban.names) - free

    def _gestures(self, names: Iterable[str]) -> frozenset[str]:
        entries = (self.behaviors[name] for name in names)
        return frozenset(each.lexeme for each in entries if each.channel is Channel.GESTURE)

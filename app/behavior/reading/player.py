"""Who plays a line, for the plan and its candidates: the character's behaviours, what it never does, how much it does,
and which take it is."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

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


def banned(bans: Iterable[Ban], name: str, first: int, last: int) -> Ban | None:
    """What forbids a behaviour over these words, if anything does."""
    return next((ban for ban in bans if name in ban.names and ban.covers(first, last)), None)


@dataclass(frozen=True, slots=True)
class Player:
    """The families of behaviours, the character's table by name, the seed of the take, how much is played (1 is as much
    as directors want, 0 nothing) and by how much agitation multiplies the gestures of that, what is forbidden where,
    and the lexemes that some behaviours stand for."""

    families: Families
    behaviors: Mapping[str, Playable]
    seed: int = 0
    quantity: float = 1.0
    by_agitation: float = 1.0
    bans: tuple[Ban, ...] = ()
    stands_for: Mapping[str, str] = field(default_factory=dict)

    def lexeme(self, name: str) -> str:
        """What a behaviour is worth: its lexeme, or the one in whose place the character shows it."""
        return self.stands_for.get(name, self.behaviors[name].lexeme)

    def banned(self, name: str, first: int, last: int) -> Ban | None:
        """What forbids a behaviour over these words, if anything does."""
        return banned(self.bans, name, first, last)

    def banned_lexemes(self) -> Iterator[tuple[Ban, frozenset[str]]]:
        """The gesture lexemes that each ban leaves no behaviour for."""
        for ban in self.bans:
            free = self._gestures(name for name in self.behaviors if name not in ban.names)
            yield ban, self._gestures(ban.names) - free

    def _gestures(self, names: Iterable[str]) -> frozenset[str]:
        return frozenset(self.lexeme(name) for name in names if self.behaviors[name].channel is Channel.GESTURE)

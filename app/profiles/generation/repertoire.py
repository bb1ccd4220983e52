"""What may be played at all, whatever a profile likes: the gestures of the behaviour table, and what a line forbids."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from ...model import Hand, Interval
from ...model.limits.gesture_limits import Forms


@dataclass(frozen=True, slots=True)
class PlayableGesture:
    """A lexeme that the table offers: its forms by the hands that may make it, how long its stroke lasts and which part
    of it lies before the emphasis, its size in [0, 1], and the lemmas of which the words around must have one (none:
    any words)."""

    forms: Mapping[Hand, Forms]
    stroke_s: float
    emphasis: float
    amount: float | None = None
    lemmas: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class ClosedWords:
    """Words `first` to `last`, on which none of `lexemes` may be made; None stands for all gestures."""

    first: int
    last: int
    lexemes: Collection[str] | None = None

    def closes(self, word: int, lexeme: str) -> bool:
        """Whether a stroke of the lexeme on the word is out."""
        return self.first <= word <= self.last and (self.lexemes is None or lexeme in self.lexemes)


@dataclass(frozen=True, slots=True)
class Repertoire:
    """The gestures by lexeme, what is closed, and when the hands are taken by other gestures."""

    gestures: Mapping[str, PlayableGesture]
    closed: tuple[ClosedWords, ...] = ()
    taken: tuple[Interval, ...] = ()

    def allows(self, lexeme: str, word: int, lemmas: Collection[str]) -> bool:
        """Whether the lexeme may be made on a word that has these lemmas about it."""
        gesture = self.gestures.get(lexeme)
        if gesture is None or any(each.closes(word, lexeme) for each in self.closed):
            return False
        return not gesture.lemmas or not gesture.lemmas.isdisjoint(lemmas)

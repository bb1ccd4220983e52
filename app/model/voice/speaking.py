"""How a line without a recording is to be spoken, by what marks in its text say."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Speaking:
    """The `emphasized` words; `pauses_s`, pauses in seconds by the word that they follow (-1: before the first), which
    replace those of punctuation; `rates`, speeds of words other than 1; `unread_tags`, names of tags that say nothing
    here."""

    emphasized: frozenset[int] = frozenset()
    pauses_s: tuple[tuple[int, float], ...] = ()
    rates: tuple[tuple[int, float], ...] = ()
    unread_tags: tuple[str, ...] = ()

    def pause_s(self, word: int, usual_s: float) -> float:
        """The pause after a word, in seconds."""
        return dict(self.pauses_s).get(word, usual_s)

    def slowness(self, word: int) -> float:
        """How much longer than usual a word lasts."""
        return 1 / dict(self.rates).get(word, 1.0)


PLAINLY_SPOKEN = Speaking()

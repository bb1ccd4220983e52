"""How a line is said, for the reading: its focus by word, its affect, its loudness.

Each is None where it is not known: without audio, or where the analysis does not measure it. A reading of the words
alone has none of them.
"""

from dataclasses import dataclass

from ..model import LineAffect, Utterance


@dataclass(frozen=True, slots=True)
class Delivery:
    """The delivery of a line: the share of each word in the focus (they sum to 1), the affect of the line and its
    phrases, and the loudness in [-1, 1]: -1 soft, 0 usual, 1 loud, by vocal effort and not by the recording's level."""

    focus: tuple[float, ...] | None = None
    affect: LineAffect | None = None
    loudness: float | None = None

    @classmethod
    def of(cls, utterance: Utterance) -> "Delivery":
        """The delivery that was measured in an utterance; all of it None for words alone."""
        shares = tuple(word.focus for word in utterance.words if word.focus is not None)
        return cls(
            focus=shares if shares and len(shares) == len(utterance.words) else None,
            affect=utterance.affect,
            loudness=_loudness(utterance),
        )


WORDS_ALONE = Delivery()


def _loudness(utterance: Utterance) -> float | None:
    """Agitation as loudness: the membership of high minus that of low."""
    return utterance.agitation.high - utterance.agitation.low if utterance.agitation else None

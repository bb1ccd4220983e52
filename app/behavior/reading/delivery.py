"""How a line is said, for the reading: its focus by word, its affect, its loudness.

Each is None where it is not known: without audio, or where the analysis does not measure it. A reading of the words
alone has none of them. Shapes: W words, H features.
"""

from dataclasses import dataclass

import numpy as np

from ...model import LineAffect, SingleArray, Tone, Utterance

NEIGHBOURS = (-2, -1, 1, 2)
"""The words around a word whose shares of the focus are features of it."""

CLEAR_FOCUS = 0.5
"""The least share of the likeliest word with which a focus is heard: a line that is said without one has its accents
all the same. Half of synthetic voices' deliveries have a word over .84, nine of ten of their plain readings none over
.5 (docs/measurements/choice.md)."""

_FOCUS, _AFFECT, _LOUDNESS = 3 + len(NEIGHBOURS), 4 + len(Tone), 2
FEATURES = _FOCUS + _AFFECT + _LOUDNESS


@dataclass(frozen=True, slots=True)
class Delivery:
    """The delivery of a line: the share of each word in the focus (they sum to 1; none where no word is clearly
    focused), the affect of the line and its
    phrases, and the loudness in [-1, 1]: -1 soft, 0 usual, 1 loud, by vocal effort and not by the recording's level."""

    focus: tuple[float, ...] | None = None
    affect: LineAffect | None = None
    loudness: float | None = None

    @classmethod
    def of(cls, utterance: Utterance) -> "Delivery":
        """The delivery that was measured in an utterance; all of it None for words alone."""
        shares = tuple(word.focus for word in utterance.words if word.focus is not None)
        return cls(
            focus=clear_focus(shares) if len(shares) == len(utterance.words) else None,
            affect=utterance.affect,
            loudness=_loudness(utterance),
        )


WORDS_ALONE = Delivery()


def clear_focus(shares: tuple[float, ...]) -> tuple[float, ...] | None:
    """The focus by word, if a word clearly has it."""
    return shares if max(shares, default=0.0) >= CLEAR_FOCUS else None


def _loudness(utterance: Utterance) -> float | None:
    """Agitation as loudness: the membership of high minus that of low."""
    return utterance.agitation.high - utterance.agitation.low if utterance.agitation else None


def features_of(delivery: Delivery, words: int) -> SingleArray:
    """What the encoder is told of each word beside its text (W, H): for the focus, the affect and the loudness in turn
    whether it is known, then its values. All values lie in [-1, 1], and those of what is not known are 0."""
    features = np.zeros((words, FEATURES), np.float32)
    if delivery.focus is not None:
        features[:, :_FOCUS] = _focus_features(np.array(delivery.focus, np.float32))
    if delivery.affect is not None:
        features[:, _FOCUS : _FOCUS + _AFFECT] = [_affect_features(delivery.affect, word) for word in range(words)]
    if delivery.loudness is not None:
        features[:, -_LOUDNESS:] = 1.0, delivery.loudness
    return features


def _focus_features(shares: SingleArray) -> SingleArray:
    """Known, the word's share, its share relative to the largest, and its neighbours' shares."""
    words, reach = len(shares), max(NEIGHBOURS)
    padded = np.pad(shares, reach)
    around = [padded[reach + shift : reach + shift + words] for shift in NEIGHBOURS]
    relative = shares / max(float(shares.max(initial=0.0)), 1e-6)
    return np.stack([np.ones_like(shares), shares, relative, *around], axis=1)


def _affect_features(affect: LineAffect, word: int) -> tuple[float, ...]:
    """Known, activation, valence, dominance and the shares of the tones in the phrase of a word."""
    heard = affect.at(word)
    return 1.0, heard.activation, heard.valence, heard.dominance, *heard.tones

"""Reads a delivery of a line in context: what each gesture family, head movement, face and gaze would be worth to a
director at each word, and how big and fast the movements would be.

A small transformer encoder (BERT architecture, Devlin et al. 2019), fine-tuned on directed lines (`training/acting`,
models/acting/README.md) and run by ONNX Runtime in eight-bit integers. The vocabulary and the names of the outputs are
in the file's metadata. What is not known of the delivery was left out at random in training, so that the words alone
can be read too. Shapes: W words, P pieces, F gesture families, H head movements, K faces, G gazes.

Of the delivery it takes focus by word, affect and loudness, each of them None where it is not known: without audio, or
where the analysis does not measure it.

Words are split into the pieces of a BERT vocabulary (uncased WordPiece): lower case, without accents, each piece the
longest that matches; a piece that continues a word begins with "##".
"""

import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from types import MappingProxyType
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...errors import ServiceError
from ...loading import OnnxSession, load_session
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


Integers: TypeAlias = NDArray[np.int64]

_KIND = "a model for directing lines"
_METADATA = ("pieces", "families", "head", "face", "gaze")

MOST_PIECES = 126
"""The most pieces between [CLS] and [SEP]; words beyond have worth 0."""


@dataclass(frozen=True, slots=True, eq=False)
class Reading:
    """What directors would want, in [0, 1]: the worth of a family with its stroke on a word (W, F) and within two words
    of it (W, F), the probability of any stroke (W,), and of head movements (W, H), faces (W, K) and gazes (W, G) on a
    word; and how big and how fast movements would be beside those of the line said neutrally, in [-1, 1]."""

    at_word: SingleArray
    nearby: SingleArray
    stroke: SingleArray
    head: SingleArray
    face: SingleArray
    gaze: SingleArray
    size: float
    speed: float


@dataclass(frozen=True, slots=True, eq=False)
class Encoder:
    """The trained network, its WordPiece vocabulary, and the names of its outputs."""

    pieces: Mapping[str, int]
    families: tuple[str, ...]
    head: tuple[str, ...]
    face: tuple[str, ...]
    gaze: tuple[str, ...]
    session: OnnxSession

    @classmethod
    def load(cls, path: Path) -> "Encoder":
        """Raises ServiceError `model_unreadable` where the file is missing or not such a model."""
        session = load_session(path, _KIND)
        named: Mapping[str, str] = session.get_modelmeta().custom_metadata_map
        missing = [name for name in _METADATA if name not in named]
        if missing:
            raise ServiceError("model_unreadable", f"{path} is not {_KIND}: it has no metadata {', '.join(missing)}")
        return cls(
            pieces=MappingProxyType({piece: number for number, piece in enumerate(named["pieces"].split("\n"))}),
            families=tuple(named["families"].split("\n")),
            head=tuple(named["head"].split("\n")),
            face=tuple(named["face"].split("\n")),
            gaze=tuple(named["gaze"].split("\n")),
            session=session,
        )

    def read(self, words: Sequence[str], delivery: Delivery = WORDS_ALONE) -> Reading:
        """The reading of a line as it is delivered; `words` are as written, with their punctuation."""
        numbers, spans = self._numbered(words)
        ends = np.array([span or (0, 0) for span in spans], np.int64).reshape(-1, 2)
        features = features_of(delivery, len(words))
        heard = np.zeros((len(numbers), features.shape[1]), np.float32)
        for span, row in zip(spans, features, strict=True):
            if span is not None:
                heard[span[0] : span[1] + 1] = row
        given: dict[str, Integers | SingleArray] = {
            "pieces": np.array(numbers, np.int64),
            "words": ends,
            "heard": heard,
        }
        (likely,) = self.session.run(["likely"], given)
        likely[[span is None for span in spans]] = 0.0
        return self._outputs(likely)

    def _numbered(self, words: Sequence[str]) -> tuple[list[int], list[tuple[int, int] | None]]:
        """The line's pieces between [CLS] and [SEP], and each word's first and last piece; None for words that do not
        fit."""
        numbers, spans = [self.pieces[FIRST]], list[tuple[int, int] | None]()
        for word in words:
            own = pieces_of(word, self.pieces)
            if len(numbers) + len(own) > MOST_PIECES + 1:
                spans.append(None)
                continue
            spans.append((len(numbers), len(numbers) + len(own) - 1))
            numbers += own
        return [*numbers, self.pieces[LAST]], spans

    def _outputs(self, likely: SingleArray) -> Reading:
        families = len(self.families)
        sizes = (families, families, 1, len(self.head), len(self.face), len(self.gaze), 2)
        at_word, nearby, stroke, head, face, gaze, manner = np.split(likely, np.cumsum(sizes)[:-1], axis=1)
        size, speed = 2 * manner.mean(axis=0) - 1 if len(likely) else (0.0, 0.0)
        return Reading(at_word, nearby, stroke[:, 0], head, face, gaze, size=float(size), speed=float(speed))


UNKNOWN, FIRST, LAST = "[UNK]", "[CLS]", "[SEP]"

LONGEST_WORD = 40
"""The most characters of a word between punctuation that are read; the rest is ignored."""


def pieces_of(word: str, numbers: Mapping[str, int]) -> list[int]:
    """The numbers of a word's pieces, at least one; what the vocabulary cannot spell becomes `UNKNOWN`."""
    pieces = [number for part in _parts(word) for number in _longest_matches(part[:LONGEST_WORD], numbers)]
    return pieces or [numbers[UNKNOWN]]


def _parts(word: str) -> Iterator[str]:
    """Runs of letters and digits; every other character stands alone."""
    decomposed = unicodedata.normalize("NFD", word.lower())
    letters = [character for character in decomposed if unicodedata.category(character) != "Mn"]
    for is_word, run in groupby(letters, str.isalnum):
        if is_word:
            yield "".join(run)
        else:
            yield from (character for character in run if not character.isspace())


def _longest_matches(part: str, numbers: Mapping[str, int]) -> list[int]:
    found: list[int] = []
    start = 0
    while start < len(part):
        prefix = "##" if start else ""
        for end in range(len(part), start, -1):
            number = numbers.get(prefix + part[start:end])
            if number is not None:
                found.append(number)
                start = end
                break
        else:
            return [numbers[UNKNOWN]]
    return found

"""Pronounces spoken tokens: by pocketsphinx's dictionary, by rule from a word in it, or by the model of graphones.

Phones are the dictionary's 39 ARPABET labels. It marks no lexical stress.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from ...errors import ServiceError
from .graphones import GraphoneModel

Phones = tuple[str, ...]

_SIBILANTS = frozenset({"S", "Z", "SH", "ZH", "CH", "JH"})
_VOICELESS = frozenset({"P", "T", "K", "F", "TH"})
_CONTRACTIONS: dict[str, Phones] = {
    "'ll": ("AH", "L"),
    "'ve": ("AH", "V"),
    "'re": ("ER",),
    "'d": ("D",),
    "n't": ("AH", "N", "T"),
}


@dataclass(frozen=True, slots=True)
class Pronunciation:
    """The alternative pronunciations of a token, the commonest first; `guessed` if predicted from the spelling
    alone."""

    variants: tuple[Phones, ...]
    guessed: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Pronouncer:
    """The dictionary and the model for words that are not in it; immutable and thread-safe."""

    dictionary: dict[str, str]
    graphones: GraphoneModel

    @classmethod
    def load(cls, dictionary: Path, graphones: Path) -> "Pronouncer":
        """Load both. Raises ServiceError if either is missing or broken."""
        return cls(read_dictionary(dictionary), GraphoneModel.load(graphones))

    def pronounce(self, token: str) -> Pronunciation | None:
        """The pronunciation of a spoken token (see `normalisation`); None if it has no letter a to z."""
        known = self._known(token) or self._known(token.strip("'"))
        if known:
            return Pronunciation(known)
        derived = next(self._derived(token), ())
        if derived:
            return Pronunciation(derived)
        letters = "".join(character for character in token if "a" <= character <= "z")
        guess = self.graphones.pronounce(letters)
        return Pronunciation((guess,), guessed=True) if guess else None

    def _known(self, token: str) -> tuple[Phones, ...]:
        return tuple(tuple(phones.split()) for phones in self.dictionary.get(token, "").splitlines())

    def _derived(self, token: str) -> Iterator[tuple[Phones, ...]]:
        """Pronunciations derived from a word in the dictionary: "goin'", "Zelda's", "droids", "who'd"."""
        if token.endswith("in'"):
            yield tuple((*phones[:-1], "N") for phones in self._known(token[:-1] + "g"))
        for contraction, ending in _CONTRACTIONS.items():
            if token.endswith(contraction):
                yield tuple(phones + ending for phones in self._known(token.removesuffix(contraction)))
        for suffix in ("'s", "s'", "s"):
            if token.endswith(suffix):
                yield tuple(with_s(phones) for phones in self._known(token.removesuffix(suffix)))


def read_dictionary(path: Path) -> dict[str, str]:
    """Words with their pronunciations, one per line, phones separated by spaces (CMU format, "read(2) R IY D").

    Raises ServiceError `model_unreadable`.
    """
    dictionary: dict[str, str] = {}
    try:
        with path.open(encoding="utf-8") as lines:
            for line in lines:
                name, _, phones = line.rstrip("\n").partition(" ")
                word = name.partition("(")[0]
                dictionary[word] = f"{dictionary[word]}\n{phones}" if word in dictionary else phones
    except (OSError, UnicodeDecodeError) as error:
        raise ServiceError("model_unreadable", f"{path} is not a pronunciation dictionary: {error}") from None
    return dictionary


def with_s(phones: Phones) -> Phones:
    """The phones of a noun's plural or possessive or a verb's third person: horses, cats, dogs."""
    if phones[-1] in _SIBILANTS:
        return (*phones, "IH", "Z")
    return (*phones, "S" if phones[-1] in _VOICELESS else "Z")

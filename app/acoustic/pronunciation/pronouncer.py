"""Pronounces spoken tokens: by pocketsphinx's dictionary, by rule from a word in it, or by the model of graphones.

Phones are the dictionary's 39 ARPABET labels. It marks no lexical stress.
"""

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Self

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

    dictionary: Mapping[str, str]
    graphones: GraphoneModel

    @classmethod
    def load(cls, dictionary: Path, graphones: Path) -> "Pronouncer":
        """Load both. Raises ServiceError if either is missing or broken."""
        return cls(Dictionary.read(dictionary), GraphoneModel.load(graphones))

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


class Dictionary(Mapping[str, str]):
    """Words with their pronunciations, one per line, phones separated by spaces, from a text in the CMU's format
    ("read(2) R IY D").

    A line of dialogue needs few of the 135,000, so they are looked up in the text, among the lines that begin with the
    same two characters and stand together. Immutable and thread-safe.
    """

    def __init__(self, text: str) -> None:
        self._text = f"\n{text}\n"
        self._places: Mapping[str, list[tuple[int, int]]] = defaultdict(list)
        for alike in _BEGIN_ALIKE.finditer(self._text):
            self._places[alike[1]].append(alike.span())

    @classmethod
    def read(cls, path: Path) -> Self:
        """Raises ServiceError `model_unreadable`."""
        try:
            return cls(path.read_text(encoding="utf-8"))
        except (OSError, UnicodeDecodeError) as error:
            raise ServiceError("model_unreadable", f"{path} is not a pronunciation dictionary: {error}") from None

    def __getitem__(self, word: str) -> str:
        found = [*self._after(f"\n{word} "), *self._after(f"\n{word}(")] if _WORD.fullmatch(word) else []
        if not found:
            raise KeyError(word)
        return "\n".join(found)

    def __iter__(self) -> Iterator[str]:
        return (line.partition(" ")[0] for line in self._text.split("\n") if line and "(" not in line)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def _after(self, beginning: str) -> Iterator[str]:
        """The phones in the lines that begin so."""
        for first, last in self._places.get(beginning[1:3], ()):
            place = self._text.find(beginning, first, last)
            while place >= 0:
                end = self._text.index("\n", place + 1)
                yield self._text[self._text.index(" ", place) + 1 : end]
                place = self._text.find(beginning, end, last)


_WORD = re.compile(r"[^\s(]+")
_BEGIN_ALIKE = re.compile(r"\n(..).*(?:\n\1.*)*")


def with_s(phones: Phones) -> Phones:
    """The phones of a noun's plural or possessive or a verb's third person: horses, cats, dogs."""
    if phones[-1] in _SIBILANTS:
        return (*phones, "IH", "Z")
    return (*phones, "S" if phones[-1] in _VOICELESS else "Z")

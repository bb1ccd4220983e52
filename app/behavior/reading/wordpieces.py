"""Splits words into the pieces of a BERT vocabulary: lower case, without accents, each piece the longest that matches.

Source: Devlin et al. 2019 (uncased WordPiece). A piece that continues a word begins with "##".
"""

import unicodedata
from collections.abc import Iterator, Mapping
from itertools import groupby

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

"""Text normalization: the spoken tokens of each word of a transcript, with numbers, abbreviations, acronyms and symbols
expanded.

A spoken token is lower case: letters, apostrophes, sometimes hyphens ("uh-huh"). A letter pronounced by its name has a
full stop ("f.", "b.", "i."), as in pocketsphinx's dictionary. Each word of the transcript has its own tokens, possibly
none ("—") or many ("1984"), so that word indices are preserved.

Ambiguous expressions (four digits may be a year) get their commoner reading.
"""

import re
import unicodedata
from collections.abc import Callable, Container, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from pydantic import Field

from ...model import Word
from ...yaml_files import Entry, Source
from . import spoken_numbers as numbers

Tokens = tuple[str, ...]

_AMOUNT = r"(?P<whole>\d{1,3}(?:,\d{3})+|\d*)(?:\.(?P<fraction>\d+))?"
_QUANTITY = re.compile(rf"(?P<sign>[-+#]?)(?P<currency>[^\w\s.,+#-]?){_AMOUNT}(?P<unit>[a-z]*|%|°)\.?", re.IGNORECASE)
_ORDINAL = re.compile(r"(\d[\d,]*)(?:st|nd|rd|th)", re.IGNORECASE)
_DECADE = re.compile(r"'?(\d{4}|\d0)'?s", re.IGNORECASE)
_TIME = re.compile(r"(\d{1,2}):([0-5]\d)([ap]\.?m\.?)?", re.IGNORECASE)
_CLOCK_UNIT = re.compile(r"[ap]\.?m\.?", re.IGNORECASE)
_FRACTION = re.compile(r"(?:(\d{1,3})&)?(\d{1,3})/(\d{1,3})")
_YEAR = re.compile(r"1[1-9]\d\d|20\d\d")
_TELEPHONE = re.compile(r"(?:\d{3}-)?\d{3}-\d{4}")
_DOTTED = re.compile(r"(?:[a-z]\.)+[a-z]?\.?|(?:[a-z]\.){2,}'?s", re.IGNORECASE)
_CAPITALS = re.compile(r"([A-Z]{2,})('?s)?")
_PIECE = re.compile(r"[A-Za-z']+|\d{1,3}(?:,\d{3})+|\d+(?:\.\d+)?|(?<=\d)-(?=\d)|[^\w\s-]")
_VULGAR_AFTER_DIGIT = re.compile(r"(?<=\d)(?=[¼-¾⅐-⅞])")
_VOWEL = re.compile(r"[AEIOUY]")

_QUOTES_AND_DASHES = str.maketrans(
    {**dict.fromkeys("‘’‛ʼ′´`", "'"), **dict.fromkeys("‐‑‒–—―−", "-"), "⁄": "/"}
    | {"ß": "ss", "æ": "ae", "œ": "oe", "ø": "o", "ł": "l", "đ": "d", "ð": "th", "þ": "th", "ı": "i"}
    | {"Æ": "Ae", "Œ": "Oe", "Ø": "O", "Ł": "L", "Đ": "D", "Ð": "Th", "Þ": "Th"}
)
_OUTSIDE = '"“”„«»()[]{}<>*_~^|\\!?¿¡,;:… '
_LONGEST_SPELLED_ACRONYM = 4

Amounts = Annotated[tuple[str, ...], Field(min_length=4, max_length=4)]


class Abbreviations(Entry):
    """The schema of `abbreviations.yaml`; comments in the file explain its sections."""

    anywhere: dict[str, str]
    after_a_name: dict[str, str]
    before_a_number: dict[str, str]
    after_a_number: dict[str, str]
    magnitudes: dict[str, str]
    currencies: dict[str, Amounts]
    exactly: dict[str, str]
    symbols: dict[str, str]


@dataclass(frozen=True, slots=True)
class _WordInContext:
    """A word of the transcript, folded and stripped of outer punctuation, with its neighbours."""

    previous: str
    word: str
    following: str
    shouted: bool


@dataclass(frozen=True, slots=True)
class Normaliser:
    """Expands words; `known` are those with an entry in the dictionary ("nasa", "uh-huh")."""

    abbreviations: Abbreviations
    known: Container[str]

    @classmethod
    def load(cls, path: Path, known: Container[str]) -> "Normaliser":
        """Load the abbreviations. Raises AuthoringError if the file is invalid."""
        return cls(Source(path).validated(Abbreviations), known)

    def spoken(self, words: tuple[Word, ...]) -> tuple[Tokens, ...]:
        """The tokens of each word."""
        return tuple(tuple(self._said(place)) for place in _places(words))

    def abbreviated(self, words: tuple[Word, ...]) -> frozenset[int]:
        """The words with a full stop that belongs to them: abbreviations ("Mr.") and initials ("J.")."""
        return frozenset(
            word.index
            for word, place in zip(words, _places(words), strict=True)
            if place.word.endswith(".") and (self._abbreviation(place) or _DOTTED.fullmatch(place.word))
        )

    def capitalized(self, words: tuple[Word, ...]) -> frozenset[int]:
        """The words in capitals that are read as words ("NOT" in "that is NOT it"), unless all of the text is."""
        return frozenset(
            word.index
            for word, place in zip(words, _places(words), strict=True)
            if not place.shouted
            and _CAPITALS.fullmatch(place.word.replace("'", ""))
            and place.word not in self.abbreviations.exactly
            and tuple(self._said(place)) == (place.word.lower(),)
        )

    def _said(self, place: _WordInContext) -> Tokens:
        short = self._abbreviation(place)
        if short is not None:
            return tuple(short.split())
        magnitude = self._magnitude_of_money(place)
        if magnitude is not None:
            return magnitude
        return self._number(place) if any(map(str.isdigit, place.word)) else self._text(place)

    def _abbreviation(self, place: _WordInContext) -> str | None:
        table, word = self.abbreviations, place.word.strip("'")
        bare, lower = word.rstrip("."), word.lower()
        if bare in table.exactly and not place.shouted:
            return table.exactly[bare]
        if place.following[:1].isdigit() and lower in table.before_a_number:
            return table.before_a_number[lower]
        if place.previous[:1].isdigit() and _key(lower, table.after_a_number):
            return _counted(table.after_a_number[_key(lower, table.after_a_number)], place.previous)
        if place.previous[:1].isupper() and not place.following[:1].isupper() and lower in table.after_a_name:
            return table.after_a_name[lower]
        key = _key(lower, table.anywhere)
        return table.anywhere[key] if key else None

    def _magnitude_of_money(self, place: _WordInContext) -> Tokens | None:
        """The second word of "$5 million", where the currency follows both."""
        magnitude = self.abbreviations.magnitudes.get(place.word.lower().rstrip("."))
        if magnitude is None or place.previous[:1] not in self.abbreviations.currencies or len(place.previous) < 2:
            return None
        return magnitude, self.abbreviations.currencies[place.previous[0]][1]

    def _number(self, place: _WordInContext) -> Tokens:
        for word in (place.word, place.word.rstrip(".")):
            for pattern, reading in _READINGS:
                if found := pattern.fullmatch(word):
                    return reading(found, place.following)
            if found := _QUANTITY.fullmatch(word):
                said = self._money(found, place.following) if found["currency"] else self._quantity(found)
                if said:
                    return (*_SIGNS[found["sign"]], *said)
        return tuple(self._pieces(place))

    def _money(self, found: re.Match[str], following: str) -> Tokens:
        """ "$5.50" and "$5bn"; empty if the sign is not a currency. In "$5 million" the next word includes the
        dollars."""
        table, unit = self.abbreviations, found["unit"].lower()
        if found["currency"] not in table.currencies or (unit and unit not in table.magnitudes):
            return ()
        waits = following.lower().rstrip(".") in table.magnitudes
        magnitude = (table.magnitudes[unit],) if unit else ()
        return _money(
            found["whole"], found["fraction"], magnitude, () if waits else table.currencies[found["currency"]]
        )

    def _quantity(self, found: re.Match[str]) -> Tokens:
        """A number with an optional unit; empty if the unit is unknown."""
        table, unit, whole, fraction = self.abbreviations, found["unit"].lower(), found["whole"], found["fraction"]
        plain = not unit and not found["sign"]
        amount = numbers.decimal(whole, fraction) if fraction else _plain(whole, year=plain)
        if not unit:
            return amount
        if unit in _HALVES_OF_THE_DAY:
            return (*amount, *_letters(unit))
        if unit in table.after_a_number:
            return (*amount, *_counted(table.after_a_number[unit], whole).split())
        single = table.magnitudes.get(unit) or table.symbols.get(unit)
        return (*amount, single) if single else ()

    def _text(self, place: _WordInContext) -> Tokens:
        whole = place.word.lower().strip("-")
        if whole in self.known:
            return (whole,)
        return _letters(place.word) if _DOTTED.fullmatch(place.word) else tuple(self._pieces(place))

    def _pieces(self, place: _WordInContext) -> Iterator[str]:
        """The word split between letters, digits and symbols, each part expanded separately."""
        for piece in _PIECE.findall(place.word):
            if piece[0].isdigit():
                whole, _, fraction = piece.replace(",", "").partition(".")
                yield from numbers.decimal(whole, fraction) if fraction else _plain(whole, year=True)
            elif piece[0].isalpha() or piece[0] == "'":
                yield from self._letters_or_word(piece, place)
            elif piece == "-":
                yield "to"
            elif piece in self.abbreviations.symbols:
                yield self.abbreviations.symbols[piece]

    def _letters_or_word(self, piece: str, place: _WordInContext) -> Tokens:
        """An acronym letter by letter, anything else as a word."""
        lower = piece.lower()
        capitals = _CAPITALS.fullmatch(piece)
        if capitals and not place.shouted and lower not in self.known:
            letters = capitals[1]
            if len(letters) <= _LONGEST_SPELLED_ACRONYM or not _VOWEL.search(letters):
                return _letters(piece)
        return (lower,) if any(map(str.isalpha, lower)) else ()


def _places(words: tuple[Word, ...]) -> Iterator[_WordInContext]:
    """Each word, with its neighbours."""
    folded = [fold(word.text).strip(_OUTSIDE) for word in words]
    shouted = not any(character.islower() for word in folded for character in word)
    neighbours = zip(["", *folded], folded, [*folded[1:], ""], strict=False)
    return (_WordInContext(previous, word, following, shouted) for previous, word, following in neighbours)


def fold(text: str) -> str:
    """The text in ASCII where there is an equivalent: without accents, with plain quotes and dashes, widths and
    ligatures normalized, invisible characters removed."""
    text = _VULGAR_AFTER_DIGIT.sub("&", text)
    decomposed = unicodedata.normalize("NFKD", text.translate(_QUOTES_AND_DASHES)).translate(_QUOTES_AND_DASHES)
    return "".join(character for character in decomposed if unicodedata.category(character) not in {"Mn", "Cf"})


def _key(word: str, table: dict[str, str]) -> str:
    """The word as it is in the table, with or without its full stop; empty if it has neither."""
    return next((key for key in (word, word.rstrip(".")) if key in table), "")


def _letters(word: str) -> Tokens:
    """Each letter by its name; a final small s belongs to the last one: "TVs" → t. v.'s"""
    stem = re.sub(r"'?s$", "", word) if not word.islower() else word
    names = [f"{letter.lower()}." for letter in stem if letter.isalpha()]
    return (*names[:-1], names[-1] + "'s") if stem != word else tuple(names)


def _plain(whole: str, *, year: bool) -> Tokens:
    return numbers.year(whole) if year and _YEAR.fullmatch(whole) else numbers.cardinal(whole) if whole else ()


def _counted(unit: str, amount: str) -> str:
    return unit if amount == "1" else numbers.plural(unit)


def _ordinal(found: re.Match[str], _following: str) -> Tokens:
    return numbers.ordinal(found[1].replace(",", ""))


def _decade(found: re.Match[str], _following: str) -> Tokens:
    return numbers.decade(found[1])


def _telephone(found: re.Match[str], _following: str) -> Tokens:
    return numbers.spelled(found[0].replace("-", ""))


def _time(found: re.Match[str], following: str) -> Tokens:
    suffix = _letters(found[3].lower()) if found[3] else ()
    full_hour = found[2] == "00" and not suffix and not _CLOCK_UNIT.fullmatch(following)
    return (*numbers.clock(found[1], found[2]), *(("o'clock",) if full_hour else ()), *suffix)


def _fraction(found: re.Match[str], _following: str) -> Tokens:
    whole, numerator, denominator = found.groups()
    *before, last = ("half",) if denominator == "2" else numbers.ordinal(denominator)
    if denominator == "4":
        last = "quarter"
    part = (*numbers.cardinal(numerator), *before, last if numerator == "1" else numbers.plural(last))
    return (*numbers.cardinal(whole), "and", *part) if whole else part


def _money(whole: str, fraction: str | None, magnitude: Tokens, names: Tokens) -> Tokens:
    """Dollars and cents; `names` is empty if the next word is the magnitude and includes the currency."""
    if not names or magnitude or (fraction and len(fraction) != 2):
        amount = numbers.decimal(whole, fraction) if fraction else numbers.cardinal(whole)
        return (*amount, *magnitude, *names[1:2])
    one, several, hundredth, hundredths = names
    coins = (*numbers.cardinal(str(int(fraction))), hundredth if int(fraction) == 1 else hundredths) if fraction else ()
    if not int(whole.replace(",", "") or "0") and coins:
        return coins
    notes = (*numbers.cardinal(whole), one if whole == "1" else several)
    return (*notes, *(("and", *coins) if fraction and int(fraction) else ()))


_READINGS: tuple[tuple[re.Pattern[str], Callable[[re.Match[str], str], Tokens]], ...] = (
    (_ORDINAL, _ordinal),
    (_DECADE, _decade),
    (_TIME, _time),
    (_FRACTION, _fraction),
    (_TELEPHONE, _telephone),
)
"""Number formats and their readings; each reading also gets the next word."""

_SIGNS: dict[str, Tokens] = {"-": ("minus",), "+": ("plus",), "#": ("number",), "": ()}
_HALVES_OF_THE_DAY = frozenset({"am", "pm"})

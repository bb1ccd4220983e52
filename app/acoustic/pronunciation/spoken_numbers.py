"""Reads numbers in English: cardinals, ordinals, decimals, years, times and digit by digit.

Every function takes the digits as written and returns lower-case words without hyphens.
"""

import re
from typing import Any

from ...loading import OnDemand

LONGEST_CARDINAL = 15
"""Numbers with more digits are read digit by digit."""

_DIGITS = ("oh", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")
_WORD = re.compile(r"[a-z]+")


def cardinal(digits: str) -> tuple[str, ...]:
    """ "1,234" → one thousand two hundred thirty four; what begins with 0 is said digit by digit, "007"."""
    digits = digits.replace(",", "")
    if len(digits) > LONGEST_CARDINAL or (len(digits) > 1 and digits[0] == "0"):
        return spelled(digits)
    return _words(digits)


def ordinal(digits: str) -> tuple[str, ...]:
    """ "21" → twenty first."""
    return _split(_ENGLISH.get().ordinal(" ".join(cardinal(digits))))


def decimal(whole: str, fraction: str) -> tuple[str, ...]:
    """ "3", "14" → three point one four."""
    return (*(cardinal(whole) if whole else ()), "point", *spelled(fraction))


def spelled(digits: str) -> tuple[str, ...]:
    """ "007" → oh oh seven."""
    return tuple(_DIGITS[int(digit)] for digit in digits)


def year(digits: str) -> tuple[str, ...]:
    """ "1984" → nineteen eighty four, "1905" → nineteen oh five, "2000" → two thousand."""
    century, rest = digits[:2], digits[2:]
    if digits[1:3] == "00":
        return _words(digits)
    if rest == "00":
        return (*_words(century), "hundred")
    return (*_words(century), *(spelled(rest) if rest[0] == "0" else _words(rest)))


def decade(digits: str) -> tuple[str, ...]:
    """ "1980" or "80" → (nineteen) eighties."""
    *before, last = year(digits) if len(digits) == 4 else _words(digits)
    return (*before, plural(last))


def clock(hour: str, minute: str) -> tuple[str, ...]:
    """ "3", "05" → three oh five; the full hour is said without minutes."""
    if minute == "00":
        return _words(hour)
    return (*_words(hour), *(spelled(minute) if minute[0] == "0" else _words(minute)))


def plural(noun: str) -> str:
    """ "foot" → feet, "mile per hour" → miles per hour, "eighty" → eighties."""
    return str(_ENGLISH.get().plural(noun))


def _words(digits: str) -> tuple[str, ...]:
    return _split(str(_ENGLISH.get().number_to_words(str(int(digits)), andword="")))


def _split(words: str) -> tuple[str, ...]:
    return tuple(_WORD.findall(words))


def _engine() -> Any:  # noqa: ANN401 - inflect has no types of its own
    """inflect's engine. At the import typeguard would compile its functions anew, for checks at run time, which takes
    two seconds; here it leaves them as they are."""
    import typeguard

    typechecked = typeguard.typechecked
    typeguard.typechecked = lambda function: function  # type: ignore[assignment]
    try:
        import inflect
    finally:
        typeguard.typechecked = typechecked
    return inflect.engine()


_ENGLISH = OnDemand(_engine)
"""Made once, whichever threads ask for it, since typeguard is changed meanwhile."""

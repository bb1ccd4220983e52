"""When the words of a line without a recording are spoken: each sound as long as it usually lasts, longer in the last
syllable before a pause and in emphasized words, with pauses at punctuation.

The agents of Gesture Engine (Hartmann, Mancini & Pelachaud 2002, §5) and of *Towards Natural Gesture Synthesis* (§3.1)
take these times from a speech synthesizer; here they stand in for one, and `timed_elsewhere` takes a synthesizer's.
How a line is paced is read from `lexicon/pacing.yaml`, every mistake in it reported at once, with its place.
"""

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Self

from pydantic import Field, field_validator

from ...model import Interval, Phone, Speaking, Word
from ...yaml_files import Entry, Source
from ..stress import VOWELS
from .phone_durations import FILE as DURATIONS
from .phone_durations import PhoneDurations

FILE = "pacing.yaml"
ELLIPSIS = "…"

_CLOSING = "\"'“”‘’«»()[]{}*_"
_Pause = Annotated[float, Field(ge=0, le=10, strict=False)]
_Factor = Annotated[float, Field(ge=0.5, le=3, strict=False)]

DECIMALS = 3


class PauseTable(Entry):
    """Silences in seconds, and factors of usual durations; comments in the file explain them."""

    begin_s: _Pause
    end_s: _Pause
    between_words_s: _Pause
    pauses_s: dict[str, _Pause]
    before_pause: _Factor
    emphasized: _Factor

    @field_validator("pauses_s")
    @classmethod
    def _single_marks(cls, pauses_s: dict[str, float]) -> dict[str, float]:
        """The pauses by mark; raises ValueError for a key that is not one punctuation mark."""
        for mark in pauses_s:
            if len(mark) != 1 or mark.isalnum() or mark.isspace():
                raise ValueError(f"{mark!r} is not a punctuation mark; give one character")
        return pauses_s

    @classmethod
    def load(cls, path: Path) -> Self:
        """Raises AuthoringError with every mistake."""
        return Source(path).validated(cls)

    def after(self, text: str) -> float:
        """The pause after a word as it is written, or in place of one that is punctuation alone; 0 for none."""
        written = text.replace("...", ELLIPSIS).rstrip(_CLOSING)
        marks = written[len(written.rstrip("".join(self.pauses_s))) :]
        return max((self.pauses_s[mark] for mark in marks), default=0.0)


@dataclass(frozen=True, slots=True)
class Pace:
    """How fast people usually speak, and where they pause."""

    durations: PhoneDurations
    pauses: PauseTable

    @classmethod
    def load(cls, lexicon: Path) -> Self:
        """Raises AuthoringError with every mistake in the first file that has any."""
        return cls(PhoneDurations.load(lexicon / DURATIONS), PauseTable.load(lexicon / FILE))


@dataclass(frozen=True, slots=True)
class PacedWords:
    """The words with their times, and how long the line lasts with the silence around it."""

    words: tuple[Word, ...]
    duration_s: float


def paced(pace: Pace, words: tuple[Word, ...], speaking: Speaking, unpaused: Collection[int] = ()) -> PacedWords:
    """The words, whose phones are known, at their usual times. Words in `unpaused` end in a full stop that ends no
    sentence ("Mr."). Words without phones get no time."""
    pauses_s = [_pause_after(pace.pauses, word, speaking, unpaused) for word in words]
    time_s = pace.pauses.begin_s + speaking.pause_s(-1, 0.0)
    last = max((word.index for word in words if word.phones), default=-1)
    timed = []
    for word, pause_s in zip(words, pauses_s, strict=True):
        if word.phones:
            lengthened = pause_s > 0 or word.index == last or _is_before_mark(words, pauses_s, word.index)
            word, time_s = _spoken(pace, word, speaking, time_s, lengthened=lengthened)  # noqa: PLW2901
            time_s += pace.pauses.between_words_s
        timed.append(word)
        time_s += pause_s if word.index < last else 0.0
    return PacedWords(tuple(timed), round(time_s + pace.pauses.end_s, DECIMALS))


def timed_elsewhere(pace: Pace, words: tuple[Word, ...], expected: tuple[Word, ...]) -> PacedWords:
    """Words whose times a synthesizer told; those without phones share theirs among the `expected` ones."""
    timed = tuple(
        replace(pace.durations.spread(replace(word, phones=said.phones), word.interval), spread=False)
        if word.interval and not word.phones
        else word
        for word, said in zip(words, expected, strict=True)
    )
    end_s = max((word.interval.end_s for word in timed if word.interval), default=0.0)
    return PacedWords(timed, round(end_s + pace.pauses.end_s, DECIMALS))


def _pause_after(table: PauseTable, word: Word, speaking: Speaking, unpaused: Collection[int]) -> float:
    usual_s = 0.0 if word.index in unpaused else table.after(word.text)
    return speaking.pause_s(word.index, usual_s)


def _is_before_mark(words: tuple[Word, ...], pauses_s: list[float], index: int) -> bool:
    """Whether the next word is a mark that stands alone and is a pause."""
    after = index + 1
    return after < len(words) and not words[after].phones and pauses_s[after] > 0


def _spoken(pace: Pace, word: Word, speaking: Speaking, start_s: float, *, lengthened: bool) -> tuple[Word, float]:
    """The word from `start_s` on, and its end."""
    factor = speaking.slowness(word.index)
    factor *= pace.pauses.emphasized if word.index in speaking.emphasized else 1.0
    final = pace.pauses.before_pause if lengthened else 1.0
    phones = tuple(_phones(pace.durations, word.phones, start_s, factor, final))
    end_s = phones[-1].interval.end_s
    return replace(word, interval=Interval(phones[0].interval.start_s, end_s), phones=phones), end_s


def _phones(
    durations: PhoneDurations, phones: tuple[Phone, ...], start_s: float, factor: float, final: float
) -> Iterator[Phone]:
    """The phones one after the other; from the last vowel on they are `final` times as long."""
    nuclei = [place for place, phone in enumerate(phones) if phone.label in VOWELS]
    rhyme = nuclei[-1] if nuclei else 0
    for place, phone in enumerate(phones):
        lasts_s = durations.usual_s[phone.label] * factor * (final if place >= rhyme else 1.0)
        yield replace(phone, interval=Interval(round(start_s, DECIMALS), round(start_s + lasts_s, DECIMALS)))
        start_s += lasts_s

"""Reads and writes word timings of other tools: JSON (the response of `align`), Praat TextGrid, and CTM.

Times are seconds from the start of the audio. A file's words are matched to the transcript's in order and must be equal
except for case, accents and punctuation. Words of the transcript that are not spoken ("—") may be missing in a file,
and are left out of TextGrid and CTM.

    TextGrid  a tier "words", or else the only tier of intervals, or the first whose name has "word" in it; a tier
              "phones" if there is one, each phone belonging to the word its middle lies in. Empty labels are silence.
    JSON      also the speech marks of a synthesizer: lines of {"time": 370, "type": "word", "value": "so"}, in
              milliseconds; a word ends where the mouth closes (a mark of type "viseme" and value "sil"), else where the
              next begins, the last one with the last mark or after a usual time.
    CTM       lines of "name channel start duration word [confidence]"; lines that begin with ";;" are comments.
"""

import json
import math
import re
from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated

from pydantic import BaseModel, ConfigDict, FailFast, Field, ValidationError

from ...errors import InputError, UndecodableError, UnsupportedFormatError, shown, why_not_json
from ...model import Filler, Interval, Phone, Word
from ..pronunciation.normalisation import fold

FORMATS = ("json", "textgrid", "ctm")
TOLERANCE_S = 0.005
"""Times may overlap or exceed the audio's end by this much, because of rounding in other tools."""

_USUAL_WORD_S = 0.3
"""Of a word whose end no mark tells."""

MOST_WORDS = 10_000
MOST_PHONES = 1000
"""Of one word."""

_SILENCES = frozenset({"", "sil", "sp", "spn", "pau", "<eps>", "<sil>"})
_NEGATIVE_TIME = re.compile(r"xmin\s*=\s*-[\d.]*[1-9]")
_STRESSED = re.compile(r"([A-Z]+)([012])")


class _TimedPhone(BaseModel):
    model_config = ConfigDict(defer_build=True, extra="ignore", frozen=True)

    label: str
    start_s: float
    end_s: float
    stress: Annotated[int, Field(ge=0, le=2)] | None = None


class _TimedWord(BaseModel):
    model_config = ConfigDict(defer_build=True, extra="ignore", frozen=True)

    text: str
    start_s: float | None = None
    end_s: float | None = None
    phones: Annotated[tuple[_TimedPhone, ...], FailFast(), Field(max_length=MOST_PHONES)] = ()


class _SpeechMark(BaseModel):
    """A mark of Amazon Polly's kind, `time` in milliseconds."""

    model_config = ConfigDict(defer_build=True, extra="ignore", frozen=True)

    time: Annotated[float, Field(ge=0)]
    type: str
    value: str = ""


class _TimedFiller(BaseModel):
    model_config = ConfigDict(defer_build=True, extra="ignore", frozen=True)

    text: str
    start_s: Annotated[float, Field(ge=0)]
    end_s: float


class _TimedWords(BaseModel):
    """The parts of the JSON of `align` that are read."""

    model_config = ConfigDict(defer_build=True, extra="ignore", frozen=True)

    words: Annotated[tuple[_TimedWord, ...], FailFast(), Field(max_length=MOST_WORDS)]
    fillers: Annotated[tuple[_TimedFiller, ...], FailFast(), Field(max_length=MOST_WORDS)] = ()


@dataclass(frozen=True, slots=True)
class _Timed:
    """A timed word of a file."""

    text: str
    interval: Interval
    phones: tuple[Phone, ...] = ()


def read_timings(content: bytes, format: str, words: tuple[Word, ...], *, duration_s: float) -> tuple[Word, ...]:  # noqa: A002
    """The words with their intervals and optional phones from `content`.

    Raises UnsupportedFormatError `timings_format`, UndecodableError `timings_unreadable`, and InputError
    `timings_words_differ`, `timings_not_a_time`, `timings_out_of_order`, `timings_beyond_audio`.
    """
    readers = {"json": _from_json, "textgrid": _from_textgrid, "ctm": _from_ctm}
    if format not in readers:
        raise UnsupportedFormatError(
            "timings_format",
            f"timed words cannot be read from {shown(format)}; send {', '.join(FORMATS)}",
            field="words",
        )
    timed = tuple(readers[format](_decoded(content, format)))
    _check_times(timed, duration_s)
    return _matched(timed, words, duration_s)


def read_fillers(content: bytes, format: str, *, duration_s: float) -> tuple[Filler, ...]:  # noqa: A002
    """The fillers within the audio that the JSON of `align` tells beside its words; the other formats have none.
    `read_timings` must have read the content."""
    text = _decoded(content, format)
    if format != "json" or _is_marks(text):
        return ()
    found = _timed_words(text).fillers
    return tuple(
        Filler(each.text, Interval(each.start_s, min(each.end_s, duration_s)))
        for each in found
        if each.start_s < min(each.end_s, duration_s)
    )


def to_textgrid(words: tuple[Word, ...], duration_s: float) -> str:
    """A Praat TextGrid (long format) with the tiers "words" and "phones"."""
    from praatio.utilities import textgrid_io  # type: ignore[import-untyped]

    end_s = max([duration_s, *(word.interval.end_s for word in words if word.interval)])
    tiers = {
        "words": [(*_span(word.interval), word.text) for word in words if word.interval],
        "phones": [(*_span(phone.interval), phone.label) for word in words for phone in word.phones],
    }
    grid = {
        "xmin": 0,
        "xmax": end_s,
        "tiers": [
            {"class": "IntervalTier", "name": name, "xmin": 0, "xmax": end_s, "entries": entries}
            for name, entries in tiers.items()
        ],
    }
    return str(textgrid_io.getTextgridAsStr(grid, "long_textgrid", includeBlankSpaces=True))


def to_ctm(words: tuple[Word, ...], name: str) -> str:
    """CTM lines for the recording `name`, channel 1, times to the millisecond; white space in the name becomes "_"."""
    name = "_".join(name.split()) or "audio"
    return "".join(
        f"{name} 1 {word.interval.start_s:.3f} {word.interval.duration_s:.3f} {word.text}\n"
        for word in words
        if word.interval is not None
    )


def _decoded(content: bytes, name: str) -> str:
    try:
        return content.decode("utf-16" if content[:2] in {b"\xff\xfe", b"\xfe\xff"} else "utf-8-sig")
    except UnicodeDecodeError as error:
        raise _unreadable(name, f"byte {error.start} is not {error.encoding}") from None


def _timed_words(text: str) -> _TimedWords:
    try:
        content = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise _unreadable("json", why_not_json(error)) from None
    try:
        return _TimedWords.model_validate(content)
    except ValidationError as error:
        first = error.errors()[0]
        raise _unreadable("json", f"{'.'.join(map(str, first['loc']))}: {first['msg']}") from None


def _is_marks(text: str) -> bool:
    """Whether a JSON file has a line for each mark."""
    first = text.strip().partition("\n")[0]
    try:
        content = json.loads(first)
    except (ValueError, RecursionError):
        return False
    return isinstance(content, dict) and "time" in content


def _from_marks(text: str) -> Iterator[_Timed]:
    marks = [_mark(number, line) for number, line in enumerate(text.splitlines(), start=1) if line.strip()]
    found: list[_Timed] = []
    following_s: float | None = None
    last_s = 0.0
    for mark in reversed(marks):
        start_s = mark.time / 1000
        if mark.type == "word":
            usual_s = last_s if last_s > start_s else start_s + _USUAL_WORD_S
            found.append(_Timed(mark.value, Interval(start_s, usual_s if following_s is None else following_s)))
        if mark.type == "word" or mark.value == "sil":
            following_s = start_s
        last_s = max(last_s, start_s)
    yield from reversed(found)


def _mark(number: int, line: str) -> _SpeechMark:
    try:
        return _SpeechMark.model_validate_json(line)
    except ValidationError as error:
        first = error.errors()[0]
        where = ".".join(map(str, first["loc"]))
        raise _unreadable("json", f"line {number} is not a speech mark: {where}: {first['msg']}") from None


def _from_json(text: str) -> Iterator[_Timed]:
    if _is_marks(text):
        yield from _from_marks(text)
        return
    for word in _timed_words(text).words:
        if word.start_s is not None and word.end_s is not None:
            phones = tuple(
                Phone(phone.label, Interval(phone.start_s, phone.end_s), phone.stress) for phone in word.phones
            )
            yield _Timed(word.text, Interval(word.start_s, word.end_s), phones)


def _from_ctm(text: str) -> Iterator[_Timed]:
    for number, line in enumerate(text.splitlines(), start=1):
        fields = line.split()
        if not fields or line.startswith(";;"):
            continue
        try:
            start_s, duration_s, word = float(fields[2]), float(fields[3]), fields[4]
        except (IndexError, ValueError):
            raise _unreadable("ctm", f"line {number} is not 'name channel start duration word'") from None
        if word.lower() not in _SILENCES:
            yield _Timed(word, Interval(start_s, round(start_s + duration_s, 6)))


def _from_textgrid(text: str) -> Iterator[_Timed]:
    tiers = _interval_tiers(text)
    names = [name for name in tiers if name.lower() == "words"] or [name for name in tiers if "word" in name.lower()]
    name = names[0] if names else next(iter(tiers)) if len(tiers) == 1 else None
    if name is None:
        raise _unreadable("textgrid", f"it has no tier 'words' but {', '.join(map(repr, tiers)) or 'none'}")
    phones = [phone for tier in tiers if tier.lower() in {"phones", "phonemes"} for phone in tiers[tier]]
    by_middle = sorted(phones, key=_middle_s)
    middles_s = [_middle_s(phone) for phone in by_middle]
    for start_s, end_s, label in tiers[name]:
        if label.strip().lower() not in _SILENCES:
            inside = by_middle[bisect_left(middles_s, start_s) : bisect_left(middles_s, end_s)]
            yield _Timed(label.strip(), Interval(start_s, end_s), tuple(_phone(*phone) for phone in inside))


def _middle_s(phone: tuple[float, float, str]) -> float:
    return (phone[0] + phone[1]) / 2


def _interval_tiers(text: str) -> dict[str, list[tuple[float, float, str]]]:
    """The entries of each tier of intervals."""
    from praatio.utilities import textgrid_io
    from praatio.utilities.errors import PraatioException  # type: ignore[import-untyped]

    if _NEGATIVE_TIME.search(text):  # praatio would drop the sign
        raise _unreadable("textgrid", "it has a time below 0")
    try:
        return {
            str(tier["name"]): [(float(start_s), float(end_s), str(label)) for start_s, end_s, label in tier["entries"]]
            for tier in textgrid_io.parseTextgridStr(text, includeEmptyIntervals=False)["tiers"]
            if tier["class"] == "IntervalTier"
        }
    except (PraatioException, ValueError, LookupError, AttributeError, TypeError, RecursionError) as error:
        why = " ".join(str(error).split()) if isinstance(error, PraatioException) else ""
        raise _unreadable("textgrid", why or "its layout is not Praat's") from None


def _phone(start_s: float, end_s: float, label: str) -> Phone:
    """ "EH1" is EH with stress 1."""
    stressed = _STRESSED.fullmatch(label)
    interval = Interval(start_s, end_s)
    return Phone(stressed[1], interval, int(stressed[2])) if stressed else Phone(label, interval)


def _check_times(timed: tuple[_Timed, ...], duration_s: float) -> None:
    """Times must be numbers in order, and within the audio."""
    for number, word in enumerate(timed):
        for interval in (word.interval, *(phone.interval for phone in word.phones)):
            if not (math.isfinite(interval.start_s) and math.isfinite(interval.end_s)):
                raise _wrong("timings_not_a_time", number, word, "has a time that is not a number")
            if interval.start_s < 0 or interval.end_s < interval.start_s:
                raise _wrong("timings_out_of_order", number, word, "must start at 0 or later and end after its start")
            if interval.end_s > duration_s + TOLERANCE_S:
                raise _wrong("timings_beyond_audio", number, word, f"must end within the audio's {duration_s:.3f} s")
        _check_phones(number, word)
    for number, (one, following) in enumerate(pairwise(timed), start=1):
        if following.interval.start_s < one.interval.end_s - TOLERANCE_S:
            raise _wrong("timings_out_of_order", number, following, f"must not start before {shown(one.text)} ends")


def _check_phones(number: int, word: _Timed) -> None:
    edges_s = [edge for phone in word.phones for edge in _span(phone.interval)]
    inside = [word.interval.start_s, *edges_s, word.interval.end_s] if edges_s else []
    if any(later < earlier - TOLERANCE_S for earlier, later in pairwise(inside)):
        raise _wrong("timings_out_of_order", number, word, "must hold its phones, one after the other")


def _matched(timed: tuple[_Timed, ...], words: tuple[Word, ...], duration_s: float) -> tuple[Word, ...]:
    """Each transcript word with the next word of the file; unspoken words may be missing there."""
    remaining = list(timed)
    matched = []
    for word in words:
        if remaining and _spelling(remaining[0].text) == _spelling(word.text):
            found = remaining.pop(0)
            interval = Interval(found.interval.start_s, min(found.interval.end_s, duration_s))
            matched.append(replace(word, interval=interval, phones=found.phones))
        elif _spelling(word.text):
            there = f"has {shown(remaining[0].text)}" if remaining else "ends"
            raise _differ(f"word {word.index} of the text is {shown(word.text)} where the timings' file {there}")
        else:
            matched.append(word)
    if remaining:
        raise _differ(f"the timings' file goes on with {shown(remaining[0].text)} after the text's {len(words)} words")
    return tuple(matched)


def _spelling(text: str) -> str:
    """The normalized spelling for comparison; empty without letters or digits."""
    return "".join(character for character in fold(text).lower() if character.isalnum())


def _span(interval: Interval) -> tuple[float, float]:
    return interval.start_s, interval.end_s


def _wrong(code: str, number: int, word: _Timed, what: str) -> InputError:
    start_s, end_s = _span(word.interval)
    return InputError(
        code, f"entry {number} of the timings, {shown(word.text)} from {start_s} to {end_s} s, {what}", field="words"
    )


def _differ(message: str) -> InputError:
    return InputError("timings_words_differ", message + "; time the words of this text", field="words")


def _unreadable(name: str, why: str) -> UndecodableError:
    return UndecodableError("timings_unreadable", f"the timings are not {name} with timed words: {why}", field="words")

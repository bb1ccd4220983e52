"""A text in XML: the words in it, and what its tags say of them.

    SSML    <emphasis level>, <break time | strength>, <prosody rate>
    APML    <emphasis x-pitchaccent>, <pause sec>, <boundary>, <performative type> and others
    ours    <function class subtype priority>, <gesture name>

`lexicon/tags.yaml` says which functions tags name. A gesture is a behaviour or a lexeme and comes on the words inside,
above all worths; without a name it is a beat. Tags that only group words need no mention; what else is not known is
named in `Speaking.unread_tags`. A DOCTYPE is refused, so that there are no entities but XML's own five.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from xml.parsers import expat

from ..errors import InputError, shown
from ..model import PLAIN, PLAINLY_SPOKEN, Demand, GivenFunction, Speaking
from .tag_table import TagTable

GENERIC_GESTURE = "beat_gesture"
"""Gesture Engine takes a beat where a request names no gesture (§5)."""

MOST_DEPTH = 64
NAMED_PRIORITY = 1.0
"""Of a function that a tag names by itself, such as the rheme: the least, for it says where others belong."""

GROUPS = frozenset({"speak", "apml", "turn", "utterance", "s", "p", "topic-comment", "mark", "say-as"})
_SEPARATE = frozenset({"s", "p", "turn", "utterance", "performative"})
"""Between these, words end without white space too."""

STRENGTHS_S = MappingProxyType(
    {"none": 0.0, "x-weak": 0.1, "weak": 0.2, "medium": 0.35, "strong": 0.6, "x-strong": 1.0}
)
BOUNDARY_S = 0.25
RATES = MappingProxyType({"x-slow": 0.6, "slow": 0.8, "medium": 1.0, "default": 1.0, "fast": 1.25, "x-fast": 1.5})
_SLOWEST, _FASTEST, _LONGEST_PAUSE_S = 0.3, 3.0, 30.0
_TIME = re.compile(r"\+?(\d*\.?\d+)\s*(ms|s)?")
_RATE = re.compile(r"(\d*\.?\d+)(%?)")
_UNEMPHATIC = frozenset({"none", "reduced"})


@dataclass(frozen=True, slots=True)
class SpokenText:
    """The words alone in `text`; how they are spoken, and the functions and behaviours that tags ask for."""

    text: str
    speaking: Speaking = PLAINLY_SPOKEN
    functions: tuple[GivenFunction, ...] = ()
    demands: tuple[Demand, ...] = ()


@dataclass(frozen=True, slots=True)
class _OpenTag:
    """A tag whose end has not come: its attributes, the first word inside, and its line and column."""

    name: str
    attributes: Mapping[str, str]
    first: int
    where: str


@dataclass(slots=True)
class _TextSoFar:
    """What was read so far."""

    words: list[str] = field(default_factory=list)
    emphasized: set[int] = field(default_factory=set)
    pauses_s: dict[int, float] = field(default_factory=dict)
    rates: dict[int, float] = field(default_factory=dict)
    functions: list[GivenFunction] = field(default_factory=list)
    demands: list[Demand] = field(default_factory=list)
    unread: dict[str, None] = field(default_factory=dict)


def read_tagged(text: str, table: TagTable) -> SpokenText:
    """Raises InputError `tags_wrong` for malformed XML, and for tags whose attributes cannot be read."""
    found = _Reader(table).read(text)
    speaking = Speaking(
        frozenset(found.emphasized),
        tuple(sorted(found.pauses_s.items())),
        tuple(sorted(found.rates.items())),
        tuple(found.unread),
    )
    return SpokenText(" ".join(found.words), speaking, tuple(found.functions), tuple(found.demands))


class _Reader:
    """Takes the parser's events."""

    def __init__(self, table: TagTable) -> None:
        self._table = table
        self._found = _TextSoFar()
        self._open: list[_OpenTag] = []
        self._in_word = False
        self._parser = expat.ParserCreate()
        self._parser.buffer_text = True
        self._parser.StartDoctypeDeclHandler = self._refuse_doctype
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._parser.CharacterDataHandler = self._text

    def read(self, text: str) -> _TextSoFar:
        try:
            self._parser.Parse(text.removeprefix("\ufeff").lstrip(), True)
        except expat.ExpatError as error:
            where = f"line {error.lineno}, column {error.offset + 1}"
            message = f"the text begins with a tag but is not XML: {expat.ErrorString(error.code)}"
            raise _misread(where, f"{message}; close every tag, and write & as &amp;") from None
        return self._found

    def _where(self) -> str:
        return f"line {self._parser.CurrentLineNumber}, column {self._parser.CurrentColumnNumber + 1}"

    def _refuse_doctype(self, *_declaration: object) -> None:
        raise _misread(self._where(), "a DOCTYPE is not read; leave it out")

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        name = name.rpartition(":")[2].lower()
        if len(self._open) >= MOST_DEPTH:
            raise _misread(self._where(), f"more than {MOST_DEPTH} tags inside one another")
        self._in_word = self._in_word and name not in _SEPARATE
        first = len(self._found.words) - self._in_word
        lower = {each.rpartition(":")[2].lower(): value for each, value in attributes.items()}
        self._open.append(_OpenTag(name, lower, first, self._where()))

    def _end(self, _name: str) -> None:
        tag = self._open.pop()
        self._in_word = self._in_word and tag.name not in _SEPARATE
        self._take(tag, range(tag.first, len(self._found.words)))

    def _text(self, text: str) -> None:
        for piece in re.split(r"(\s+)", text):
            if piece and not piece.isspace() and self._in_word:
                self._found.words[-1] += piece
            elif piece and not piece.isspace():
                self._found.words.append(piece)
            if piece:
                self._in_word = not piece.isspace()

    def _take(self, tag: _OpenTag, words: range) -> None:
        functions = list(self._table.functions_of(tag.name, tag.attributes))
        if words:
            self._found.functions += [GivenFunction(name, subtype, words[0], words[-1]) for name, subtype in functions]
        named = self._table.function_named(tag.name)
        if named and words:
            self._found.functions.append(GivenFunction(*named, words[0], words[-1], NAMED_PRIORITY))
        taken = _TAKEN.get(tag.name)
        if taken:
            taken(self._found, tag, words)
        elif not functions and not named and tag.name not in GROUPS:
            self._found.unread[tag.name] = None


def _emphasis(found: _TextSoFar, tag: _OpenTag, words: range) -> None:
    if tag.attributes.get("level", "").lower() not in _UNEMPHATIC:
        found.emphasized.update(words)


def _break(found: _TextSoFar, tag: _OpenTag, _words: range) -> None:
    time, strength = tag.attributes.get("time"), tag.attributes.get("strength", "medium").lower()
    if time is None and strength not in STRENGTHS_S:
        raise _misread(tag.where, f"<break strength={strength!r}>; there are {', '.join(STRENGTHS_S)}")
    _pause(found, STRENGTHS_S[strength] if time is None else _seconds(tag, "time", time))


def _pause_sec(found: _TextSoFar, tag: _OpenTag, _words: range) -> None:
    _pause(found, _seconds(tag, "sec", tag.attributes.get("sec", "")))


def _boundary(found: _TextSoFar, _tag: _OpenTag, _words: range) -> None:
    _pause(found, BOUNDARY_S)


def _pause(found: _TextSoFar, lasts_s: float) -> None:
    """A pause after the last word; several there are one after the other."""
    last = len(found.words) - 1
    found.pauses_s[last] = found.pauses_s.get(last, 0.0) + lasts_s


def _prosody(found: _TextSoFar, tag: _OpenTag, words: range) -> None:
    told = tag.attributes.get("rate", "medium").strip().lower()
    number = _RATE.fullmatch(told)
    if told not in RATES and not number:
        raise _misread(tag.where, f"<prosody rate={told!r}>; give {', '.join(RATES)}, or a share of the usual as 80%")
    rate = RATES[told] if number is None else float(number[1]) / (100 if number[2] else 1)
    if not _SLOWEST <= rate <= _FASTEST:
        raise _misread(tag.where, f"<prosody rate={told!r}>; give {_SLOWEST:.0%} to {_FASTEST:.0%}")
    for word in words:
        found.rates[word] = found.rates.get(word, 1.0) * rate


def _function(found: _TextSoFar, tag: _OpenTag, words: range) -> None:
    name, told = tag.attributes.get("class", ""), tag.attributes.get("priority")
    if not name:
        raise _misread(tag.where, '<function> needs its class, such as <function class="negation">')
    try:
        priority = None if told is None else float(told)
    except ValueError:
        raise _misread(tag.where, f"<function priority={told!r}>; give a number") from None
    if words:
        subtype = tag.attributes.get("subtype") or PLAIN
        found.functions.append(GivenFunction(name, subtype, words[0], words[-1], priority))


def _gesture(found: _TextSoFar, tag: _OpenTag, words: range) -> None:
    name = next((tag.attributes[each] for each in ("name", "lexeme", "type") if tag.attributes.get(each)), None)
    if not words:
        raise _misread(tag.where, "<gesture> has no words; put the words that it accompanies inside")
    by = f"the tag <gesture> in {tag.where}"
    found.demands.append(Demand(name or GENERIC_GESTURE, words[0], words[-1], always=True, by=by))


_TAKEN: Mapping[str, Callable[[_TextSoFar, _OpenTag, range], None]] = MappingProxyType(
    {
        "emphasis": _emphasis,
        "break": _break,
        "pause": _pause_sec,
        "boundary": _boundary,
        "prosody": _prosody,
        "function": _function,
        "gesture": _gesture,
    }
)


def _seconds(tag: _OpenTag, attribute: str, text: str) -> float:
    found = _TIME.fullmatch(text.strip().lower())
    lasts_s = float(found[1]) / (1000 if found[2] == "ms" else 1) if found else -1.0
    if not 0 <= lasts_s <= _LONGEST_PAUSE_S:
        advice = f"give seconds up to {_LONGEST_PAUSE_S:g}, as 0.3s or 300ms"
        raise _misread(tag.where, f"<{tag.name} {attribute}={shown(text)}>; {advice}")
    return lasts_s


def _misread(where: str, message: str) -> InputError:
    return InputError("tags_wrong", f"text, {where}: {message}", field="text")

"""The language stage for words alone: parses them and derives their communicative functions (paper §3.2, §3.3)."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Protocol

from ..model import Analysis, Parse, Utterance, Word
from ..settings import Settings
from ..text.transcript import read_transcript
from .derivation import FunctionRules, understand


class ParsesLines(Protocol):
    """A parser of several lines at once, such as `understudy.syntax.parser.Parser`."""

    def parse_all(self, lines: Sequence[tuple[Word, ...]]) -> Iterable[Parse]: ...


class Language(Protocol):
    """The models of the language stage, such as `understudy.models.LanguageModels`."""

    @property
    def settings(self) -> Settings: ...

    @property
    def parser(self) -> ParsesLines: ...

    @property
    def rules(self) -> FunctionRules: ...


def find_functions(language: Language, text: str) -> Analysis:
    """The communicative functions of a text; without a recording, nothing has a time (paper §3.2, §3.3)."""
    words = read_transcript(text)
    [analysis] = find_functions_in_all(language, [words])
    return analysis


def find_functions_in_all(language: Language, lines: Sequence[tuple[Word, ...]]) -> Iterator[Analysis]:
    """The same for several lines, which are parsed together: that takes half the time."""
    for words, parse in zip(lines, language.parser.parse_all(lines), strict=True):
        yield understand(language.rules, Utterance(words=words, parse=parse))

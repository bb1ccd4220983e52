"""The language stage: parses words and applies the rules for communicative functions (paper §3.2, §3.3)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from .analysis import Analysis
from .loading import load_function_rules
from .model import Utterance, Word
from .resources import resource_folder
from .rules.derivation import FunctionRules, understand
from .settings import Settings
from .syntax.parser import Parser
from .transcript import read_transcript


@dataclass(frozen=True, slots=True)
class LanguageModels:
    """The models of the language stage (paper §3.2, §3.3)."""

    settings: Settings
    parser: Parser
    rules: FunctionRules

    @classmethod
    def load(cls, settings: Settings) -> "LanguageModels":
        """Raises AuthoringError with every mistake in words and rules, ServiceError when the parser does not load."""
        return cls(
            settings=settings,
            parser=Parser.load(settings.parser or resource_folder("models") / "parser"),
            rules=load_function_rules(),
        )


def find_functions(language: LanguageModels, text: str) -> Analysis:
    """The communicative functions of the words alone; without a recording, nothing has a time (paper §3.2, §3.3)."""
    [analysis] = find_functions_in_all(
        language, [read_transcript(text, max_characters=language.settings.max_text_characters)]
    )
    return analysis


def find_functions_in_all(language: LanguageModels, lines: Sequence[tuple[Word, ...]]) -> Iterator[Analysis]:
    """The same for several lines, which are parsed together: that takes half the time."""
    for words, parse in zip(lines, language.parser.parse_all(lines), strict=True):
        utterance = Utterance(words=words, parse=parse)
        known = understand(language.rules, utterance)
        yield Analysis(utterance, known.functions, facts=known.facts)

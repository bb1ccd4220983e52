"""What the rules and words we ship find in a text, over real parses."""

from functools import cache
from pathlib import Path

from app.model import Utterance
from app.rules.derivation import FunctionRules, derive_functions
from app.syntax.parser import Parser
from tests.utterances import PARSER, words_of

ROOT = Path(__file__).resolve().parents[1]


@cache
def shipped_rules() -> FunctionRules:
    return FunctionRules.load(ROOT / "app" / "rules", ROOT / "lexicon" / "en")


@cache
def shipped_parser() -> Parser:
    return Parser.load(PARSER)


def found(text: str, class_name: str) -> list[tuple[str, str]]:
    """The subtypes and words of the kept functions of a class."""
    words = words_of(text)
    spoken = text.split()
    return [
        (function.subtype, " ".join(spoken[function.first : function.last + 1]))
        for function in derive_functions(shipped_rules(), Utterance(words, shipped_parser().parse(words)))
        if function.class_name == class_name and function.kept
    ]

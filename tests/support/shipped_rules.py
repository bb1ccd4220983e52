"""What the rules and words we ship find in a text, over real parses."""

from functools import cache
from pathlib import Path

from tests.support.utterances import PARSER, words_of
from understudy.model import Utterance
from understudy.rules.derivation import FunctionRules, derive_functions
from understudy.syntax.parser import Parser

ROOT = Path(__file__).resolve().parents[2]


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

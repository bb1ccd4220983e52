"""What the rules and words we ship find in a text, over real parses."""

from functools import cache

from tests.support.words.utterances import PARSER, words_of
from understudy.model import Fact, Utterance
from understudy.models import load_function_rules
from understudy.rules.derivation import FunctionRules, derive_facts, derive_functions
from understudy.syntax.parser import Parser


@cache
def shipped_rules() -> FunctionRules:
    return load_function_rules()


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


def facts(text: str, predicate: str) -> set[tuple[str, ...]]:
    """What the rules know by a predicate: its texts and numbers as they are, each boundary pair as the words between.

    Only for predicates that end in a span; `at` is for those that end in a position.
    """
    spoken = text.split()
    return {
        (*map(str, fact.arguments[:-2]), " ".join(spoken[int(fact.arguments[-2]) : int(fact.arguments[-1])]))
        for fact in _derived(text)
        if fact.predicate == predicate
    }


def at(text: str, predicate: str) -> set[tuple[str, ...]]:
    """What the rules know by a predicate whose last argument is the position of a word."""
    spoken = text.split()
    return {
        (*map(str, fact.arguments[:-1]), spoken[int(fact.arguments[-1])])
        for fact in _derived(text)
        if fact.predicate == predicate
    }


def _derived(text: str) -> tuple[Fact, ...]:
    words = words_of(text)
    return derive_facts(shipped_rules(), Utterance(words, shipped_parser().parse(words))).facts

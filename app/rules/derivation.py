"""From an utterance to its communicative functions (paper §3.3): facts, lexicon, rules, then conflicts.

The rules lie in `functions/*.rules` over the predicates of `vocabulary.rules`, the words in `lexicon/en/`, and which
functions compete in `functions/conflicts.yaml`. Priorities are numbers, the higher matters more.
"""

from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeVar

from app.authored import Entry, Source
from app.errors import AuthoringError
from app.model import Because, Function, Utterance
from app.rules.chainer import Derivation, Fact, derive
from app.rules.facts import utterance_facts
from app.rules.lexicon import Lexicon
from app.rules.program import Program, load_program

EMPHASIS_RATIO = 0.1
"""The stressed ratio above which the paper emphasises a word (Figure 8)."""

Loaded = TypeVar("Loaded")

_ON_WORDS = frozenset(("lexical", "lemma", "part_of_speech", "tag", "stressed_ratio"))
"""Given facts that speak of the words from their last argument but one to their last."""


class Conflicts(Entry):
    """Which functions compete when they share a word (`functions/conflicts.yaml`)."""

    within_class: frozenset[str]
    within_subtype: frozenset[str]
    between: tuple[tuple[str, str], ...]

    def compete(self, one: Function, other: Function) -> bool:
        """Whether the two cannot both be shown."""
        if one.first > other.last or other.first > one.last:
            return False
        if one.class_name == other.class_name:
            same_subtype = one.subtype == other.subtype and one.class_name in self.within_subtype
            return same_subtype or one.class_name in self.within_class
        pairs = (one.class_name, other.class_name), (other.class_name, one.class_name)
        return any(pair in self.between for pair in pairs)


@dataclass(frozen=True, slots=True, eq=False)
class FunctionRules:
    """All that deriving functions needs, loaded once and never changed."""

    program: Program
    lexicon: Lexicon
    conflicts: Conflicts

    @classmethod
    def load(cls, rules: Path, lexicon: Path) -> "FunctionRules":
        """From the folder `rules` (vocabulary.rules, functions/) and the words of the folder `lexicon`.

        Raises AuthoringError with every mistake of every file.
        """
        paths = (rules / "vocabulary.rules", *sorted((rules / "functions").glob("*.rules")))
        program = _or_mistakes(lambda: load_program(paths))
        words = _or_mistakes(lambda: Lexicon.load(lexicon))
        conflicts = _or_mistakes(lambda: Source(rules / "functions" / "conflicts.yaml").validated(Conflicts))
        if (
            isinstance(program, AuthoringError)
            or isinstance(words, AuthoringError)
            or isinstance(conflicts, AuthoringError)
        ):
            failed = [part for part in (program, words, conflicts) if isinstance(part, AuthoringError)]
            raise AuthoringError(tuple(mistake for error in failed for mistake in error.mistakes))
        return cls(program, words, conflicts)


def derive_functions(
    rules: FunctionRules, utterance: Utterance, *, emphasis_ratio: float = EMPHASIS_RATIO
) -> tuple[Function, ...]:
    """The functions of an utterance in order of first word, last word and class; those that lost a conflict too."""
    given = (
        *utterance_facts(utterance),
        *_lexical_facts(rules.lexicon, utterance),
        Fact("emphasis_threshold", (emphasis_ratio,)),
    )
    derivation = derive(rules.program, given)
    found = sorted(
        (_function(derivation, fact) for fact in derivation.facts if fact.predicate == "fcn"),
        key=lambda function: (function.first, function.last, function.class_name, function.subtype),
    )
    named = [replace(function, id=f"f{number}") for number, function in enumerate(found, start=1)]
    return _resolved(named, rules.conflicts)


def _lexical_facts(lexicon: Lexicon, utterance: Utterance) -> Iterator[Fact]:
    for match in lexicon.matches(utterance):
        yield Fact("lexical", (match.class_name, match.subtype, match.first, match.last + 1))


def _function(derivation: Derivation, fact: Fact) -> Function:
    class_name, subtype, start, end = fact.arguments
    reason = derivation.reasons[fact]
    return Function(
        id="",
        class_name=str(class_name),
        subtype=str(subtype),
        first=int(start),
        last=int(end) - 1,
        priority=derivation.annotations[fact],
        rule=reason.rule,
        because=tuple(dict.fromkeys(_because(derivation, fact))),
    )


def _because(derivation: Derivation, fact: Fact) -> Iterator[Because]:
    """What a derived fact rests on, each support before what it rests on itself, down to the words."""
    waiting = list(reversed(derivation.reasons[fact].supports))
    visited: set[Fact] = set()
    while waiting:
        support = waiting.pop()
        if support in visited:
            continue
        visited.add(support)
        reason = derivation.reason(support)
        if reason is None:
            yield from _because_given(support)
        else:
            yield Because(fact=str(support), rule=reason.rule)
            waiting.extend(reversed(reason.supports))


def _because_given(fact: Fact) -> Iterator[Because]:
    if fact.predicate == "word":
        yield Because(word=int(fact.arguments[1]))
        return
    yield Because(fact=str(fact))
    if fact.predicate in _ON_WORDS:
        start, end = fact.arguments[-2:]
        yield from (Because(word=word) for word in range(int(start), int(end)))


def _resolved(functions: list[Function], conflicts: Conflicts) -> tuple[Function, ...]:
    """The same functions, those marked that lose a conflict to one that is kept."""
    strongest_first = sorted(functions, key=lambda found: (-found.priority, found.first - found.last, found.first))
    kept_on: dict[int, list[Function]] = defaultdict(list)
    lost_to: dict[str, str] = {}
    for function in strongest_first:
        words = range(function.first, function.last + 1)
        rivals = (other for word in words for other in kept_on[word])
        winner = next((other for other in rivals if conflicts.compete(function, other)), None)
        if winner is not None:
            lost_to[function.id] = winner.id
            continue
        for word in words:
            kept_on[word].append(function)
    return tuple(
        replace(function, kept=False, lost_to=lost_to[function.id]) if function.id in lost_to else function
        for function in functions
    )


def _or_mistakes(load: Callable[[], Loaded]) -> Loaded | AuthoringError:
    """What `load` loads, or its mistakes, so that those of other files are found as well."""
    try:
        return load()
    except AuthoringError as error:
        return error

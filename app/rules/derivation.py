"""Derives the communicative functions of an utterance (paper §3.3): facts, lexicon, rules, then conflicts.

The rules are in `functions/*.rules` over the predicates of `vocabulary.rules`, the words in `lexicon/en/`. The existing
functions and their base priorities are in `functions/priorities.yaml`, those that compete in
`functions/conflicts.yaml`. A higher priority means more important. Functions that the author or an agent gives with a
line take part in the derivation as facts, keep their own priority, and win every conflict with derived ones.

A long line is divided into passages, to which rules are applied one by one: many rules compare words with words, so the
cost for a whole line would grow with the square of its length, or worse. A passage is as many whole sentences as have
at most `LONGEST_PASSAGE` words together, so a line of up to a minute is one passage and unaffected. In longer lines,
rules do not see from one passage into the next: a noun last mentioned a minute ago counts as new.
"""

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

from ..errors import AuthoringError, InputError, Mistake, collected
from ..model import Analysis, Because, Fact, Function, GivenFunction, Utterance
from ..yaml_files import Source
from .chaining.chainer import Derivation, derive
from .chaining.facts import LONGEST_SENTENCE, utterance_facts
from .lexicon import Lexicon
from .priorities import Conflicts, Priorities, resolved
from .program.loading import PRINTED, Program, load_program

LONGEST_PASSAGE = LONGEST_SENTENCE
"""Words, about a minute of speech; no sentence is longer."""

_OF_THE_LINE = "utterance"
"""The predicate for the whole line, which is included in every passage, as are facts without a position."""


def passage_starts(facts: Iterable[Fact]) -> list[int]:
    """The boundaries at which the passages begin, given the sentences among `facts`; the first is 0."""
    sentences = sorted(fact.arguments for fact in facts if fact.predicate == "sentence")
    starts = [0]
    for begin, end in sentences:
        assert isinstance(begin, int)
        assert isinstance(end, int)
        if end - starts[-1] > LONGEST_PASSAGE:
            starts.append(begin)
    return starts


def by_passage(starts: Sequence[int], facts: Iterable[Fact]) -> list[list[Fact]]:
    """The facts of each passage: those that begin in it, those at its end, and all without a position. Whole numbers
    among the arguments are positions: boundaries between words."""
    if len(starts) == 1:
        return [list(facts)]
    parts: list[list[Fact]] = [[] for _ in starts]
    for fact in facts:
        places = {place for place in fact.arguments if isinstance(place, int)}
        if not places or fact.predicate == _OF_THE_LINE:
            for part in parts:
                part.append(fact)
            continue
        begin = min(places)
        number = max(bisect_right(starts, begin) - 1, 0)
        parts[number].append(fact)
        if len(places) == 1 and number and starts[number] == begin:
            parts[number - 1].append(fact)
    return parts


GIVEN_PRIORITY = 10.0
"""The default priority, above all that rules derive, so that the movements for them win as well."""

GIVEN_RULE = "given"
GIVEN = Because(fact="given with the line")
"""The support of a given function; `GIVEN_RULE` stands in place of its rule."""

FIELD = "functions"


def given_facts(given: Sequence[GivenFunction], priorities: Priorities, *, words: int) -> Mapping[Fact, float]:
    """The functions as facts with their priorities; if a function is given twice the higher priority counts.

    Raises InputError `functions_class` for an unknown class or subtype, `functions_span` for words that are not among
    the line's `words`.
    """
    facts: dict[Fact, float] = {}
    for number, function in enumerate(given):
        _check(number, function, priorities, words)
        fact = Fact("fcn", (function.class_name, function.subtype, function.first, function.last + 1))
        priority = GIVEN_PRIORITY if function.priority is None else function.priority
        facts[fact] = max(priority, facts.get(fact, priority))
    return facts


def _check(number: int, function: GivenFunction, priorities: Priorities, words: int) -> None:
    where = f"functions[{number}]"
    reason = priorities.unknown(function.class_name, function.subtype)
    if reason:
        raise InputError("functions_class", f"{where}: {reason}", field=FIELD)
    if not 0 <= function.first <= function.last < words:
        span = f"first {function.first}, last {function.last}"
        limits = f"the line's words are 0 to {words - 1}, and first comes before last"
        raise InputError("functions_span", f"{where}: {span}: {limits}", field=FIELD)


Value = TypeVar("Value")

_ON_WORDS = frozenset(("lexical", "lemma", "part_of_speech", "tag", "stressed_ratio", "prominence", "emphasis"))
"""Given facts about the words from their last argument but one to their last."""


@dataclass(frozen=True, slots=True, eq=False)
class FunctionRules:
    """Everything needed to derive functions, loaded once and immutable; `tables` are priorities and conflicts as
    facts."""

    program: Program
    lexicon: Lexicon
    conflicts: Conflicts
    priorities: Priorities
    tables: tuple[Fact, ...]

    @classmethod
    def load(cls, rules: Path, lexicon: Path) -> "FunctionRules":
        """Loads the folder `rules` (vocabulary.rules, functions/) and the words in the folder `lexicon`.

        Raises AuthoringError with all mistakes in all files or, if each loads by itself, with those between files.
        """
        functions = rules / "functions"
        paths = (rules / "vocabulary.rules", *sorted(functions.glob("*.rules")))
        mistakes: list[Mistake] = []
        program = collected(lambda: load_program(paths, printed=PRINTED), mistakes)
        words = collected(lambda: Lexicon.load(lexicon), mistakes)
        conflicts = collected(lambda: Source(functions / "conflicts.yaml").validated(Conflicts), mistakes)
        priorities = collected(lambda: Priorities.load(functions / "priorities.yaml"), mistakes)
        if program is None or words is None or conflicts is None or priorities is None:
            raise AuthoringError(tuple(mistakes))
        unknown = (
            *priorities.mistakes_in_rules(program.rules),
            *priorities.mistakes_in_words(words.entries),
        )
        if unknown:
            raise AuthoringError(unknown)
        return cls(program, words, conflicts, priorities, (*priorities.facts(), *conflicts.facts()))


def derive_functions(
    rules: FunctionRules,
    utterance: Utterance,
    *,
    given: Sequence[GivenFunction] = (),
) -> tuple[Function, ...]:
    """Only the functions of an utterance; see `understand`."""
    return understand(rules, utterance, given=given).functions


def understand(
    rules: FunctionRules,
    utterance: Utterance,
    *,
    given: Sequence[GivenFunction] = (),
) -> Analysis:
    """The functions of an utterance in order of first word, last word and class, including those that lost a conflict,
    and all facts about it, given and derived, in the predicates of `vocabulary.rules`, the functions' own among them.

    `given` are functions that the caller already knows. Raises InputError for an unknown function, or words out of
    range.
    """
    from_outside = given_facts(given, rules.priorities, words=len(utterance.words))
    derivation = derive_facts(rules, utterance, from_outside=from_outside)
    found = sorted(
        (_function(derivation, fact, from_outside) for fact in derivation.facts if fact.predicate == "fcn"),
        key=lambda function: (function.first, function.last, function.class_name, function.subtype),
    )
    named = [replace(function, id=f"f{number}") for number, function in enumerate(found, start=1)]
    return Analysis(utterance, resolved(named, rules.conflicts), facts=derivation.facts)


def derive_facts(
    rules: FunctionRules,
    utterance: Utterance,
    *,
    from_outside: Mapping[Fact, float] = MappingProxyType({}),
) -> Derivation:
    """All facts that the rules derive from an utterance, with functions as facts `fcn`; `from_outside` are given
    functions with their priorities."""
    known = utterance_facts(utterance)
    given = (*known, *_lexical_facts(rules.lexicon, utterance), *rules.tables, *from_outside)
    parts = [
        derive(rules.program, facts, annotations=from_outside) for facts in by_passage(passage_starts(known), given)
    ]
    return parts[0] if len(parts) == 1 else _together(parts)


def _together(parts: Sequence[Derivation]) -> Derivation:
    """The derivations of all passages in one, without duplicates."""
    return Derivation(
        facts=tuple(dict.fromkeys(fact for part in parts for fact in part.facts)),
        choices=tuple(choice for part in parts for choice in part.choices),
        annotations=MappingProxyType(_merged([part.annotations for part in parts])),
        reasons=MappingProxyType(_merged([part.reasons for part in parts])),
    )


def _merged(parts: Iterable[Mapping[Fact, Value]]) -> dict[Fact, Value]:
    """The mappings in one; of several values of a fact the first is kept."""
    merged: dict[Fact, Value] = {}
    for part in parts:
        for fact, value in part.items():
            merged.setdefault(fact, value)
    return merged


def _lexical_facts(lexicon: Lexicon, utterance: Utterance) -> Iterator[Fact]:
    for match in lexicon.matches(utterance):
        yield Fact("lexical", (match.class_name, match.subtype, match.first, match.last + 1))


def _function(derivation: Derivation, fact: Fact, from_outside: Mapping[Fact, float]) -> Function:
    class_name, subtype, start, end = fact.arguments
    first, last = int(start), int(end) - 1
    given = fact in from_outside
    words = (Because(word=word) for word in range(first, last + 1))
    return Function(
        id="",
        class_name=str(class_name),
        subtype=str(subtype),
        first=first,
        last=last,
        priority=from_outside[fact] if given else derivation.annotations[fact],
        rule=GIVEN_RULE if given else derivation.reasons[fact].rule,
        because=(GIVEN, *words) if given else tuple(dict.fromkeys(_because(derivation, fact))),
        given=given,
    )


def _because(derivation: Derivation, fact: Fact) -> Iterator[Because]:
    """The supports of a derived fact, each before its own supports, down to the words."""
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

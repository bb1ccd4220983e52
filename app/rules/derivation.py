"""From an utterance to its communicative functions (paper §3.3): facts, lexicon, rules, then conflicts.

The rules lie in `functions/*.rules` over the predicates of `vocabulary.rules`, the words in `lexicon/en/`. Which
functions there are, and with what priority each begins, is in `functions/priorities.yaml`, which of them compete in
`functions/conflicts.yaml`. Priorities are numbers, the higher matters more.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

from ..errors import AuthoringError, Mistake
from ..model import Because, Function, GivenFunction, Utterance
from ..yaml_files import Source
from .chaining.chainer import Derivation, Fact, derive
from .chaining.facts import utterance_facts
from .conflicts import Conflicts, resolved
from .given import GIVEN, GIVEN_RULE, given_facts
from .lexicon import Lexicon
from .passages import by_passage, passage_starts
from .priorities import Priorities
from .program.program import Program, load_program

Loaded = TypeVar("Loaded")

_ON_WORDS = frozenset(("lexical", "lemma", "part_of_speech", "tag", "stressed_ratio", "prominence", "emphasis"))
"""Given facts that speak of the words from their last argument but one to their last."""


@dataclass(frozen=True, slots=True, eq=False)
class FunctionRules:
    """All that deriving functions needs, loaded once and never changed; `tables`: priorities and conflicts as facts."""

    program: Program
    lexicon: Lexicon
    conflicts: Conflicts
    priorities: Priorities
    tables: tuple[Fact, ...]

    @classmethod
    def load(cls, rules: Path, lexicon: Path) -> "FunctionRules":
        """From the folder `rules` (vocabulary.rules, functions/) and the words of the folder `lexicon`.

        Raises AuthoringError with every mistake of every file, and with those between files where each loads.
        """
        functions = rules / "functions"
        paths = (rules / "vocabulary.rules", *sorted(functions.glob("*.rules")))
        mistakes: list[Mistake] = []
        program = _loaded(lambda: load_program(paths), mistakes)
        words = _loaded(lambda: Lexicon.load(lexicon), mistakes)
        conflicts = _loaded(lambda: Source(functions / "conflicts.yaml").validated(Conflicts), mistakes)
        priorities = _loaded(lambda: Priorities.load(functions / "priorities.yaml"), mistakes)
        if program is None or words is None or conflicts is None or priorities is None:
            raise AuthoringError(tuple(mistakes))
        unknown = (
            *priorities.mistakes_in_rules(program.rules),
            *priorities.mistakes_in_words(words.entries),
        )
        if unknown:
            raise AuthoringError(unknown)
        return cls(program, words, conflicts, priorities, (*priorities.facts(), *conflicts.facts()))


@dataclass(frozen=True, slots=True)
class Understanding:
    """What a line does, and all that is known of how it does it: `facts` are what was parsed, heard and derived, in the
    predicates of `vocabulary.rules`, the functions' own among them."""

    functions: tuple[Function, ...]
    facts: tuple[Fact, ...]


def derive_functions(
    rules: FunctionRules,
    utterance: Utterance,
    *,
    given: Sequence[GivenFunction] = (),
) -> tuple[Function, ...]:
    """The functions of an utterance alone; see `understand`."""
    return understand(rules, utterance, given=given).functions


def understand(
    rules: FunctionRules,
    utterance: Utterance,
    *,
    given: Sequence[GivenFunction] = (),
) -> Understanding:
    """The functions of an utterance in order of first word, last word and class, those that lost a conflict too, and
    the facts they rest on.

    `given` are functions that the caller knows already. Raises InputError for one that is none, or of no words.
    """
    from_outside = given_facts(given, rules.priorities, words=len(utterance.words))
    derivation = derive_facts(rules, utterance, from_outside=from_outside)
    found = sorted(
        (_function(derivation, fact, from_outside) for fact in derivation.facts if fact.predicate == "fcn"),
        key=lambda function: (function.first, function.last, function.class_name, function.subtype),
    )
    named = [replace(function, id=f"f{number}") for number, function in enumerate(found, start=1)]
    return Understanding(resolved(named, rules.conflicts), derivation.facts)


def derive_facts(
    rules: FunctionRules,
    utterance: Utterance,
    *,
    from_outside: Mapping[Fact, float] = MappingProxyType({}),
) -> Derivation:
    """All that the rules derive from an utterance, functions being the facts `fcn`; `from_outside` are functions known
    already, with their priorities."""
    known = utterance_facts(utterance)
    given = (*known, *_lexical_facts(rules.lexicon, utterance), *rules.tables, *from_outside)
    parts = [
        derive(rules.program, facts, annotations=from_outside) for facts in by_passage(passage_starts(known), given)
    ]
    return parts[0] if len(parts) == 1 else _together(parts)


def _together(parts: Sequence[Derivation]) -> Derivation:
    """What was derived from each passage; what all of them know is there once."""
    return Derivation(
        facts=tuple(dict.fromkeys(fact for part in parts for fact in part.facts)),
        choices=tuple(choice for part in parts for choice in part.choices),
        annotations=MappingProxyType(_merged([part.annotations for part in parts])),
        reasons=MappingProxyType(_merged([part.reasons for part in parts])),
    )


def _merged(parts: Iterable[Mapping[Fact, Loaded]]) -> dict[Fact, Loaded]:
    """Every fact with what the first part says of it."""
    merged: dict[Fact, Loaded] = {}
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


def _loaded(load: Callable[[], Loaded], mistakes: list[Mistake]) -> Loaded | None:
    """What `load` loads; None when it cannot, and its mistakes with those of the files before."""
    try:
        return load()
    except AuthoringError as error:
        mistakes.extend(error.mistakes)
        return None

"""Maps communicative functions to the movements that could show them (paper §3.4, Table 2).

The rules in `app/rules/behaviors/` each offer alternatives for a function. The offers of all rules that match form one
pool, in which every alternative gets a random draw. The draws depend only on the seed, the line's text, and the
function's class, subtype and words: lines differ from each other, and adding or removing a function does not change the
draws of others. Which alternative wins is decided over the whole line, with timing, hands and neighbours taken into
account (`app/behavior/choice/choosing.py`).
"""

import random
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isinf, log
from pathlib import Path

from ..errors import AuthoringError, Mistake
from ..model import (
    Alternative,
    BehaviorCandidates,
    CallableNames,
    Demand,
    Fact,
    Function,
    Level,
    MappedFunctions,
    Movement,
    Term,
    Utterance,
)
from .chaining.chainer import Call, Choice, derive
from .chaining.facts import utterance_facts
from .derivation import by_passage, passage_starts
from .language.tree import ChooseClause
from .priorities import Priorities
from .program.loading import PRINTED, Program, Rule, load_program


@dataclass(frozen=True, slots=True)
class MappingRules:
    """The mapping rules, and the predicates they test."""

    program: Program
    asked: frozenset[str]

    @classmethod
    def load(cls, rules: Path, names: CallableNames) -> "MappingRules":
        """Loads the rules in `rules`/behaviors over `rules`/vocabulary.rules, which may call these `names`.

        Raises AuthoringError with every mistake, also for a rule that joins no function, or one that does not exist.
        """
        paths = [rules / "vocabulary.rules", *sorted((rules / "behaviors").glob("*.rules"))]
        program = load_program(paths, behaviors=names, printed=PRINTED)
        mistakes = [
            Mistake(rule.path, rule.line, 1, f"rule {rule.name} maps no function; join `fcn(class, …)`")
            for rule in program.rules
            if rule.kind == "choose" and _weighs(rule) and all(mention.predicate != "fcn" for mention in rule.joins)
        ]
        mistakes += Priorities.load(rules / "functions" / "priorities.yaml").mistakes_in_rules(program.rules)
        if mistakes:
            raise AuthoringError(tuple(mistakes))
        return cls(program, frozenset(index.predicate for index in program.indexes))


def offer_movements(
    rules: MappingRules,
    utterance: Utterance,
    functions: Iterable[Function],
    *,
    seed: int,
    facts: Sequence[Fact] = (),
) -> tuple[BehaviorCandidates, ...]:
    """The movements that could show each kept function, in order of the functions' words (paper §3.4)."""
    return map_functions(rules, utterance, functions, seed=seed, facts=facts).offers


def map_functions(
    rules: MappingRules,
    utterance: Utterance,
    functions: Iterable[Function],
    *,
    seed: int,
    facts: Sequence[Fact] = (),
) -> MappedFunctions:
    """The movements that could show each kept function, in order of the functions' words (paper §3.4), and what comes
    always or never, for a function or not.

    `facts` are all facts about the line (`derivation.understand`), for conditions of mapping rules; without them only
    the facts from audio and parse are known. Without audio the agitation counts as medium. Raises AuthoringError for a
    rule that calls a behaviour with arguments that are not a span.
    """
    kept = {_fact(function): function for function in functions if function.kept}
    pools, demands = _pools(rules, facts or utterance_facts(utterance), kept)
    text = " ".join(word.text for word in utterance.words)
    offers = tuple(
        BehaviorCandidates(kept[fact], tuple(_alternatives(pool, kept[fact], f"{seed} {text}")))
        for fact, pool in sorted(pools.items(), key=lambda item: _place(kept[item[0]]))
    )
    return MappedFunctions(offers, tuple(dict.fromkeys(demands)))


@dataclass(frozen=True, slots=True)
class _Offer:
    """The movements of a rule, and their weight."""

    choice: Choice
    weight: float
    calls: tuple[Call, ...]


def _pools(
    rules: MappingRules, known: Sequence[Fact], kept: Mapping[Fact, Function]
) -> tuple[dict[Fact, list[_Offer]], list[Demand]]:
    """The offers for each function, and the demands; a rule that joins several functions shows the first one."""
    given = [fact for fact in known if fact.predicate in rules.asked and fact.predicate != "fcn"]
    if not any(fact.predicate == "agitation" for fact in given):
        given.append(Fact("agitation", (Level.MEDIUM.value,)))
    priorities = {fact: function.priority for fact, function in kept.items()}
    pools: defaultdict[Fact, list[_Offer]] = defaultdict(list)
    demands: list[Demand] = []
    for part in by_passage(passage_starts(known), [*given, *kept]):
        for choice in derive(rules.program, part, annotations=priorities).choices:
            function = next((fact for fact in choice.supports if fact in kept), None)
            for each in choice.alternatives:
                if isinf(each.weight):
                    demands += _demands(_Offer(choice, each.weight, each.calls), kept[function] if function else None)
                elif function is not None:
                    pools[function].append(_Offer(choice, each.weight, each.calls))
    return pools, demands


def _demands(offer: _Offer, function: Function | None) -> Iterator[Demand]:
    by, shown = f"rule {offer.choice.rule}", function.id if function else None
    for call in offer.calls:
        first, last = _span(offer, call)
        yield Demand(call.name, first, last, offer.weight > 0, by, shown)


def _weighs(rule: Rule) -> bool:
    """Whether a rule offers anything by weight, for a function, rather than demand it for any fact."""
    choices = (part for part in rule.tree.conclusions if isinstance(part, ChooseClause))
    return any(not isinf(each.weight) for choice in choices for each in choice.alternatives)


def _fact(function: Function) -> Fact:
    return Fact("fcn", (function.class_name, function.subtype, function.first, function.last + 1))


def _place(function: Function) -> tuple[int, int, str, str]:
    return function.first, function.last, function.class_name, function.subtype


def _alternatives(pool: list[_Offer], function: Function, seed: str) -> Iterator[Alternative]:
    identity = f"{function.class_name} {function.subtype} {function.first} {function.last}"
    generator = random.Random(f"{identity} {seed}")
    for offer in pool:
        lot = generator.expovariate(1.0)
        yield Alternative(tuple(_movements(offer, function, _parts(offer, function, lot))), offer.weight, lot)


def _parts(offer: _Offer, function: Function, lot: float) -> tuple[Term, ...]:
    """What decides by priority alone, the largest first: the function's priority, which comes before all else, and of
    its alternatives the one with the greatest ln(weight) - ln(lot)."""
    parts = [
        Term(f"priority {function.priority:g} of {function.class_name}", function.priority),
        Term(f"rule {offer.choice.rule}, weight {offer.weight:g}", round(log(offer.weight), 2)),
        Term("chance", round(-log(lot), 2)),
    ]
    return tuple(sorted(parts, key=lambda part: -abs(part.weight)))


def _movements(offer: _Offer, function: Function, parts: tuple[Term, ...]) -> Iterator[Movement]:
    for call in offer.calls:
        first, last = _span(offer, call)
        yield Movement(call.name, first, last, function.priority, offer.choice.rule, function.id, decided_by=parts)


def _span(offer: _Offer, call: Call) -> tuple[int, int]:
    """The first and last word of a call."""
    match call.arguments:
        case (int(start), int(end)) if start < end:
            return start, end - 1
        case _:
            arguments = ", ".join(map(str, call.arguments))
            raise offer.choice.origin.error(
                f"{call.name}({arguments}) is not a span; give it the start and end of words"
            )

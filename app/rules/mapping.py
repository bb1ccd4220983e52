"""From communicative functions to the movements that show them (paper §3.4, Table 2).

The rules in `app/rules/behaviors/` each offer alternatives for a function. Those of all rules that hold for a function
are one pool, from which one alternative is drawn by weight. The draw depends on the seed, on the line's text and on
what the function is (class, subtype, words) alone: lines vary among each other, and a function that comes or goes
leaves the movements of the others as they were, but for the one heuristic: no movement twice within
`REPEAT_WINDOW_WORDS` where the pool has something else (§3.4; that hands do not switch needlessly is seen to where
hands are known, in the schedule).
"""

import random
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from app.errors import AuthoringError, Mistake
from app.model import Function, Level, Movement, Utterance
from app.rules.chainer import Alternative, Choice, Fact, derive
from app.rules.facts import utterance_facts
from app.rules.program import Program, load_program

REPEAT_WINDOW_WORDS = 12
"""About five seconds of speech."""


@dataclass(frozen=True, slots=True)
class MappingRules:
    """The mapping rules, and the predicates they ask for."""

    program: Program
    asked: frozenset[str]

    @classmethod
    def load(cls, rules: Path, behavior_names: Collection[str]) -> "MappingRules":
        """The rules in `rules`/behaviors over `rules`/vocabulary.rules, which may choose `behavior_names`.

        Raises AuthoringError with every mistake, also for a rule that speaks of no function.
        """
        paths = [rules / "vocabulary.rules", *sorted((rules / "behaviors").glob("*.rules"))]
        program = load_program(paths, behaviors=behavior_names)
        mistakes = tuple(
            Mistake(rule.path, rule.line, 1, f"rule {rule.name} maps no function; join `fcn(class, …)`")
            for rule in program.rules
            if rule.kind == "choose" and all(mention.predicate != "fcn" for mention in rule.joins)
        )
        if mistakes:
            raise AuthoringError(mistakes)
        return cls(program, frozenset(index.predicate for index in program.indexes))


@dataclass(frozen=True, slots=True)
class _Option:
    """An alternative of a pool, with the choice that offers it."""

    choice: Choice
    alternative: Alternative

    @property
    def names(self) -> frozenset[str]:
        return frozenset(call.name for call in self.alternative.calls)


def choose_movements(
    rules: MappingRules, utterance: Utterance, functions: Iterable[Function], *, seed: int
) -> tuple[Movement, ...]:
    """The movements for the kept functions, in order of the functions' words (paper §3.4).

    Where nothing was heard the agitation counts as medium. Movements of one drawn alternative share their
    `alternative` number. Raises AuthoringError for a rule that calls a behaviour on anything but a span.
    """
    kept = {_fact(function): function for function in functions if function.kept}
    pools = _pools(rules, utterance, kept)
    text = " ".join(word.text for word in utterance.words)
    last_use: dict[str, int] = {}
    movements: list[Movement] = []
    for number, (function, pool) in enumerate(sorted(pools.items(), key=lambda item: _place(kept[item[0]]))):
        drawn = _drawn(kept[function], _without_repeats(pool, kept[function].first, last_use), f"{seed} {text}")
        movements += _movements(drawn, kept[function], number)
        last_use |= dict.fromkeys(drawn.names, kept[function].first)
    return tuple(movements)


def _pools(rules: MappingRules, utterance: Utterance, kept: Mapping[Fact, Function]) -> dict[Fact, list[_Option]]:
    """The options for each function; a rule that joins several functions shows the first it names."""
    given = [fact for fact in utterance_facts(utterance) if fact.predicate in rules.asked]
    if utterance.agitation is None:
        given.append(Fact("agitation", (Level.MEDIUM.value,)))
    priorities = {fact: function.priority for fact, function in kept.items()}
    pools: defaultdict[Fact, list[_Option]] = defaultdict(list)
    for choice in derive(rules.program, [*given, *kept], annotations=priorities).choices:
        function = next(fact for fact in choice.supports if fact in kept)
        pools[function] += [_Option(choice, alternative) for alternative in choice.alternatives]
    return pools


def _fact(function: Function) -> Fact:
    return Fact("fcn", (function.class_name, function.subtype, function.first, function.last + 1))


def _place(function: Function) -> tuple[int, int, str, str]:
    return function.first, function.last, function.class_name, function.subtype


def _without_repeats(pool: list[_Option], word: int, last_use: Mapping[str, int]) -> list[_Option]:
    """The options with no movement that was used shortly before `word`; all of them when that leaves none."""
    recent = {name for name, used in last_use.items() if word - used < REPEAT_WINDOW_WORDS}
    return [option for option in pool if not option.names & recent] or pool


def _drawn(function: Function, pool: list[_Option], seed: str) -> _Option:
    identity = f"{function.class_name} {function.subtype} {function.first} {function.last}"
    generator = random.Random(f"{identity} {seed}")
    return generator.choices(pool, [option.alternative.weight for option in pool])[0]


def _movements(drawn: _Option, function: Function, number: int) -> Iterator[Movement]:
    for call in drawn.alternative.calls:
        match call.arguments:
            case (int(start), int(end)) if start < end:
                yield Movement(
                    name=call.name,
                    first=start,
                    last=end - 1,
                    priority=function.priority,
                    rule=drawn.choice.rule,
                    function=function.id,
                    alternative=number,
                )
            case _:
                arguments = ", ".join(map(str, call.arguments))
                raise drawn.choice.origin.error(
                    f"{call.name}({arguments}) is no span; give it the start and end of words"
                )

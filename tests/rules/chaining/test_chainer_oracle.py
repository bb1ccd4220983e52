"""Generated programs derive the same facts here and in CLIPS, the oracle.

Programs have layers: a rule of a layer joins facts of its own and lower layers and excludes facts of lower layers
only, so that there is always an order. In CLIPS the order of layers is that of saliences. The first argument of every
predicate is a symbol, the others are numbers.
"""

import tempfile
from dataclasses import dataclass
from pathlib import Path

import clips
from hypothesis import given
from hypothesis import strategies as st

from tests.support.examples import examples
from understudy.model import Fact
from understudy.rules.chaining.chainer import derive
from understudy.rules.program.loading import load_program

LAYERS = 3
ARITIES = {f"p{layer}{number}": number + 1 for layer in range(LAYERS) for number in range(3)}
SYMBOLS = ["a", "b", "c"]
NUMBERS = [0, 1, 2, 3]
HIGHEST = 5
ORDERINGS = ["<", "<=", ">", ">="]


@dataclass(frozen=True)
class Pattern:
    predicate: str
    terms: tuple[str, ...]


@dataclass(frozen=True)
class Rule:
    """`guards` are (operator, left, right); `sum` is (total, addend) with total = addend + 1, or two empty strings."""

    layer: int
    joined: tuple[Pattern, ...]
    excluded: tuple[Pattern, ...]
    guards: tuple[tuple[str, str, str], ...]
    sum: tuple[str, str]
    head: Pattern


# Terms as often as they stand here: variables often, so that rules find something to join.
SYMBOL_TERMS = ["$s", "$s", "$t", "_", "a|c", "a", "b", "c"]
NUMBER_TERMS = ["$m", "$m", "$n", "$n", "$k", "_", "1|2", "0", "3"]


@st.composite
def patterns(draw: st.DrawFn, predicates: list[str], symbols: list[str], numbers: list[str]) -> Pattern:
    predicate = draw(st.sampled_from(predicates))
    first = draw(st.sampled_from(symbols))
    return Pattern(predicate, (first, *(draw(st.sampled_from(numbers)) for _ in range(ARITIES[predicate] - 1))))


@st.composite
def rules(draw: st.DrawFn, layer: int) -> Rule:
    upto = [name for name in ARITIES if int(name[1]) <= layer]
    joined = tuple(draw(st.lists(patterns(upto, SYMBOL_TERMS, NUMBER_TERMS), min_size=1, max_size=3)))
    bound = {term for pattern in joined for term in pattern.terms}
    symbols = sorted(bound & set(SYMBOL_TERMS[:3]))
    numbers = sorted(bound & set(NUMBER_TERMS[:5]))
    total = draw(st.sampled_from(["", "$new", "$new", *numbers])) if numbers else ""
    addend = draw(st.sampled_from(numbers)) if total else ""
    guards = draw(st.lists(comparisons(symbols, numbers), max_size=1)) if symbols or numbers else []
    guards += [("<", addend, str(HIGHEST))] if total else []
    numbers += [total] if total == "$new" else []
    below = [name for name in upto if int(name[1]) < layer]
    bounded = patterns(below, ["_", "b|c", *SYMBOLS, *symbols], ["_", "0|3", *map(str, NUMBERS), *numbers])
    excluded = draw(st.lists(bounded, max_size=2)) if below else []
    own = [name for name in upto if int(name[1]) == layer]
    head = draw(patterns(own, [*SYMBOLS, *symbols * 3], [*map(str, NUMBERS), *numbers * 3]))
    return Rule(layer, joined, tuple(excluded), tuple(guards), (total, addend), head)


@st.composite
def comparisons(draw: st.DrawFn, symbols: list[str], numbers: list[str]) -> tuple[str, str, str]:
    if symbols and (not numbers or draw(st.booleans())):
        sign = draw(st.sampled_from(["==", "!=", "!="]))
        return sign, draw(st.sampled_from(symbols)), draw(st.sampled_from([*symbols, *SYMBOLS]))
    sign = draw(st.sampled_from([*ORDERINGS, "==", "!=", "!="]))
    return sign, draw(st.sampled_from(numbers)), draw(st.sampled_from([*numbers, *map(str, NUMBERS)]))


@st.composite
def facts_of(draw: st.DrawFn, name: str) -> tuple[str | int, ...]:
    return (name, draw(st.sampled_from(SYMBOLS)), *(draw(st.sampled_from(NUMBERS)) for _ in range(ARITIES[name] - 1)))


@st.composite
def programs(draw: st.DrawFn) -> list[Rule]:
    return [rule for layer in range(LAYERS) for rule in draw(st.lists(rules(layer), min_size=1, max_size=4))]


givens = st.lists(st.sampled_from(sorted(ARITIES)).flatmap(facts_of), min_size=6, max_size=25)


@examples(50)
@given(program=programs(), facts=givens)
def test_the_same_facts_as_clips(program: list[Rule], facts: list[tuple[str | int, ...]]) -> None:
    assert _ours(program, facts) == _theirs(program, facts)


def test_the_oracle_excludes_and_computes() -> None:
    """A program of which the facts are known by hand: what both sides are compared on is not nothing."""
    program = [
        Rule(
            0, (Pattern("p01", ("$s", "$n")),), (), (("<", "$n", "5"),), ("$new", "$n"), Pattern("p01", ("$s", "$new"))
        ),
        Rule(1, (Pattern("p01", ("$s", "3")),), (Pattern("p00", ("$s",)),), (), ("", ""), Pattern("p10", ("$s",))),
    ]
    facts: list[tuple[str | int, ...]] = [("p01", "a", 2), ("p01", "b", 3), ("p00", "b")]
    expected = {*facts, *(("p01", "a", n) for n in (3, 4, 5)), ("p01", "b", 4), ("p01", "b", 5), ("p10", "a")}
    assert _ours(program, facts) == expected
    assert _theirs(program, facts) == expected


def _ours(program: list[Rule], facts: list[tuple[str | int, ...]]) -> set[tuple[str | int | float, ...]]:
    lines = [f"predicate {name}({', '.join(f'x{n}' for n in range(arity))})" for name, arity in ARITIES.items()]
    for number, rule in enumerate(program):
        lines += [f"rule r{number}", "foreach"]
        lines += [_call(pattern) for pattern in rule.joined]
        lines += [f"unless {_call(pattern)}" for pattern in rule.excluded]
        lines += [f"{left} {sign} {right}" for sign, left, right in rule.guards]
        lines += [f"{rule.sum[0]} = {rule.sum[1]} + 1"] if rule.sum[0] else []
        lines += ["assert", _call(rule.head)]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "generated.rules"
        path.write_text("\n".join(lines), encoding="utf-8")
        loaded = load_program([path])
    derivation = derive(loaded, [Fact(str(name), tuple(arguments)) for name, *arguments in facts])
    return {(fact.predicate, *fact.arguments) for fact in derivation.facts}


def _call(pattern: Pattern) -> str:
    return f"{pattern.predicate}({', '.join(pattern.terms)})"


def _theirs(program: list[Rule], facts: list[tuple[str | int, ...]]) -> set[tuple[str | int | float, ...]]:
    environment = clips.Environment()
    for number, rule in enumerate(program):
        environment.build(_defrule(number, rule))
    for fact in facts:
        environment.assert_string(f"({' '.join(map(str, fact))})")
    environment.run()
    return {(fact.template.name, *(_plain(value) for value in fact)) for fact in environment.facts()}


def _defrule(number: int, rule: Rule) -> str:
    conditions = [_ordered(pattern) for pattern in rule.joined]
    conditions += [f"(test ({_sign(sign)} {_term(left)} {_term(right)}))" for sign, left, right in rule.guards]
    computed = {}
    total, addend = rule.sum
    if total == "$new":
        computed["$new"] = f"(+ {_term(addend)} 1)"
    elif total:
        conditions.append(f"(test (= {_term(total)} (+ {_term(addend)} 1)))")
    conditions += [f"(not {_ordered(pattern, computed)})" for pattern in rule.excluded]
    action = " ".join(computed.get(term, _term(term)) for term in rule.head.terms)
    return (
        f"(defrule r{number} (declare (salience {-rule.layer})) {' '.join(conditions)}"
        f" => (assert ({rule.head.predicate} {action})))"
    )


def _ordered(pattern: Pattern, computed: dict[str, str] | None = None) -> str:
    """The pattern as CLIPS writes it; what is computed stands there as `=(...)`."""
    terms = [f"={computed[term]}" if computed and term in computed else _term(term) for term in pattern.terms]
    return f"({pattern.predicate} {' '.join(terms)})"


def _term(term: str) -> str:
    if term == "_":
        return "?"
    return f"?{term[1:]}" if term.startswith("$") else term


def _sign(sign: str) -> str:
    return {"==": "eq", "!=": "neq"}.get(sign, sign)


def _plain(value: object) -> str | int | float:
    return value if isinstance(value, int | float) else str(value)

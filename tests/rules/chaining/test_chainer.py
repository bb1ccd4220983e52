"""Derivations: joins, guards, `unless`, annotations, choices, reasons, limits; and that order never matters."""

import os
import random
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import pytest

from tests.support.operations import operations_of
from understudy.errors import AuthoringError
from understudy.model import Fact
from understudy.rules.chaining.chainer import (
    Call,
    Derivation,
    Limits,
    derive,
)
from understudy.rules.program.loading import Program, load_program

DECLARATIONS = """
predicate word(text, start, end)
predicate level(value)
predicate near(one, other)
predicate number(value)
predicate rain()
predicate fcn(class, start, end, priority max)
"""

Load = Callable[[str], Program]


@pytest.fixture
def load(tmp_path: Path) -> Load:
    def loaded(rules: str) -> Program:
        path = tmp_path / "test.rules"
        path.write_text(DECLARATIONS + rules, encoding="utf-8")
        return load_program([path])

    return loaded


def fact(predicate: str, *arguments: str | int | float) -> Fact:
    return Fact(predicate, arguments)


def words(text: str) -> list[Fact]:
    return [fact("word", word, start, start + 1) for start, word in enumerate(text.split())]


def derived(derivation: Derivation) -> set[Fact]:
    return {known for known in derivation.facts if derivation.reason(known) is not None}


def test_shared_variables_join(load: Load) -> None:
    program = load("rule touch\nforeach\n word(a, _, $m)\n word(b, $m, $e)\nassert\n near($m, $e)")
    assert derived(derive(program, words("a b b a a b"))) == {fact("near", 1, 2), fact("near", 5, 6)}


def test_a_variable_twice_in_a_pattern_must_have_one_value(load: Load) -> None:
    program = load("rule same\nforeach\n near($x, $x)\nassert\n level($x)")
    assert derived(derive(program, [fact("near", 1, 2), fact("near", 2, 2)])) == {fact("level", 2)}


def test_alternatives_match_any_of_their_constants(load: Load) -> None:
    program = load('rule either\nforeach\n word(a|"don\'t", $s, _)\nassert\n number($s)')
    assert derived(derive(program, words("a b don't c"))) == {fact("number", 0), fact("number", 2)}


def test_whole_and_fractional_numbers_join_when_equal(load: Load) -> None:
    program = load("rule equal\nforeach\n level($x)\n number($x)\nassert\n near($x, 2)")
    assert derived(derive(program, [fact("level", 3), fact("number", 3.0)])) == {fact("near", 3, 2)}


def test_a_fact_needs_no_arguments(load: Load) -> None:
    program = load("rule wet\nforeach\n rain()\nassert\n level(wet)")
    assert derived(derive(program, [fact("rain")])) == {fact("level", "wet")}
    assert derived(derive(program, [])) == set()


@pytest.mark.parametrize(
    ("guard", "holding"),
    [
        ("$x < 2", [1]),
        ("$x <= 2", [1, 2]),
        ("$x > 2", [3]),
        ("$x >= 2", [2, 3]),
        ("$x == 2", [2]),
        ("$x != 2", [1, 3]),
        ("$x + 1 == 4 - 2", [1]),
        ("$x * 2 > 6 / 2", [2, 3]),
        ("-$x < -(1 + 1)", [3]),
        ("max(min($x, 2), 0) == round(1.6)", [2, 3]),
        ("abs(-$x) == increase_priority($x, 1) - 1", [1, 2, 3]),
    ],
)
def test_guards_and_arithmetic(load: Load, guard: str, holding: list[int]) -> None:
    program = load(f"rule guarded\nforeach\n number($x)\n {guard}\nassert\n level($x)")
    found = derived(derive(program, [fact("number", value) for value in (1, 2, 3)]))
    assert found == {fact("level", value) for value in holding}


def test_a_computed_value_joins_wherever_it_is_written(load: Load) -> None:
    before = "$next = $s + 2\n word(a, $s, _)\n word(b, $next, _)"
    after = "word(b, $next, _)\n word(a, $s, _)\n $next = $s + 2"
    for body in (before, after):
        program = load(f"rule skip\nforeach\n {body}\nassert\n near($s, $next)")
        assert derived(derive(program, words("a c b a b"))) == {fact("near", 0, 2)}


def test_unless_is_asked_when_all_that_it_asks_about_is_known(load: Load) -> None:
    program = load(
        "rule plain\nforeach\n word($w, $s, $e)\n unless fcn(_, $s, $e, _)\nassert\n level($w)\n"
        "rule late\nforeach\n number($s)\n word(_, $s, $e)\nassert\n fcn(deep, $s, $e, 1)\n"
        "rule early\nforeach\n word(a, $s, _)\nassert\n number($s)\n"
    )
    assert fact("level", "b") in derive(program, words("a b")).facts
    assert fact("level", "a") not in derive(program, words("a b")).facts


def test_rules_may_exclude_one_class_and_assert_another(load: Load) -> None:
    program = load(
        "rule no\nforeach\n word(no, $s, $e)\nassert\n fcn(negation, $s, $e, 1)\n"
        "rule yes\nforeach\n word(_, $s, $e)\n unless fcn(negation, $s, $e, _)\nassert\n fcn(affirmation, $s, $e, 1)"
    )
    assert derived(derive(program, words("yes no"))) == {
        fact("fcn", "affirmation", 0, 1),
        fact("fcn", "negation", 1, 2),
    }


def test_the_highest_annotation_counts(load: Load) -> None:
    program = load(
        "rule low\nforeach\n word(_, $s, $e)\nassert\n fcn(x, $s, $e, 2)\n"
        "rule high\nforeach\n word(a, $s, $e)\nassert\n fcn(x, $s, $e, 7)\n"
    )
    derivation = derive(program, words("a b"))
    assert [derivation.annotation(fact("fcn", "x", start, start + 1)) for start in (0, 1)] == [7, 2]
    assert derivation.annotation(fact("word", "a", 0, 1)) is None


def test_given_annotations_count_and_are_else_zero(load: Load) -> None:
    program = load("rule low\nforeach\n word(_, $s, $e)\nassert\n fcn(x, $s, $e, 2)")
    high, other = fact("fcn", "x", 0, 1), fact("fcn", "y", 0, 1)
    derivation = derive(program, [*words("a"), high, other], annotations={high: 5})
    assert (derivation.annotation(high), derivation.annotation(other)) == (5, 0)


RAISING = """
rule base
foreach
  word($w, $s, $e)
assert
  fcn(x, $s, $e, 3)
rule raise_by_one
foreach
  fcn($c, $s, $e, $p)
  level(loud)
assert
  fcn($c, $s, $e, increase_priority($p))
rule raise_by_two
foreach
  fcn($c, $s, $e, $p)
  level(louder)
  $new = $p + 2
assert
  fcn($c, $s, $e, $new)
rule whole
foreach
  fcn(x, $s, $m, $p)
  fcn(x, $m, $e, $q)
assert
  fcn(pair, $s, $e, increase_priority($p, $q))
"""


def test_a_rule_raises_what_it_joins_once_and_before_others_read_it(load: Load) -> None:
    derivation = derive(load(RAISING), [*words("a b"), fact("level", "loud")])
    assert derivation.annotation(fact("fcn", "x", 0, 1)) == 4
    assert derivation.annotation(fact("fcn", "pair", 0, 2)) == 6


def test_two_rules_that_raise_one_fact_do_not_add_up(load: Load) -> None:
    derivation = derive(load(RAISING), [*words("a"), fact("level", "loud"), fact("level", "louder")])
    assert derivation.annotation(fact("fcn", "x", 0, 1)) == 5


def test_facts_that_raise_each_other_come_to_rest(load: Load) -> None:
    """x is 3, so y claims 4; then x claims 4 from y: each claim is made once, and no more."""
    program = load(
        "rule x\nforeach\n level(on)\nassert\n fcn(x, 0, 1, 3)\n"
        "rule to_y\nforeach\n fcn(x, $s, $e, $p)\nassert\n fcn(y, $s, $e, $p + 1)\n"
        "rule to_x\nforeach\n fcn(y, $s, $e, $p)\nassert\n fcn(x, $s, $e, $p)"
    )
    derivation = derive(program, [fact("level", "on")])
    assert derivation.annotation(fact("fcn", "y", 0, 1)) == 4
    assert derivation.annotation(fact("fcn", "x", 0, 1)) == 4


def test_the_reason_is_the_first_derivation_and_goes_down_to_the_words(load: Load) -> None:
    program = load(RAISING + "rule again\nforeach\n word($w, $s, $e)\nassert\n fcn(x, $s, $e, 9)")
    derivation = derive(program, words("a b"))
    pair = fact("fcn", "pair", 0, 2)
    reason = derivation.reason(pair)
    assert reason is not None
    assert reason.rule == "whole"
    assert reason.supports == (fact("fcn", "x", 0, 1), fact("fcn", "x", 1, 2))
    first = derivation.reason(fact("fcn", "x", 0, 1))
    assert first is not None
    assert (first.rule, first.path.name) == ("base", "test.rules")
    assert first.path.read_text(encoding="utf-8").split("\n")[first.line - 1] == "rule base"
    assert derivation.reason(words("a b")[0]) is None


CHOOSING = """
rule x
foreach
  word(a, $s, $e)
assert
  fcn(x, $s, $e, 3)
rule show
foreach
  fcn(x, $s, $e, $p)
  level($level)
choose
  weight 3 when $level != high
    nod($s, $e)
  weight 0.5 when $level == high and $s > 0
    beat($s + 0.5, $e, $p)
    nod(twice, $e)
"""


def test_choices_offer_the_alternatives_whose_guards_hold(load: Load) -> None:
    program = load(CHOOSING)
    [calm] = derive(program, [*words("a"), fact("level", "low")]).choices
    assert [(one.weight, one.calls) for one in calm.alternatives] == [(3, (Call("nod", (0, 1)),))]
    assert (calm.rule, calm.supports) == ("show", (fact("fcn", "x", 0, 1), fact("level", "low")))
    [wild] = derive(program, [*words("b a"), fact("level", "high")]).choices
    calls = (Call("beat", (1.5, 2, 3)), Call("nod", ("twice", 2)))
    assert [(one.weight, one.calls) for one in wild.alternatives] == [(0.5, calls)]


def test_there_is_no_choice_where_no_guard_holds(load: Load) -> None:
    assert derive(load(CHOOSING), [*words("a"), fact("level", "high")]).choices == ()


def test_the_order_of_the_given_facts_does_not_matter(load: Load) -> None:
    program = load(RAISING + CHOOSING.replace("rule x", "rule x2"))
    given = [*words("a b a a c"), *(fact("level", level) for level in ("loud", "louder", "high", 3))]
    expected = derive(program, given)
    draw = random.Random(1)
    for _ in range(20):
        draw.shuffle(given)
        assert derive(program, given) == expected


def test_hash_seeds_do_not_matter(load: Load, tmp_path: Path) -> None:
    load(RAISING)
    script = (
        "import sys, pathlib; from understudy.rules.program.loading import load_program;"
        "from understudy.rules.chaining.chainer import derive, Fact;"
        "program = load_program([pathlib.Path(sys.argv[1])]);"
        "given = {Fact('word', (text, s, s + 1)) for s, text in enumerate('abcdefg')} | {Fact('level', ('loud',))};"
        "print(derive(program, given))"
    )
    outputs = {
        subprocess.run(
            [sys.executable, "-c", script, str(tmp_path / "test.rules")],
            env={**os.environ, "PYTHONHASHSEED": seed},
            cwd=Path(__file__).parents[3],
            check=True,
            capture_output=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(outputs) == 1


def test_threads_share_a_program(load: Load) -> None:
    program = load(RAISING + CHOOSING.replace("rule x", "rule x2"))
    lines = [[*words(" ".join(random.Random(n).choices("abc", k=12))), fact("level", "loud")] for n in range(16)]
    alone = [derive(program, line) for line in lines]
    with ThreadPoolExecutor(8) as threads:
        together = list(threads.map(lambda line: derive(program, line), lines * 4))
    assert together == alone * 4


COUNTING = "rule count\nforeach\n number($x)\n $next = $x + 1\nassert\n number($next)"


@pytest.mark.parametrize("limits", [Limits(facts=50), Limits(rounds=50), Limits()])
def test_endless_rules_are_stopped_by_name(load: Load, limits: Limits) -> None:
    with pytest.raises(AuthoringError, match=r"test\.rules:\d+:6: rule count: .*is a computation endless"):
        derive(load(COUNTING), [fact("number", 0)], limits=limits)


def test_limits_are_just_enough(load: Load) -> None:
    program = load(COUNTING.replace("number($x)\n", "number($x)\n $x < 9\n"))
    assert len(derive(program, [fact("number", 0)], limits=Limits(facts=10, rounds=10)).facts) == 10
    for limits in (Limits(facts=9), Limits(rounds=9)):
        with pytest.raises(AuthoringError):
            derive(program, [fact("number", 0)], limits=limits)


@pytest.mark.parametrize(
    ("statement", "value", "message"),
    [
        ("$x < 3", "high", "`<` takes numbers, and 'high' is a text"),
        ("$y = 1 / $x", 0, "1 / 0 divides by zero"),
        ("$y = max($x, 1)", "high", "`max` takes numbers, and 'high' is a text"),
        ("$y = $x * $x", 10**12, "the result 1e+24 is beyond 1e+15"),
    ],
)
def test_what_cannot_be_computed_is_reported_at_its_place(
    load: Load, statement: str, value: str | int, message: str
) -> None:
    program = load(f"rule bad\nforeach\n number($x)\n {statement}\nassert\n level($x)")
    with pytest.raises(AuthoringError) as raised:
        derive(program, [fact("number", value)])
    [mistake] = raised.value.mistakes
    assert mistake.message == f"rule bad: {message}"
    assert mistake.source_line.strip() == statement


@pytest.mark.parametrize("wrong", [fact("fcn", "x", 0, 1, 5), fact("no_progress", 1), fact("word", "a", 0)])
def test_given_facts_must_be_declared(load: Load, wrong: Fact) -> None:
    with pytest.raises(ValueError, match="no such predicate is declared"):
        derive(load(COUNTING), [wrong])


BETWEEN = "rule between\nforeach\n near($s, $e)\n number($p)\n $s <= $p\n $p < $e - 1\nassert\n level($p)"
MANY = 400


def test_what_lies_between_two_numbers_is_found_among_many(load: Load) -> None:
    facts = [fact("number", number / 2) for number in range(MANY)]
    spans = [fact("near", 3, 6), fact("near", 100, 100), fact("near", 5, 8)]
    expected = {fact("level", number) for number in (3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5)}
    assert derived(derive(load(BETWEEN), [*facts, *spans])) == expected


def test_what_lies_between_is_found_among_facts_that_come_later(load: Load) -> None:
    count = f"rule count\nforeach\n number($n)\n $n < {MANY}\n $m = $n + 1\nassert\n number($m)\n\n"
    derivation = derive(load(count + BETWEEN), [fact("number", 0), fact("near", 300, 304), fact("near", 1, 4)])
    assert {known for known in derived(derivation) if known.predicate == "level"} == {
        fact("level", number) for number in (1, 2, 300, 301, 302)
    }


def test_of_many_facts_only_those_between_are_looked_at(load: Load) -> None:
    program, spans = load(BETWEEN), [fact("near", number, number + 3) for number in range(MANY)]
    half, whole = (
        operations_of(partial(derive, program, [*spans[:count], *(fact("number", each) for each in range(count))]))
        for count in (MANY // 2, MANY)
    )
    assert whole <= 2.2 * half


def test_a_text_among_the_numbers_is_the_rules_mistake(load: Load) -> None:
    facts = [fact("number", number) for number in range(30)]
    with pytest.raises(AuthoringError, match="between: "):
        derive(load(BETWEEN), [*facts, fact("number", "many"), fact("near", 3, 6)])

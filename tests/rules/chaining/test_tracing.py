"""Traces for authors: all rules that fired, and what was missing where one nearly did."""

from pathlib import Path

import pytest

from tests.support.shipped_rules import shipped_parser, shipped_rules
from tests.support.words.utterances import words_of
from understudy.model import Fact, Utterance
from understudy.rules.chaining.chainer import derive
from understudy.rules.chaining.matching import FactBase
from understudy.rules.chaining.tracing import ObstacleKind, RuleTrace, ShownStatement, fires, trace_rule, trace_rules
from understudy.rules.derivation import derive_facts
from understudy.rules.program.loading import Program, load_program

RULES = """
predicate word(text, start, end)
predicate stressed_ratio(ratio, start, end)
predicate fcn(class, subtype, start, end, priority max)

rule more_words
foreach
  word(more|less, $s, $m)
  word($w, $m, $e)
  $w != than
  unless word(no|not, _, $s)
assert
  fcn(comparison, plain, $s, $e, 3)

rule strong
foreach
  fcn(comparison, plain, $s, $e, $p)
  word(much, $before, $s)
  $length = $e - $before
  $length <= 3
  $q = increase_priority($p)
assert
  fcn(comparison, strong, $before, $e, $q)

rule stressed
foreach
  stressed_ratio($ratio, $s, $e)
  $ratio > 0.5
assert
  fcn(emphasis, plain, $s, $e, 1)
"""


@pytest.fixture
def program(tmp_path: Path) -> Program:
    path = tmp_path / "some.rules"
    path.write_text(RULES)
    return load_program([path])


def known(program: Program, text: str, *others: Fact) -> tuple[Fact, ...]:
    words = [Fact("word", (word, place, place + 1)) for place, word in enumerate(text.split())]
    return derive(program, [*words, *others]).facts


def obstacles(trace: RuleTrace) -> list[tuple[str, ObstacleKind, str]]:
    return [(miss.rule.name, each.lack, each.said.text) for miss in trace.near_misses for each in miss.obstacles]


def test_a_firing_tells_what_was_joined_and_what_follows_with_the_words(program: Program) -> None:
    [more, strong] = trace_rules(program, known(program, "much more fun")).firings
    assert more.rule.name == "more_words"
    assert more.joined == (ShownStatement("word(more, 1, 2)", (1, 2)), ShownStatement("word(fun, 2, 3)", (2, 3)))
    assert more.concluded == (ShownStatement("fcn(comparison, plain, 1, 3)", (1, 3)),)
    assert strong.joined == (
        ShownStatement("fcn(comparison, plain, 1, 3)", (1, 3)),
        ShownStatement("word(much, 0, 1)", (0, 1)),
    )
    assert strong.concluded == (ShownStatement("fcn(comparison, strong, 0, 3)", (0, 3)),)


@pytest.mark.parametrize(
    ("text", "lack", "told"),
    [
        ("far more fun", ObstacleKind.MISSING, "word(much, $before, 1)"),
        ("not more fun", ObstacleKind.EXCLUDED, "word(not, 0, 1)"),
        ("more than", ObstacleKind.UNTRUE, "$w != than: than != than"),
        ("so more", ObstacleKind.MISSING, "word($w, 2, $e)"),
    ],
)
def test_a_near_miss_tells_what_stood_in_the_way(program: Program, text: str, lack: ObstacleKind, told: str) -> None:
    [(_, *found)] = obstacles(trace_rules(program, known(program, text)))
    assert found == [lack, told]


def test_what_names_no_word_that_is_there_is_not_near(program: Program) -> None:
    assert trace_rules(program, known(program, "nothing here")) == RuleTrace((), ())
    assert obstacles(trace_rules(program, known(program, "", Fact("stressed_ratio", (0.4, 0, 1))))) == [
        ("stressed", ObstacleKind.UNTRUE, "$ratio > 0.5: 0.4 > 0.5")
    ]


def test_a_fact_that_cannot_be_is_not_missed(tmp_path: Path) -> None:
    path = tmp_path / "some.rules"
    path.write_text(
        "predicate word(text, start, end)\npredicate found(start, end)\n"
        "rule around\nforeach\n  word(a, _, $s)\n  word(b, $e, _)\n  word(c, $s, $e)\nassert\n  found($s, $e)\n"
    )
    program = load_program([path])
    assert obstacles(trace_rules(program, known(program, "b a"))) == []
    missed = obstacles(trace_rules(program, known(program, "a x b")))
    assert missed == [("around", ObstacleKind.MISSING, "word(c, 1, 2)")]


def test_of_one_rule_the_nearest_is_told_however_far(program: Program) -> None:
    more, strong, _ = program.rules
    nothing = trace_rule(program, strong, known(program, "nothing"))
    assert [told for _, _, told in obstacles(nothing)] == [
        "fcn(comparison, plain, $s, $e)",
        "word(much, $before, $s)",
    ]
    facts = known(program, "less fun and more fun")
    assert len(trace_rule(program, more, facts).firings) == 2
    assert [told for _, _, told in obstacles(trace_rule(program, strong, facts))] == [
        "word(much, $before, 0)",
        "word(much, $before, 3)",
    ]


def test_a_choice_is_told_with_its_alternatives(tmp_path: Path) -> None:
    path = tmp_path / "some.rules"
    path.write_text(
        "predicate word(text, start, end)\n"
        "rule shown\nforeach\n  word(no, $s, $e)\nchoose\n  weight 2\n    nod($s, $e)\n    frown($s, $e)\n"
    )
    program = load_program([path])
    [firing] = trace_rules(program, known(program, "no")).firings
    assert firing.concluded == (ShownStatement("weight 2: nod(0, 1) frown(0, 1)"),)


@pytest.mark.parametrize(
    "text",
    [
        "No, I kind of like that big idea, but it's a lot more important than the, uh, the other one.",
        "So what do you think we should do, put it over there or throw it away?",
        "Every single one of them left, and then nobody would ever talk about those days again.",
    ],
)
def test_the_rules_fire_exactly_where_the_chainer_ran_them(text: str) -> None:
    words, rules = words_of(text), shipped_rules()
    derived = derive_facts(rules, Utterance(words, shipped_parser().parse(words)))
    trace = trace_rules(rules.program, derived.facts)
    concluded = {said.text for firing in trace.firings for said in firing.concluded}
    assert concluded == {str(fact) for fact in derived.facts if derived.reason(fact)}
    fired = {firing.rule.name for firing in trace.firings}
    assert {reason.rule for reason in derived.reasons.values()} <= fired
    base = FactBase.of(derived.facts)
    assert {rule.name for rule in rules.program.rules if fires(rule, base)} == fired
    assert fired.isdisjoint(miss.rule.name for miss in trace.near_misses)

"""The rule of the paper's Figure 3 as it is printed there, with and without the keyword `rule`."""

import shutil
from pathlib import Path

import pytest

from understudy.errors import AuthoringError
from understudy.files import RULES, resource_folder
from understudy.model import Fact
from understudy.rules.chaining.chainer import derive
from understudy.rules.chaining.tracing import trace_rule
from understudy.rules.derivation import FunctionRules
from understudy.rules.program.loading import load_program

PAPER = """
predicate fcn(class, subtype, start, end, priority max)

semantics_strong_positive_comparative
foreach
  fcn(quantifier,positive,$start1,$end1,$priority1)
  fcn(comparative,positive,$end1,$end2,$priority2)
  $newPri = increase_priority($priority1,$priority2)
assert
  fcn(comparative,strong_positive,$start1,$end2,$newPri)
"""

A_LOT = Fact("fcn", ("quantifier", "positive", 0, 2))
MORE_IMPORTANT = Fact("fcn", ("comparative", "positive", 2, 4))
STRONG = Fact("fcn", ("comparative", "strong_positive", 0, 4))


def test_a_lot_more_important_is_a_strong_comparative_above_its_components(tmp_path: Path) -> None:
    (tmp_path / "paper.rules").write_text(PAPER, encoding="utf-8")
    program = load_program([tmp_path / "paper.rules"])
    derivation = derive(program, [A_LOT, MORE_IMPORTANT], annotations={A_LOT: 3, MORE_IMPORTANT: 5})
    assert derivation.facts[2:] == (STRONG,)
    assert derivation.annotation(STRONG) == 6
    reason = derivation.reason(STRONG)
    assert reason is not None
    assert (reason.rule, reason.line) == ("semantics_strong_positive_comparative", 4)
    assert reason.supports == (A_LOT, MORE_IMPORTANT)


def test_the_keyword_changes_nothing_but_the_column_of_the_name(tmp_path: Path) -> None:
    (tmp_path / "paper.rules").write_text(PAPER, encoding="utf-8")
    (tmp_path / "ours.rules").write_text(PAPER.replace("semantics_", "rule semantics_"), encoding="utf-8")
    derived = [
        derive(load_program([tmp_path / name]), [A_LOT, MORE_IMPORTANT], annotations={A_LOT: 3}).facts
        for name in ("paper.rules", "ours.rules")
    ]
    assert derived[0] == derived[1]
    assert STRONG in derived[0]


def test_rules_with_and_without_the_keyword_stand_in_one_file_each_with_its_comment(tmp_path: Path) -> None:
    other = (
        "\n# The other way round.\nrule other\nforeach\n  fcn($c, $s, $a, $b, _)\nassert\n  fcn(seen, $s, $a, $b, 0)\n"
    )
    named = PAPER.replace("\nsemantics_", other + "\n# As printed.\nsemantics_")
    (tmp_path / "paper.rules").write_text(named, encoding="utf-8")
    rules = load_program([tmp_path / "paper.rules"]).rules
    assert [(rule.name, rule.comment) for rule in rules] == [
        ("other", "The other way round."),
        ("semantics_strong_positive_comparative", "As printed."),
    ]


@pytest.mark.parametrize(
    ("text", "line", "told"),
    [
        ("lonely\n  fcn(a, b, $s, $e, _)\n", 1, "a rule's name alone above `foreach`"),
        ("named\nforeach\n  fcn(a, b, $s, $e\nassert\n  fcn(c, b, $s, $e)\n", 4, "the parenthesis is not closed"),
        ("named\nforeach\n  fcn(a, b, $s, $e, _)\n", 1, "named"),
        (
            "named\nforeach\n  fcn(a, b, $s, $e, _)\nassert\n  fcn(c, b, $s, $e)\n\nnext\n  fcn(x, y, $s, $e, _)\n",
            7,
            "`foreach` comes right below it",
        ),
    ],
)
def test_mistakes_in_a_rule_without_keyword_are_told_at_their_place(
    tmp_path: Path, text: str, line: int, told: str
) -> None:
    (tmp_path / "paper.rules").write_text(text, encoding="utf-8")
    with pytest.raises(AuthoringError) as error:
        load_program([tmp_path / "paper.rules"])
    assert any(mistake.line == line and told in mistake.message for mistake in error.value.mistakes), error.value


def test_words_apart_are_none(tmp_path: Path) -> None:
    (tmp_path / "paper.rules").write_text(PAPER, encoding="utf-8")
    program = load_program([tmp_path / "paper.rules"])
    apart = Fact("fcn", ("comparative", "positive", 3, 5))
    assert set(derive(program, [A_LOT, apart]).facts) == {A_LOT, apart}


def test_as_printed_it_stands_beside_the_shipped_rules_and_fires_on_its_example(tmp_path: Path) -> None:
    shutil.copytree(RULES, tmp_path / "rules")
    printed = PAPER.split("\n\n", 1)[1]
    (tmp_path / "rules" / "functions" / "paper.rules").write_text(printed, encoding="utf-8")
    rules = FunctionRules.load(tmp_path / "rules", resource_folder("lexicon") / "en")
    (rule,) = (each for each in rules.program.rules if each.name == "semantics_strong_positive_comparative")
    facts = [Fact("fcn", ("quantification", "positive", 2, 4)), Fact("fcn", ("comparison", "positive", 4, 6))]
    traced = trace_rule(rules.program, rule, facts)
    assert [said.text for firing in traced.firings for said in firing.concluded] == [
        "fcn(comparison, strong_positive, 2, 6)"
    ]

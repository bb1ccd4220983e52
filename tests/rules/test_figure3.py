"""The rule of the paper's Figure 3 as it is printed there, but for the keyword `rule`: it loads, and it derives."""

from pathlib import Path

from understudy.rules.chaining.chainer import Fact, derive
from understudy.rules.program.program import load_program

PAPER = """
predicate fcn(class, subtype, start, end, priority max)

rule semantics_strong_positive_comparative
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


def test_words_apart_are_none(tmp_path: Path) -> None:
    (tmp_path / "paper.rules").write_text(PAPER, encoding="utf-8")
    program = load_program([tmp_path / "paper.rules"])
    apart = Fact("fcn", ("comparative", "positive", 3, 5))
    assert set(derive(program, [A_LOT, apart]).facts) == {A_LOT, apart}

"""An asserted fact may leave its annotation out: it claims 0, and what else is claimed counts."""

from pathlib import Path

import pytest

from understudy.errors import AuthoringError
from understudy.model import Fact
from understudy.rules.chaining.chainer import derive
from understudy.rules.program.loading import load_program

RULES = """
predicate word(text, start, end)
predicate fcn(class, subtype, start, end, priority max)

rule said
foreach
  word($w, $s, $e)
assert
  fcn(negation, plain, $s, $e)
"""
RAISED = """
rule raised
foreach
  fcn(negation, plain, 0, $e, _)
assert
  fcn(negation, plain, 0, $e, 4)
"""


def test_nothing_claimed_is_nought_and_another_claim_counts(tmp_path: Path) -> None:
    path = tmp_path / "some.rules"
    path.write_text(RULES + RAISED)
    derivation = derive(load_program([path]), [Fact("word", ("no", 0, 1)), Fact("word", ("no", 1, 2))])
    claimed = [derivation.annotation(Fact("fcn", ("negation", "plain", at, at + 1))) for at in (0, 1)]
    assert claimed == [4, 0]


@pytest.mark.parametrize(
    ("written", "instead"),
    [
        ("fcn(negation, plain, $s, $e)\n", "fcn(negation, plain, $s)\n"),
        ("word($w, $s, $e)\n", "word($w, $s, $e)\n  fcn(negation, plain, $s, $e)\n"),
    ],
)
def test_other_arguments_and_patterns_leave_nothing_out(tmp_path: Path, written: str, instead: str) -> None:
    path = tmp_path / "some.rules"
    path.write_text(RULES.replace(written, instead))
    with pytest.raises(AuthoringError, match="fcn takes 5 arguments"):
        load_program([path])

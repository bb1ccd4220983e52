"""Every mistake a rule file can make beyond its syntax, each at its place (marked `@`) and with what would be right."""

import random
import re
from pathlib import Path

import pytest

from understudy.errors import AuthoringError, Mistake
from understudy.model import CallableNames
from understudy.rules.program.loading import load_program

DECLARATIONS = """predicate word(text, start, end)
predicate near(one, other)
predicate fcn(class, start, end, priority max)
predicate given(class)
"""

JOIN = "rule r\nforeach\n word($w, $s, $e)\n"
FUNCTION = "rule r\nforeach\n fcn($c, $s, $e, $p)\n"
END = "\nassert\n near($s, $e)"


NAMES = CallableNames(frozenset({"small_nod", "beat"}), frozenset({"BEAT"}), frozenset({"BEAT", "hands"}))


def mistakes(tmp_path: Path, *texts: str) -> tuple[Mistake, ...]:
    paths = [tmp_path / f"{number}.rules" for number in range(len(texts))]
    for path, text in zip(paths, texts, strict=True):
        path.write_text(text, encoding="utf-8")
    with pytest.raises(AuthoringError) as raised:
        load_program(paths, behaviors=NAMES)
    return raised.value.mistakes


ONE_MISTAKE = [
    ("rule r\nforeach\n @wrod($w, $s, $e)" + END.replace("near($s, $e)", "near(1, 2)"), "did you mean 'word'?"),
    (JOIN + "assert\n @no_progress($s)", "unknown predicate no_progress"),
    (JOIN + " @max($s, $e)" + END, "unknown predicate max; a function stands in a computation: $x = ..."),
    (JOIN + " @near($s)" + END, "near takes 2 arguments (one, other), not 1"),
    (JOIN + "assert\n @fcn(x, $s)", "fcn takes 4 arguments (class, start, end, priority), not 2"),
    (JOIN + " near($s, @$e + 1)" + END, "a pattern computes nothing"),
    (JOIN + " unless near($s, @max($s, $e))" + END, "a pattern computes nothing"),
    (JOIN + " $s < @$end" + END, "$end has no value"),
    (JOIN + " $start = 1\n $s < @$strat" + END, "$strat has no value; did you mean 'start'?"),
    (JOIN + " unless near($s, @$x)" + END, "$x has no value"),
    (JOIN + " $a = @$x + 1" + END, "$x has no value"),
    (JOIN + "assert\n near($s, @$x)", "$x has no value"),
    (JOIN + "choose\n weight 1 when @$x == 1\n beat($s)", "$x has no value"),
    (JOIN + "choose\n weight 1\n beat(@$x)", "$x has no value"),
    (JOIN + "choose\n weight 1\n @BEAT($s, $e)", "lexemes and families stand below `always` and `never`"),
    (JOIN + "choose\n always\n @hands($s, $e)", "hands does not say which movement; it stands below `never`"),
    (JOIN + "choose\n always\n BEAT($s, $e)\n never\n hands($s, $e)\n @betas($s, $e)", "unknown behaviour betas"),
    (JOIN + " $a = @increase($s)" + END, "unknown function increase"),
    (JOIN + " $a = @abs($s, $e)" + END, "abs takes 1 argument, not 2"),
    (JOIN + " $a = @max($s)" + END, "max takes 2 or more arguments, not 1"),
    (JOIN + " $a = $s + @high" + END, "`+` takes numbers, and high is a text"),
    (JOIN + " $a = max($s, @high)" + END, "`max` takes numbers, and high is a text"),
    (JOIN + " $w >= @high" + END, "`>=` takes numbers, and high is a text"),
    (JOIN + " $s + 1 @== high" + END, "a text and a number are never equal"),
    (JOIN + "assert\n near($s, @a|b)", "`a|b` only stands in patterns"),
    (JOIN + "choose\n weight 1\n beat(@_)", "`_` only stands in patterns"),
    (JOIN + " $a = 1\n @$a = 2" + END, "$a is computed twice; compare with `==`"),
    ("rule @r\nforeach\n unless near(1, 2)\nassert\n near(1, 2)", "joins no fact"),
    ("rule @r\nforeach\n word($w, $s, $e)", "concludes nothing: it must end in `assert` or in `choose`"),
    (JOIN + "assert\n near(1, 2)\n@choose\n weight 1\n  beat($s)", "has concluded already"),
    (JOIN + "assert\n near(1, 2)\n@assert\n near(2, 3)", "has concluded already"),
    (JOIN + "@assert", "expected a fact to assert"),
    (JOIN + "@choose", "expected an alternative below `choose`"),
    (JOIN + "choose\n @weight 0\n  beat($s)", "the weight is 0; it must be greater than 0"),
    (JOIN + "choose\n @weight -1.5\n  beat($s)", "the weight is -1.5"),
    (JOIN + "choose\n @weight 1\n weight 2\n  beat($s)", "expected a behaviour below `weight`"),
    (JOIN + "choose\n weight 1\n  @smal_nod($s)", "unknown behaviour smal_nod; did you mean 'small_nod'?"),
    (FUNCTION + " @$p > 3" + END, "$p comes from an annotation"),
    (FUNCTION + " $q = $p + 1\n $q2 = $q\n @$q2 > 3" + END, "$q2 comes from an annotation"),
    (FUNCTION + " near($s, @$p)" + END, "$p comes from an annotation"),
    (FUNCTION + " unless near($s, @$p)" + END, "$p comes from an annotation"),
    (FUNCTION + "assert\n near($s, @$p)", "$p comes from an annotation"),
    (FUNCTION + "assert\n near($s, @max($p, 1))".replace("@max($p", "max(@$p"), "$p comes from an annotation"),
    (FUNCTION + "choose\n weight 1 when @$p > 3\n  beat($s)", "$p comes from an annotation"),
    (FUNCTION + " fcn(x, $s, $e, @5)" + END, "the annotation priority cannot be tested: write a $variable or `_` here"),
    (FUNCTION + " fcn(x, $s, $e, @4|5)" + END, "the annotation priority cannot be tested"),
    (
        FUNCTION + " unless fcn(x, $s, $e, @$q)\n $q = 1" + END,
        "the annotation priority cannot be tested: write `_` here",
    ),
    ("predicate p(a, @a)", "p has two parameters called a"),
    ("predicate p(@a max, b)", "must be the only one and the last"),
    ("predicate p(@a max, b max)", "must be the only one and the last"),
    (JOIN + " $s < $e\n" * 51 + END, "more than 50 statements"),
    (
        JOIN + " unless @near($s, $e)" + END,
        "rule r excludes near($s, $e), which depends on what the rule itself asserts (r → r)",
    ),
]


@pytest.mark.parametrize(("marked", "expected"), ONE_MISTAKE)
def test_mistakes(tmp_path: Path, marked: str, expected: str) -> None:
    before, mark, after = marked.partition("@")
    [mistake] = mistakes(tmp_path, DECLARATIONS, before + after)
    assert expected in mistake.message
    assert mistake.path == tmp_path / "1.rules"
    if mark:
        assert (mistake.line, mistake.column) == (before.count("\n") + 1, len(before.rpartition("\n")[2]) + 1)
        assert mistake.source_line == (before + after).split("\n")[mistake.line - 1]


def test_all_mistakes_of_all_files_come_at_once_in_order(tmp_path: Path) -> None:
    second = (
        JOIN + " near($s)\n $s < $x\nassert\n near($s, $e)\nrule broken\nforeach\n word($w\nrule end\nforeach\n a()"
    )
    found = mistakes(tmp_path, DECLARATIONS + "rule x\nforeach\n no_progress()", second)
    places = [(mistake.path.stem, mistake.line) for mistake in found]
    assert places == [("0", 5), ("0", 7), ("1", 4), ("1", 5), ("1", 10), ("1", 11), ("1", 13)]


def test_what_is_said_twice_is_reported_at_both_places(tmp_path: Path) -> None:
    rule = JOIN + "assert\n near($s, $e)\n"
    found = mistakes(tmp_path, DECLARATIONS + rule, rule + "predicate near(a, b)")
    assert [(mistake.path.stem, mistake.line) for mistake in found] == [("0", 2), ("0", 5), ("1", 1), ("1", 6)]
    assert "rule r is also at" in found[2].message
    assert found[2].message.endswith("0.rules:5; names must be unique")


def test_a_declaration_that_cannot_be_read_brings_no_mistakes_in_its_rules(tmp_path: Path) -> None:
    [mistake] = mistakes(tmp_path, "predicate word(text start)\n" + JOIN + "assert\n word($w, $e, $s)")
    assert mistake.line == 1


def test_a_negation_cycle_names_its_rules(tmp_path: Path) -> None:
    text = (
        "rule no\nforeach\n given(a)\n unless fcn(yes, 1, 2, _)\nassert\n fcn(no, 1, 2, 1)\n"
        "rule between\nforeach\n fcn(no, $s, $e, _)\nassert\n fcn(maybe, $s, $e, 1)\n"
        "rule yes\nforeach\n fcn(maybe, $s, $e, _)\nassert\n fcn(yes, $s, $e, 1)\n"
        "rule apart\nforeach\n given(a)\n unless fcn(yes, 1, 2, _)\nassert\n fcn(other, 1, 2, 1)\n"
    )
    [mistake] = mistakes(tmp_path, DECLARATIONS, text)
    assert mistake.line == 4
    assert "(no → between → yes → no)" in mistake.message


def test_a_rule_that_only_raises_what_it_joins_is_in_no_cycle(tmp_path: Path) -> None:
    text = (
        "rule raise\nforeach\n fcn($c, $s, $e, $p)\nassert\n fcn($c, $s, $e, $p + 1)\n"
        "rule no\nforeach\n given(a)\n unless fcn(yes, 1, 2, _)\nassert\n fcn(no, 1, 2, 1)\n"
    )
    path = tmp_path / "fine.rules"
    path.write_text(DECLARATIONS + text, encoding="utf-8")
    assert [rule.name for rule in load_program([path]).rules] == ["raise", "no"]


def test_the_message_shows_the_line_and_a_caret(tmp_path: Path) -> None:
    [mistake] = mistakes(tmp_path, DECLARATIONS, "rule r\nforeach\n\tword($w, $s, $x)\n\t$s < $y\nassert\n near($s, 1)")
    assert str(mistake).split("\n")[1:] == ["     $s < $y", "          ^"]


def test_what_a_rule_says_of_itself(tmp_path: Path) -> None:
    path = tmp_path / "fine.rules"
    rules = (
        "\n# Words that touch.\n# (Ours.)\nrule touching\nforeach\n word(a|b, _, $m)\n unless given(x)\n"
        " word(c, $m, $e)\nassert\n near($m, $e + 1)\n\n# Shown.\n"
        "rule shown\nforeach\n fcn(x, $s, $e, $p)\nchoose\n weight 1\n"
        "  beat($s)\n  beat($e)\n weight 2\n  small_nod($s)\n"
    )
    path.write_text(DECLARATIONS + rules, encoding="utf-8")
    touching, shown = load_program([path], behaviors=NAMES).rules
    assert (touching.name, touching.kind, touching.line) == ("touching", "assert", 8)
    assert touching.comment == "Words that touch.\n(Ours.)"
    assert [join.arguments for join in touching.joins] == [("a|b", "_", "$m"), ("c", "$m", "$e")]
    assert [(one.predicate, one.arguments) for one in touching.asserts] == [("near", ("$m", "$e + 1"))]
    assert (shown.kind, shown.calls, shown.asserts) == ("choose", ("beat", "small_nod"), ())
    assert shown.source.startswith("rule shown\nforeach\n")
    assert shown.source.endswith("small_nod($s)")


WHOLE = DECLARATIONS + (
    'rule one\nforeach\n word("a"|b, $s, $e)\n fcn(x, $s, $e, $p)\n $n = $p + 1\n unless near($s, $e)\n $s < $e\n'
    "assert\n fcn(y, $s, $e, max($n, 2))\n"
    "rule two\nforeach\n fcn(y, $s, _, $p)\nchoose\n weight 1.5 when $s != 2\n  beat($s)\n"
)


def test_no_text_brings_anything_but_mistakes(tmp_path: Path) -> None:
    """Tokens of a good file deleted, doubled and swapped at random: it loads, or tells mistakes that have a place."""
    tokens = re.findall(r"\$?\w+|\n|[^\w\s]|[ \t]+", WHOLE)
    draw = random.Random(3)
    path = tmp_path / "mutant.rules"
    for _ in range(100):
        mutant = list(tokens)
        for place in draw.choices(range(len(tokens)), k=draw.randint(1, 4)):
            mutant[place] = draw.choice(["", mutant[place] * 2, draw.choice(tokens), '"', "$", "\\", "é"])
        path.write_text("".join(mutant), encoding="utf-8")
        try:
            load_program([path], behaviors=NAMES)
        except AuthoringError as error:
            lines = ["", *path.read_text(encoding="utf-8").split("\n")]
            assert all(one.column <= len(lines[one.line]) + 1 for one in error.mistakes)  # noqa: PT017

"""The stage: everything loads or every mistake is reported; functions are named, explained, and their conflicts
resolved."""

from dataclasses import replace
from pathlib import Path

import pytest

from tests.support.operations import operations_of
from tests.support.words.utterances import utterance
from understudy.errors import AuthoringError
from understudy.model import Because, Function, Utterance
from understudy.rules.derivation import FunctionRules, derive_functions
from understudy.rules.priorities import Conflicts, resolved

VOCABULARY = (Path(__file__).resolve().parents[2] / "app" / "rules" / "vocabulary.rules").read_text()

RULES = """
rule said
foreach
  lexical($class, $subtype, $s, $e)
assert
  fcn($class, $subtype, $s, $e, 3)

rule wonder_negated
foreach
  fcn(negation, plain, $s, $m, $p)
  word(wonder, $m, $e)
  $q = increase_priority($p)
assert
  fcn(negation, strong, $s, $e, $q)

rule stressed
foreach
  emphasis($value, $s, $e)
  $value > 0.5
assert
  fcn(emphasis, plain, $s, $e, 2)
"""

CONFLICTS = """
within_class: [negation]
within_subtype: [deixis]
between:
  - [emphasis, comparison]
"""

PRIORITIES = """
negation: {plain: 3, strong: 3}
comparison: {plain: 3}
deixis: {plain: 3}
valence: {plain: 3}
emphasis: {plain: 2}
"""

WORDS = """
class: {}
groups:
  - example: "{{}}"
    words: [{}]
"""


def load(folder: Path, rules: str = RULES, conflicts: str = CONFLICTS, **classes: str) -> FunctionRules:
    """Rules over a lexicon of one word a class."""
    functions, lexicon = folder / "rules" / "functions", folder / "lexicon"
    functions.mkdir(parents=True)
    lexicon.mkdir()
    (folder / "rules" / "vocabulary.rules").write_text(VOCABULARY)
    (functions / "all.rules").write_text(rules)
    (functions / "conflicts.yaml").write_text(conflicts)
    (functions / "priorities.yaml").write_text(PRIORITIES)
    for name, word in classes.items():
        (lexicon / f"{name}.yaml").write_text(WORDS.format(name, word))
    return FunctionRules.load(folder / "rules", lexicon)


def stressed(spoken: Utterance, *emphases: float) -> Utterance:
    words = zip(spoken.words, emphases, strict=True)
    return replace(spoken, words=tuple(replace(word, emphasis=emphasis) for word, emphasis in words))


def spans(functions: tuple[Function, ...]) -> list[tuple[str, str, int, int]]:
    return [(found.class_name, found.subtype, found.first, found.last) for found in functions]


def test_functions_are_named_in_the_order_of_their_words(tmp_path: Path) -> None:
    rules = load(tmp_path, comparison="better", deixis="that", valence="better")
    functions = derive_functions(rules, utterance("Better than that.", ""))
    assert spans(functions) == [
        ("comparison", "plain", 0, 0),
        ("valence", "plain", 0, 0),
        ("deixis", "plain", 2, 2),
    ]
    assert [found.id for found in functions] == ["f1", "f2", "f3"]
    assert all(found.kept and found.rule == "said" and found.priority == 3 for found in functions)


def test_because_goes_down_to_the_words(tmp_path: Path) -> None:
    functions = derive_functions(load(tmp_path, negation="no"), utterance("No wonder.", ""))
    whole = next(found for found in functions if found.subtype == "strong")
    assert whole.rule == "wonder_negated"
    assert whole.because == (
        Because(fact="fcn(negation, plain, 0, 1)", rule="said"),
        Because(fact="lexical(negation, plain, 0, 1)"),
        Because(word=0),
        Because(word=1),
    )


def test_the_lower_priority_loses_within_its_class_and_says_to_whom(tmp_path: Path) -> None:
    functions = derive_functions(load(tmp_path, negation="no"), utterance("No wonder.", ""))
    part, whole = sorted(functions, key=lambda found: found.last)
    assert (part.kept, part.lost_to) == (False, whole.id)
    assert (whole.kept, whole.lost_to, whole.priority) == (True, None, 4)


def test_an_emphasised_comparative_shows_the_comparison(tmp_path: Path) -> None:
    rules = load(tmp_path, comparison="better", deixis="that")
    functions = derive_functions(rules, stressed(utterance("better that", ""), 0.7, 0.7))
    kept = {(found.class_name, found.first): found.kept for found in functions}
    assert kept == {("comparison", 0): True, ("emphasis", 0): False, ("deixis", 1): True, ("emphasis", 1): True}


def function(class_name: str, subtype: str, first: int, last: int) -> Function:
    return Function("f", class_name, subtype, first, last, 1.0, "rule")


@pytest.mark.parametrize(
    ("one", "other", "compete"),
    [
        (function("negation", "plain", 0, 1), function("negation", "strong", 1, 2), True),
        (function("negation", "plain", 0, 1), function("negation", "plain", 2, 2), False),
        (function("deixis", "self", 0, 1), function("deixis", "self", 1, 1), True),
        (function("deixis", "self", 0, 1), function("deixis", "distal", 1, 1), False),
        (function("comparison", "equal", 0, 2), function("emphasis", "plain", 1, 1), True),
        (function("emphasis", "plain", 1, 1), function("comparison", "equal", 0, 2), True),
        (function("emphasis", "plain", 1, 1), function("deixis", "self", 1, 1), False),
        (function("modal", "ability", 1, 1), function("modal", "ability", 1, 1), False),
    ],
)
def test_which_functions_compete_is_said_in_a_table(one: Function, other: Function, compete: bool) -> None:
    conflicts = Conflicts(
        within_class=frozenset({"negation"}),
        within_subtype=frozenset({"deixis"}),
        between=(("comparison", "emphasis"),),
    )
    both = resolved([replace(one, id="f1"), replace(other, id="f2")], conflicts)
    assert any(not each.kept for each in both) is compete
    assert {each.lost_to for each in both if not each.kept} <= {"f1", "f2"}


def test_among_many_rivals_the_strongest_at_the_first_shared_word_wins() -> None:
    conflicts = Conflicts(within_class=frozenset({"negation"}), within_subtype=frozenset(), between=())
    strong, weak = (replace(function("negation", "plain", n, n), id=f"f{n}", priority=9.0 - n) for n in (0, 1))
    lost = replace(function("negation", "strong", 0, 1), id="f2", priority=1.0)
    assert [each.lost_to for each in resolved([lost, weak, strong], conflicts)] == ["f0", None, None]


def test_many_functions_over_the_same_words_are_settled_in_proportion() -> None:
    conflicts = Conflicts(within_class=frozenset(), within_subtype=frozenset(), between=(("modal", "emphasis"),))

    def work(count: int) -> int:
        functions = [replace(function("modal", "ability", 0, 20), id=f"f{n}") for n in range(count)]
        return operations_of(lambda: resolved(functions, conflicts))

    assert work(200) <= 1.1 * 2 * work(100)


def test_mistakes_in_rules_words_and_conflicts_come_together(tmp_path: Path) -> None:
    with pytest.raises(AuthoringError) as error:
        load(tmp_path, "rule r\nforeach\n  wrod($w, $s, $e)\nassert\n  fcn(a, b, $s, $e, 1)\n", "within: []\n", a="[")
    assert {mistake.path.name for mistake in error.value.mistakes} == {"all.rules", "conflicts.yaml", "a.yaml"}


def test_a_rule_and_a_word_of_a_function_that_is_none_are_told_where_they_stand(tmp_path: Path) -> None:
    rule = "rule r\nforeach\n  word(so, $s, $e)\nassert\n  fcn(negation, string, $s, $e)\n"
    with pytest.raises(AuthoringError) as error:
        load(tmp_path, rule + rule.replace("rule r", "rule q").replace("negation, string", "compare, plain"))
    assert [(mistake.path.name, mistake.line) for mistake in error.value.mistakes] == [
        ("all.rules", 1),
        ("all.rules", 6),
    ]
    for part in ("no subtype string; its subtypes are plain, strong", "class compare; did you mean 'comparison'?"):
        assert part in str(error.value)


def test_a_word_of_an_unknown_subtype_is_told(tmp_path: Path) -> None:
    load(tmp_path, negation="no")
    words = tmp_path / "lexicon" / "negation.yaml"
    words.write_text(words.read_text().replace("- example", "- subtype: string\n    example"))
    with pytest.raises(AuthoringError, match="negation has no subtype string"):
        FunctionRules.load(tmp_path / "rules", tmp_path / "lexicon")


def test_a_line_without_words_does_nothing(tmp_path: Path) -> None:
    assert derive_functions(load(tmp_path), utterance("", "")) == ()

"""Long lines are processed passage by passage: in time proportional to their length, with the same results as short
lines.
"""

from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from tests.support.operations import calls_of, operations_of
from tests.support.shipped_rules import shipped_parser, shipped_rules
from tests.support.words.utterances import utterance, words_of
from understudy.errors import AuthoringError, InputError
from understudy.model import Because, Fact, Function, GivenFunction, Parse, Utterance
from understudy.rules.chaining.facts import utterance_facts
from understudy.rules.derivation import (
    GIVEN_PRIORITY,
    LONGEST_PASSAGE,
    FunctionRules,
    by_passage,
    derive_functions,
    passage_starts,
)
from understudy.rules.priorities import Conflicts, resolved

SLACK = 1.15


def _repeated(text: str, words: int) -> Utterance:
    """The text again and again, up to so many words."""
    listed = text.split()
    line = words_of(" ".join((listed * (words // len(listed) + 1))[:words]))
    return Utterance(line, shipped_parser().parse(line))


def _starts(text: str) -> list[int]:
    return passage_starts(utterance_facts(Utterance(words_of(text), Parse((), (), ()))))


def test_a_line_of_a_minute_is_one_passage_and_a_longer_one_is_cut_between_sentences() -> None:
    assert _starts("so it goes. " * (LONGEST_PASSAGE // 3)) == [0]
    assert _starts("and so it always goes. " * 61) == [0, 150, 300]
    assert _starts("and so it. " + "so it goes on. " * 40) == [0, 147]


def test_a_sentence_without_an_end_is_cut_where_a_passage_would_be_too_long() -> None:
    assert _starts("on " * (2 * LONGEST_PASSAGE + 1)) == [0, LONGEST_PASSAGE, 2 * LONGEST_PASSAGE]


def test_facts_go_where_they_begin_and_what_is_between_two_passages_is_in_both() -> None:
    inside, across, between = Fact("word", ("so", 4, 5)), Fact("clause", ("root", 4, 9, 5)), Fact("pause", (0.5, 6))
    line, table = Fact("utterance", (0, 9)), Fact("base_priority", ("negation", "plain", 2.0))
    assert by_passage([0, 6], (inside, across, between, line, table)) == [
        [inside, across, between, line, table],
        [between, line, table],
    ]


def test_a_sentence_does_the_same_in_any_passage() -> None:
    sentences = 50
    functions = derive_functions(shipped_rules(), _repeated("I do not know him. Do you?", 7 * sentences))

    def of(sentence: int) -> list[tuple[str, str, int, int]]:
        return sorted(_from(7 * sentence, each) for each in functions if each.first // 7 == sentence)

    assert all(of(sentence) == of(1) for sentence in range(2, sentences - 1))
    assert [each.id for each in functions] == [f"f{number}" for number in range(1, len(functions) + 1)]


def _from(first: int, function: Function) -> tuple[str, str, int, int]:
    return function.class_name, function.subtype, function.first - first, function.last - first


@pytest.mark.parametrize("text", ["the red house, the blue house,", "do you know who did it", "(the (very (old) man))"])
def test_a_line_of_twice_as_many_words_is_twice_the_work(text: str) -> None:
    half, whole = (calls_of(partial(derive_functions, shipped_rules(), _repeated(text, words))) for words in (300, 600))
    assert whole <= SLACK * 2 * half


LINE = utterance("nobody came", "0:nobody/nobody/PRON 1:came/come/VERB")


@pytest.fixture(scope="module")
def rules() -> FunctionRules:
    return shipped_rules()


def negations(functions: tuple[Function, ...]) -> dict[tuple[int, int], Function]:
    return {(found.first, found.last): found for found in functions if found.class_name == "negation"}


def test_a_given_function_wins_over_what_is_derived_even_with_less_priority(rules: FunctionRules) -> None:
    found = negations(derive_functions(rules, LINE, given=[GivenFunction("negation", "plain", 0, 1, priority=0.5)]))
    given, derived = found[0, 1], found[0, 0]
    assert (given.kept, given.given, given.rule, given.priority) == (True, True, "given", 0.5)
    assert (derived.kept, derived.lost_to) == (False, given.id)
    assert [because.word for because in given.because if because.word is not None] == [0, 1]
    assert "given" in (given.because[0].fact or "")


def test_without_a_priority_it_is_above_all(rules: FunctionRules) -> None:
    functions = derive_functions(rules, LINE, given=[GivenFunction("valence", "negative", 1, 1)])
    assert max(functions, key=lambda found: found.priority).class_name == "valence"
    assert {found.priority for found in functions if found.given} == {GIVEN_PRIORITY}


def test_what_would_be_derived_anyway_is_the_caller_s(rules: FunctionRules) -> None:
    found = negations(derive_functions(rules, LINE, given=[GivenFunction("negation", "plain", 0, 0)]))
    assert [(one.given, one.rule) for one in found.values()] == [(True, "given")]


def test_rules_build_on_what_is_given(rules: FunctionRules) -> None:
    spoken = utterance("such better", "0:such/such/ADJ/JJ/dep/0 1:better/good/ADJ/JJR/dep/1")
    functions = derive_functions(rules, spoken, given=[GivenFunction("quantification", "positive", 0, 0)])
    assert ("comparison", "strong_positive", 0, 1) in [
        (found.class_name, found.subtype, found.first, found.last) for found in functions
    ]


def test_of_the_same_function_given_twice_the_higher_priority_counts(rules: FunctionRules) -> None:
    twice = [GivenFunction("negation", "plain", 0, 1, priority) for priority in (3.0, 8.0, 5.0)]
    assert negations(derive_functions(rules, LINE, given=twice))[0, 1].priority == 8


@pytest.mark.parametrize(
    ("given", "code", "said"),
    [
        (GivenFunction("negatoin", "plain", 0, 0), "functions_class", "did you mean 'negation'?"),
        (GivenFunction("joy", "plain", 0, 0), "functions_class", "the classes are interrogative"),
        (GivenFunction("valence", "plain", 0, 0), "functions_class", "its subtypes are positive, negative"),
        (GivenFunction("negation", "plain", 0, 2), "functions_span", "words are 0 to 1"),
        (GivenFunction("negation", "plain", 1, 0), "functions_span", "first comes before last"),
        (GivenFunction("negation", "plain", -1, 0), "functions_span", "words are 0 to 1"),
    ],
)
def test_what_is_no_function_of_the_line_is_refused(
    rules: FunctionRules, given: GivenFunction, code: str, said: str
) -> None:
    with pytest.raises(InputError, match="functions\\[1\\]") as error:
        derive_functions(rules, LINE, given=[GivenFunction("negation", "plain", 0, 0), given])
    assert (error.value.code, error.value.field) == (code, "functions")
    assert said in error.value.message


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

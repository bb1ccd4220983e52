"""Given functions: they join the derived ones, win over them, and name their origin."""

import pytest

from tests.support.shipped_rules import shipped_rules
from tests.support.words.utterances import utterance
from understudy.errors import InputError
from understudy.model import Function, GivenFunction
from understudy.rules.derivation import FunctionRules, derive_functions
from understudy.rules.given import GIVEN_PRIORITY

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

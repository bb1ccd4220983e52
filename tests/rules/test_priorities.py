"""Priorities: the table, and how specificity, combination and stress raise them."""

from dataclasses import replace
from pathlib import Path

import pytest

from tests.support.shipped_rules import shipped_rules
from tests.support.words.by_hand import function
from tests.support.words.utterances import utterance
from understudy.errors import AuthoringError
from understudy.model import Function, Utterance
from understudy.rules.derivation import FunctionRules, derive_functions
from understudy.rules.priorities import Priorities, resolved_as_in_paper

ROOT = Path(__file__).resolve().parents[2]
TABLE = ROOT / "app" / "rules" / "functions" / "priorities.yaml"


@pytest.fixture(scope="module")
def rules() -> FunctionRules:
    return shipped_rules()


def priorities(rules: FunctionRules, spoken: Utterance) -> dict[tuple[str, str, int, int], float]:
    return {
        (found.class_name, found.subtype, found.first, found.last): found.priority
        for found in derive_functions(rules, spoken)
    }


def stressed(spoken: Utterance, number: int) -> Utterance:
    words = (replace(word, emphasis=0.7 if word.index == number else 0.0) for word in spoken.words)
    return replace(spoken, words=tuple(words))


NOT_SURE = utterance("not sure", "0:not/not/PART 1:sure/sure/ADJ")


def test_a_function_begins_with_the_priority_of_the_table(rules: FunctionRules) -> None:
    table = Priorities.load(TABLE).root
    found = priorities(rules, utterance("um nothing", "0:um/um/INTJ 1:nothing/nothing/PRON"))
    assert found["performance", "hesitation", 0, 0] == table["performance"]["hesitation"]
    assert found["negation", "plain", 1, 1] == table["negation"]["plain"]


def test_the_whole_is_more_specific_than_its_part(rules: FunctionRules) -> None:
    found = priorities(rules, utterance("two hundred men", "0:two/two/NUM 1:hundred/hundred/NUM 2:men/man/NOUN"))
    assert found["quantification", "number", 0, 1] == found["quantification", "number", 0, 0] + 1


def test_stress_comes_on_top_of_specificity(rules: FunctionRules) -> None:
    calm = priorities(rules, utterance("two hundred men", "0:two/two/NUM 1:hundred/hundred/NUM 2:men/man/NOUN"))
    loud = priorities(
        rules, stressed(utterance("two hundred men", "0:two/two/NUM 1:hundred/hundred/NUM 2:men/man/NOUN"), 0)
    )
    whole = ("quantification", "number", 0, 1)
    assert loud[whole] == calm[whole] + 1
    assert loud["quantification", "number", 1, 1] == calm["quantification", "number", 1, 1]


def test_a_part_is_not_raised(rules: FunctionRules) -> None:
    assert priorities(rules, NOT_SURE)["negation", "plain", 0, 0] == Priorities.load(TABLE).root["negation"]["plain"]


@pytest.mark.parametrize("wrong", ["negation: {plain: 0}", "negation: {plain: high}", "negation: 5", "[negation]"])
def test_a_table_that_is_wrong_is_told_at_its_line(tmp_path: Path, wrong: str) -> None:
    path = tmp_path / "priorities.yaml"
    path.write_text(f"# how much each matters\n{wrong}\n")
    with pytest.raises(AuthoringError) as error:
        Priorities.load(path)
    assert [mistake.line for mistake in error.value.mistakes] == [2]


def _kept(*functions: Function) -> list[str]:
    return [found.id for found in resolved_as_in_paper(functions) if found.kept]


def test_as_in_the_paper_functions_of_any_classes_compete_for_their_words() -> None:
    """The paper's example (§3.3) is a comparative on a word that is emphasised as well."""
    comparative = function("comparison", "positive", 2, 3, 4.0)
    emphasis, negation, pointing = (
        function("emphasis", "plain", 3, 3, 3.0),
        function("negation", "plain", 4, 4, 3.0),
        function("deixis", "distal", 4, 5, 3.0),
    )
    found = {each.id: each for each in resolved_as_in_paper((comparative, emphasis, negation, pointing))}
    assert [each.id for each in found.values() if each.kept] == [comparative.id, pointing.id]
    assert found[emphasis.id].lost_to == comparative.id
    assert found[negation.id].lost_to == pointing.id


def test_what_lost_takes_no_words_from_others() -> None:
    first, middle, last = (
        function("contrast", "plain", 0, 1, 5.0),
        function("mental", "know", 1, 2, 4.0),
        function("negation", "plain", 2, 2, 3.0),
    )
    assert _kept(first, middle, last) == [first.id, last.id]


def test_a_given_function_is_never_dropped_and_competes_by_its_priority() -> None:
    given = replace(function("information", "rheme", 0, 4, 1.0), given=True)
    negation, opening = function("negation", "plain", 1, 1, 5.0), function("initial_noun_phrase", "plain", 0, 0, 1.0)
    assert _kept(given, negation, opening) == [given.id, negation.id]

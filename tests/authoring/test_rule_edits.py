"""Edited rules: compiled beside those in use without changing any file, with messages in the author's terms."""

from itertools import islice

import pytest

from understudy.authoring.rule_edits import compare, compile_edits, example_lines, mistakes_in, with_edits
from understudy.authoring.saved_files import RULE_FILES
from understudy.errors import InputError
from understudy.model import CallableNames
from understudy.models import Understudy
from understudy.rules.stage import find_functions

WORDS = "lexicon/en/thanks.yaml"
AGREEMENT = "app/rules/behaviors/agreement.rules"
MIND = "app/rules/behaviors/mind.rules"
NEW_WORD = 'class: thanks\ngroups:\n  - example: "{} for that."\n    words: [zounds]\n'


def text_of(name: str) -> str:
    return RULE_FILES.files()[name].read_text(encoding="utf-8")


def test_rules_words_and_priorities_can_be_edited_and_nothing_else() -> None:
    names = RULE_FILES.files().keys()
    assert {WORDS, AGREEMENT, "app/rules/functions/priorities.yaml", "app/rules/vocabulary.rules"} <= names
    assert all(name.startswith(("app/rules/", "lexicon/en/")) for name in names)
    assert "lexicon/en/abbreviations.yaml" not in names


def test_a_new_word_holds_for_the_edited_models_alone(understudy: Understudy) -> None:
    line = "Zounds for that."
    before = find_functions(understudy.language, line).functions
    edited = with_edits(understudy, {WORDS: NEW_WORD})
    after = find_functions(edited.language, line).functions
    assert {function.class_name for function in after} - {function.class_name for function in before}
    assert find_functions(understudy.language, line).functions == before
    assert "zounds" not in text_of(WORDS)


def test_without_edits_the_models_are_the_same(understudy: Understudy) -> None:
    assert with_edits(understudy, {}) is understudy


def test_mistakes_are_told_by_the_names_of_the_files(understudy: Understudy) -> None:
    names = understudy.behavior.characters.callable_names
    wrong = text_of(AGREEMENT).replace("big_nod(", "bigger_nod(", 1)
    lines = wrong.splitlines()
    found = mistakes_in({AGREEMENT: wrong, WORDS: "clas: thanks\n"}, names)
    assert {str(mistake.path) for mistake in found} == {AGREEMENT, WORDS}
    [rule] = [mistake for mistake in found if str(mistake.path) == AGREEMENT]
    assert lines[rule.line - 1][rule.column - 1 :].startswith("bigger_nod(")


def test_a_rule_that_is_said_twice_names_the_other_without_our_folder(understudy: Understudy) -> None:
    names = understudy.behavior.characters.callable_names
    again = text_of(AGREEMENT).partition("\nrule ")[2].partition("\n\n")[0]
    found = mistakes_in({MIND: f"{text_of(MIND)}\nrule {again}\n"}, names)
    assert any(f"also at {AGREEMENT}:" in mistake.message for mistake in found)
    assert not any("understudy-rules-" in mistake.message for mistake in found)


@pytest.mark.parametrize("name", ["lexicon/en/../behaviors.yaml", "/etc/passwd", "lexicon/behaviors.yaml"])
def test_other_files_are_no_rules(name: str) -> None:
    with pytest.raises(InputError) as caught:
        compile_edits({name: ""}, CallableNames(frozenset()))
    assert caught.value.code == "unknown_file"


def test_wrong_rules_cannot_perform(understudy: Understudy) -> None:
    with pytest.raises(InputError, match=rf"^{WORDS}:1:1: ") as caught:
        with_edits(understudy, {WORDS: "clas: thanks\n"})
    assert caught.value.code == "rules_wrong"


def test_figure_3_as_printed_is_accepted_beside_the_shipped_rules(understudy: Understudy) -> None:
    printed = """
semantics_strong_positive_comparative
foreach
  fcn(quantifier,positive,$start1,$end1,$priority1)
  fcn(comparative,positive,$end1,$end2,$priority2)
  $newPri = increase_priority($priority1,$priority2)
assert
  fcn(comparative,strong_positive,$start1,$end2,$newPri)
"""
    name = "app/rules/functions/comparison.rules"
    edited = with_edits(understudy, {name: text_of(name) + printed})
    found = find_functions(edited.language, "That is a lot more important.").functions
    assert ("comparison", "strong_positive") in {(each.class_name, each.subtype) for each in found if each.kept}


AFFIRMATION = "lexicon/en/affirmation.yaml"
LINES = {"yes": "Yes, we can do that.", "no": "The door is open."}


def test_comments_change_nothing(understudy: Understudy) -> None:
    some = dict(islice(example_lines(understudy.language.rules.lexicon).items(), 30))
    assert compare(understudy, {AFFIRMATION: text_of(AFFIRMATION) + "# a comment\n"}, some | LINES) == ()


def test_a_word_that_is_taken_out_changes_the_lines_that_have_it(understudy: Understudy) -> None:
    without = text_of(AFFIRMATION).replace("      - yes\n", "", 1)
    [change] = compare(understudy, {AFFIRMATION: without}, LINES)
    assert change.id == "yes"
    assert "affirmation" in {function.class_name for function in change.functions_before}
    assert "affirmation" not in {function.class_name for function in change.functions_after}
    assert {offer.rule for offer in change.offers_before} >= {"show_affirmation"}


def test_another_weight_changes_what_is_offered_and_no_function(understudy: Understudy) -> None:
    heavier = text_of(AGREEMENT).replace("weight 4 when $level != low", "weight 40 when $level != low", 1)
    [change] = compare(understudy, {AGREEMENT: heavier}, LINES)
    assert (change.functions_before, change.functions_after) == ((), ())
    assert [(offer.name, offer.weight) for offer in change.offers_before] == [("big_nod", 4.0)]
    assert [(offer.name, offer.weight) for offer in change.offers_after] == [("big_nod", 40.0)]


def test_there_is_an_example_of_every_group_of_words(understudy: Understudy) -> None:
    lexicon = understudy.language.rules.lexicon
    groups = {(entry.path, entry.example) for entry in lexicon.entries if entry.example}
    assert len(example_lines(lexicon)) == len(groups) + 1
    assert "{}" not in "".join(example_lines(lexicon).values())


def test_wrong_rules_are_not_tried(understudy: Understudy) -> None:
    with pytest.raises(InputError, match=f"^{AGREEMENT}:") as caught:
        compare(understudy, {AGREEMENT: "rule x\n"}, LINES)
    assert caught.value.code == "rules_wrong"

"""The changes in lines caused by edited rules."""

from itertools import islice

import pytest

from tests.authoring.test_rule_edits import AGREEMENT, text_of
from understudy.authoring.rule_comparison import compare, example_lines
from understudy.errors import InputError
from understudy.models import Understudy

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

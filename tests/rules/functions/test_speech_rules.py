"""Rules about whose words are quoted, and which words they are."""

import pytest

from tests.support.shipped_rules import at, facts, found

SPEECH = [
    ('My boss said, "Take a seat."', {("marked", "other", '"Take a seat."')}),
    (
        '"Run," she whispered, "before it is too late."',
        {("marked", "other", '"Run,"'), ("marked", "other", '"before it is too late."')},
    ),
    ('I told him, "Never again."', {("marked", "self", '"Never again."')}),
    ('It is a "smart" phone.', {("marked", "other", '"smart"')}),
    ("And she was like, get out of here.", {("shown", "other", "get out of here.")}),
    ("He said that he would call.", {("reported", "other", "that he would call.")}),
    ("I said hello to her.", set()),
    ("Some fruit, say, apples, would be nice.", set()),
    ("Tell me where he lives.", set()),
]


@pytest.mark.parametrize(("text", "expected"), SPEECH)
def test_speech_is_somebodys(text: str, expected: set[tuple[str, ...]]) -> None:
    assert facts(text, "speech") == expected


def test_words_between_two_quotations_are_nobodys() -> None:
    text = 'One cried "fire" and ran while the other whispered "too late" to us.'
    assert [words for subtype, words in found(text, "quoting") if subtype == "words"] == ['"fire"', '"too late"']


def test_a_quotation_that_is_never_closed_goes_on_to_the_end() -> None:
    assert ("words", '"I am not here for you.') in found('He wrote "I am not here for you.', "quoting")


def test_each_word_of_a_quotation_is_known_and_none_of_a_report() -> None:
    assert at('He said, "I am late."', "in_quotation") == {("other", '"I'), ("other", "am"), ("other", 'late."')}
    assert at("He said that I am late.", "in_quotation") == set()

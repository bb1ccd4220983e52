"""The shipped rules take hardly more than twice the work for twice the words, for lines of various kinds. Some rules
compare each noun with those like it; a rule that joined every two words would take four times the work."""

from functools import partial

import pytest

from tests.support.operations import operations_of
from tests.support.shipped_rules import shipped_parser, shipped_rules
from tests.support.words.utterances import words_of
from understudy.model import Utterance
from understudy.rules.derivation import understand

MOST = 2.7
WORDS = 40


@pytest.mark.parametrize(
    "words",
    [
        '"a"',
        'he said "no"',
        "he said, I go,",
        "Bob and",
        "the red house, the blue house,",
        "and I know that you like those big houses that we saw",
    ],
)
def test_twice_as_many_words_are_hardly_more_than_twice_the_work(words: str) -> None:
    times = WORDS // len(words.split())
    texts = [words_of(" ".join([words] * count)) for count in (times, 2 * times)]
    utterances = [Utterance(words=each, parse=shipped_parser().parse(each)) for each in texts]
    half, whole = (operations_of(partial(understand, shipped_rules(), each)) for each in utterances)
    assert whole <= MOST * half

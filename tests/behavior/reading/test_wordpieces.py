from hypothesis import given
from hypothesis import strategies as st

from understudy.behavior.reading.wordpieces import UNKNOWN, pieces_of

PIECES = {
    piece: number
    for number, piece in enumerate((UNKNOWN, "un", "##believ", "##able", "believ", "'", "!", "don", "t", "e"))
}


def spelt(word: str) -> list[str]:
    names = {number: piece for piece, number in PIECES.items()}
    return [names[number] for number in pieces_of(word, PIECES)]


def test_a_word_is_its_longest_pieces_from_the_left() -> None:
    assert spelt("Unbelievable!") == ["un", "##believ", "##able", "!"]


def test_punctuation_stands_alone_and_accents_go() -> None:
    assert spelt("Don't") == ["don", "'", "t"]
    assert spelt("é") == ["e"]


def test_what_cannot_be_spelt_is_unknown_as_a_whole() -> None:
    assert spelt("unknown") == [UNKNOWN]
    assert spelt("") == [UNKNOWN]


@given(st.text(max_size=60))
def test_any_word_has_pieces(word: str) -> None:
    assert pieces_of(word, PIECES)

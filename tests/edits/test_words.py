"""Finding words again, and turning marked ones into a director's notes."""

import pytest

from understudy.edits.words import find_word, unmarked, with_marked
from understudy.model import Direction, Word
from understudy.model.edits import WordEdit, WordMark, WordReference

WORDS = tuple(Word(number, text) for number, text in enumerate(["No,", "not", "the", "one,", "the", "other."]))


@pytest.mark.parametrize(
    ("reference", "found"),
    [
        (WordReference(3, "one,"), 3),
        (WordReference(0, "ONE"), 3),
        (WordReference(1, "the"), 2),
        (WordReference(5, "the"), 4),
        (WordReference(3, "two"), None),
        (WordReference(3), 3),
        (WordReference(6), None),
    ],
)
def test_a_word_is_found_by_its_text_the_nearest_of_several(reference: WordReference, found: int | None) -> None:
    assert find_word(reference, WORDS) == found


def test_marked_words_become_notes_beside_the_directors_own() -> None:
    edits = [
        WordEdit(WordReference(3, "one"), mark=WordMark.IMPORTANT),
        WordEdit(WordReference(5, "other"), mark=WordMark.STILL),
    ]
    direction = with_marked(Direction(complete=True), edits, WORDS, {3: ("negation", "point_here")})
    assert direction is not None
    assert direction.complete
    important, still = direction.moments
    assert (important.stroke, important.gesture, important.importance) == (3, ("negation", "point_here"), 3)
    assert (still.stroke, still.gesture, still.head) == (5, ("still",), ("still",))


def test_without_marks_the_notes_are_as_they_were() -> None:
    edits = [WordEdit(WordReference(3, "one"), start_s=0.1, end_s=0.2)]
    assert with_marked(None, edits, WORDS, {}) is None


def test_a_mark_whose_word_is_gone_is_told() -> None:
    edits = [WordEdit(WordReference(0, "two"), mark=WordMark.STILL)]
    [notice] = unmarked(edits, WORDS)
    assert notice.code == "edit_word_gone"
    assert "words[0]: the word 'two'" in notice.message

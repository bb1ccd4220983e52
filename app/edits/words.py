"""The words that an author's edits speak of: found again, and those that are marked turned into a director's notes.

A word is found by its number and text; where another stands there, the nearest of the same text is meant.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from ..acting.vocabulary import STILL
from ..model import DirectedMoment, Direction, Notice, Word
from .values import WordEdit, WordMark, WordReference

IMPORTANCE = 3
"""Of a word marked important, as a director's note has it."""


def find_word(reference: WordReference, words: Sequence[Word]) -> int | None:
    """The number of the word that is meant; None where it is gone."""
    if reference.text is None:
        return reference.word if reference.word < len(words) else None
    wanted = _spelling(reference.text)
    same = [word.index for word in words if _spelling(word.text) == wanted]
    return min(same, key=lambda index: abs(index - reference.word), default=None)


def word_gone(where: str, reference: WordReference) -> Notice:
    """That a word of an edit is not in the line."""
    told = f"word {reference.word}" if reference.text is None else f"the word {reference.text!r}"
    return Notice("edit_word_gone", f"{where}: {told} is no longer in the line; this edit is left out")


def with_marked(
    direction: Direction | None,
    edits: Sequence[WordEdit],
    words: Sequence[Word],
    meanings: Mapping[int, tuple[str, ...]],
) -> Direction | None:
    """The director's notes with one for each word that is marked; `meanings` are the families of gestures that would be
    right on the words marked important."""
    notes = tuple(_note(mark, index, meanings) for mark, index in marked(edits, words))
    if not notes:
        return direction
    own = direction or Direction()
    return replace(own, moments=own.moments + notes)


def marked(edits: Iterable[WordEdit], words: Sequence[Word]) -> Iterator[tuple[WordMark, int]]:
    """The marks, with the words that are still there."""
    for edit in edits:
        index = find_word(edit.at, words) if edit.mark else None
        if edit.mark is not None and index is not None:
            yield edit.mark, index


def unmarked(edits: Sequence[WordEdit], words: Sequence[Word]) -> Iterator[Notice]:
    """A notice for each mark whose word is gone."""
    for number, edit in enumerate(edits):
        if edit.mark is not None and find_word(edit.at, words) is None:
            yield word_gone(f"words[{number}]", edit.at)


def _note(mark: WordMark, index: int, meanings: Mapping[int, tuple[str, ...]]) -> DirectedMoment:
    if mark is WordMark.STILL:
        return DirectedMoment(index, index, index, IMPORTANCE, gesture=(STILL,), head=(STILL,), idea="marked still")
    return DirectedMoment(index, index, index, IMPORTANCE, gesture=meanings[index], idea="marked important")


def _spelling(text: str) -> str:
    """A word without case and punctuation; as it is where it has nothing else."""
    letters = "".join(character for character in text.casefold() if character.isalnum())
    return letters or text

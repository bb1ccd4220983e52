"""Finds the words that edits refer to, and turns marked words into a director's notes.

A word is found by its number and text; if the text at that number is another, the nearest word with that text is taken.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from ..behavior.candidates.vocabulary import STILL
from ..model import DirectedMoment, Direction, Notice, Word
from ..model.edits import WordEdit, WordMark, WordReference

IMPORTANCE = 3
"""The importance of a marked word, on the scale of a director's notes."""


def find_word(reference: WordReference, words: Sequence[Word]) -> int | None:
    """The index of the word; None if it is gone."""
    if reference.text is None:
        return reference.word if reference.word < len(words) else None
    wanted = _spelling(reference.text)
    same = [word.index for word in words if _spelling(word.text) == wanted]
    return min(same, key=lambda index: abs(index - reference.word), default=None)


def word_gone(where: str, reference: WordReference) -> Notice:
    """The notice that a word is no longer in the line."""
    told = f"word {reference.word}" if reference.text is None else f"the word {reference.text!r}"
    return Notice("edit_word_gone", f"{where}: {told} is no longer in the line; this edit is left out")


def with_marked(
    direction: Direction | None,
    edits: Sequence[WordEdit],
    words: Sequence[Word],
    meanings: Mapping[int, tuple[str, ...]],
) -> Direction | None:
    """The director's notes with one added for each marked word; `meanings` has the gesture families that suit each word
    marked important."""
    notes = tuple(_note(mark, index, meanings) for mark, index in marked(edits, words))
    if not notes:
        return direction
    own = direction or Direction()
    return replace(own, moments=own.moments + notes)


def marked(edits: Iterable[WordEdit], words: Sequence[Word]) -> Iterator[tuple[WordMark, int]]:
    """Each mark with the index of its word, as far as the words still exist."""
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
    """A word without case and punctuation; unchanged if nothing else is left."""
    letters = "".join(character for character in text.casefold() if character.isalnum())
    return letters or text

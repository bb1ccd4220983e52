"""Finds the words that edits refer to, and turns marked words into a director's notes.

A word is found by its number and text; if the text at that number is another, the nearest word with that text is taken.

Corrected word times are seconds from the start of the recording. A correction is only valid for the recording it was
made for, because in another one the aligner makes other mistakes. It applies if the word is still heard at the time at
which it was heard when it was corrected.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from ..behavior.candidates.vocabulary import STILL
from ..model import DirectedMoment, Direction, Interval, Notice, Phone, Word
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
    named = f"word {reference.word}" if reference.text is None else f"the word {reference.text!r}"
    return Notice("edit_word_gone", f"{where}: {named} is no longer in the line; this edit is left out")


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


SAME_TIME_S = 0.05
"""How far a word may be from where it was heard before and still count as heard in the same recording."""


def corrected(
    words: tuple[Word, ...], edits: Sequence[WordEdit], *, duration_s: float
) -> tuple[tuple[Word, ...], tuple[Notice, ...]]:
    """The words at their corrected times, and notices about what could not be corrected.

    Neighbours are shortened, down to `SHORTEST_WORD_S`, unless they were corrected too; phones are scaled.
    """
    wanted: dict[int, tuple[int, Interval]] = {}
    notices: list[Notice] = []
    for number, edit in enumerate(edits):
        if edit.start_s is None or edit.end_s is None:
            continue
        index = find_word(edit.at, words)
        if index is None:
            notices.append(word_gone(f"words[{number}]", edit.at))
        elif _is_heard_otherwise(words[index], edit):
            message = f"words[{number}]: {words[index].text!r} is heard at another time than when it was corrected; "
            notices.append(Notice("edit_word_heard", f"{message}the correction is left out"))
        else:
            wanted[index] = number, Interval(edit.start_s, edit.end_s)
    if not wanted:
        return words, tuple(notices)
    timed, moved = _timed(words, {index: interval for index, (_number, interval) in wanted.items()}, duration_s)
    notices += (_moved(wanted[index][0], timed[index]) for index in moved)
    return timed, tuple(notices)


def _is_heard_otherwise(word: Word, edit: WordEdit) -> bool:
    """Whether the word is heard at another time than when it was corrected."""
    if edit.heard is None:
        return word.interval is None
    if word.interval is None:
        return True
    apart_s = (word.interval.start_s - edit.heard.start_s, word.interval.end_s - edit.heard.end_s)
    return any(abs(each_s) > SAME_TIME_S for each_s in apart_s)


def _timed(
    words: tuple[Word, ...], wanted: Mapping[int, Interval], duration_s: float
) -> tuple[tuple[Word, ...], list[int]]:
    """The words with the wanted times as far as their order allows, and the indices of those that got other times."""
    heard = {word.index: word.interval for word in words if word.interval}
    latest_s = _latest_ends_s(heard, wanted, duration_s)
    intervals: dict[int, Interval] = {}
    free_s = 0.0
    for index, old in heard.items():
        asked = wanted.get(index, old)
        start_s = max(min(asked.start_s, latest_s[index] - SHORTEST_WORD_S), free_s)
        longest_s = max(asked.end_s, start_s + SHORTEST_WORD_S) if index in wanted else asked.end_s
        intervals[index] = Interval(start_s, max(start_s, min(longest_s, latest_s[index])))
        free_s = intervals[index].end_s if index in wanted else start_s + SHORTEST_WORD_S
    intervals = _cut(intervals)
    moved = [index for index, interval in wanted.items() if intervals[index] != interval]
    return tuple(_with_interval(word, intervals.get(word.index)) for word in words), moved


def _latest_ends_s(
    heard: Mapping[int, Interval], wanted: Mapping[int, Interval], duration_s: float
) -> Mapping[int, float]:
    """The latest end of each word that leaves those after it `SHORTEST_WORD_S`."""
    latest_s: dict[int, float] = {}
    free_s = duration_s
    for index, old in reversed(list(heard.items())):
        latest_s[index] = free_s
        free_s = min(free_s, wanted.get(index, old).end_s) - SHORTEST_WORD_S
    return latest_s


def _cut(intervals: dict[int, Interval]) -> dict[int, Interval]:
    """Cuts each word where the next begins."""
    for index, after in pairwise(intervals):
        each = intervals[index]
        intervals[index] = Interval(each.start_s, min(each.end_s, intervals[after].start_s))
    return intervals


def _with_interval(word: Word, interval: Interval | None) -> Word:
    """The word at another time, its phones scaled with it."""
    old = word.interval
    if interval is None or old is None or interval == old:
        return word
    rate = interval.duration_s / old.duration_s if old.duration_s else 1.0

    def shifted(at_s: float) -> float:
        return round(interval.start_s + rate * (at_s - old.start_s), 6)

    phones = tuple(_at(phone, shifted) for phone in word.phones)
    return replace(word, interval=interval, phones=phones, spread=False)


def _at(phone: Phone, shifted: Callable[[float], float]) -> Phone:
    return replace(phone, interval=Interval(shifted(phone.interval.start_s), shifted(phone.interval.end_s)))


def _moved(number: int, word: Word) -> Notice:
    assert word.interval is not None, "corrected words have times"
    span = f"{word.interval.start_s:.3f} to {word.interval.end_s:.3f} s"
    return Notice("edit_word_moved", f"words[{number}]: {word.text!r} can only be at {span} beside its neighbours")


SHORTEST_WORD_S = 0.02
"""How long corrected words and their neighbours remain at least."""

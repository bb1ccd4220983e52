"""Finds the behaviours that edits refer to, although rules, words or the recording may have changed since.

A behaviour matches a reference if it is on the same channel, spans the word, and has the same function, gesture family
or lexeme. Of several, the one with most in common is taken; between equals, the one whose start after the word is
nearest to what it was.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from ..model import Behavior, Notice, Performance, Word
from ..model.edits import BehaviorEdit, BehaviorReference
from .words import find_word, word_gone

_ON_ITS_FIRST_WORD = 4
_SAME_FUNCTION = 3
_SAME_FAMILY = 2
_SAME_LEXEME = 2


@dataclass(frozen=True, slots=True)
class Found:
    """The behaviours found, by the number of their edit, and notices about those that no longer exist."""

    behaviors: Mapping[int, Behavior]
    notices: tuple[Notice, ...]


def find_behaviors(performance: Performance, edits: Sequence[BehaviorEdit]) -> Found:
    """Finds the behaviour of each edit. A behaviour belongs to the first edit that matches it."""
    words, found, notices = performance.utterance.words, dict[int, Behavior](), list[Notice]()
    for number, edit in enumerate(edits):
        if edit.of is None:
            continue
        word = find_word(edit.of.at, words)
        if word is None:
            notices.append(word_gone(f"behaviors[{number}]", edit.of.at))
            continue
        behavior = _most_alike(edit.of, words[word], performance, {each.id for each in found.values()})
        if behavior is not None:
            found[number] = behavior
        elif not edit.lock:
            notices.append(_gone(number, edit.of, words[word]))
    return Found(found, tuple(notices))


def _most_alike(
    reference: BehaviorReference, word: Word, performance: Performance, taken: Collection[str]
) -> Behavior | None:
    """The best match that no earlier edit has taken."""
    classes = {function.id: function.class_name for function in performance.functions}
    families = {moment.id: moment.families[0] for moment in performance.moments if moment.families}
    ranked = [
        (likeness, -_apart_s(reference, behavior, word), behavior.id, behavior)
        for behavior in performance.behaviors
        if behavior.kept and behavior.id not in taken and behavior.kind is reference.channel
        if (likeness := _likeness(reference, behavior, word.index, classes, families))
    ]
    return max(ranked, key=lambda each: each[:3])[3] if ranked else None


def _likeness(
    reference: BehaviorReference,
    behavior: Behavior,
    word: int,
    classes: Mapping[str, str],
    families: Mapping[str, str],
) -> int:
    """How much a behaviour has in common with the reference; 0 if it does not match."""
    if not behavior.first <= word <= behavior.last:
        return 0
    function = classes.get(behavior.function or "")
    family = families.get(behavior.moment or "")
    shared = (
        _SAME_FUNCTION * (function is not None and function == reference.function)
        + _SAME_FAMILY * (family is not None and family == reference.family)
        + _SAME_LEXEME * (behavior.lexeme == reference.lexeme)
    )
    return shared + _ON_ITS_FIRST_WORD * (behavior.first == word) if shared else 0


def _apart_s(reference: BehaviorReference, behavior: Behavior, word: Word) -> float:
    """How far a behaviour begins from its former place relative to the word."""
    if reference.offset_s is None or word.interval is None:
        return behavior.sync.start
    return abs(behavior.sync.start - word.interval.start_s - reference.offset_s)


def _gone(number: int, reference: BehaviorReference, word: Word) -> Notice:
    what = reference.lexeme or reference.family or reference.function or "behaviour"
    message = f"behaviors[{number}]: no {reference.channel} like {what} is made on {word.text!r} any more; "
    return Notice("edit_behavior_gone", f"{message}this edit is left out")

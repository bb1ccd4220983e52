"""Applies an author's edits to the performance of a line: finds the behaviours, although rules, words or the recording
may have changed since, changes them, and makes room for them.

A behaviour matches a reference if it is on the same channel, spans the word, and has the same function, gesture family
or lexeme. Of several, the one with most in common is taken; between equals, the one whose start after the word is
nearest to what it was.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import inf

from ..behavior.characters.overlays import Character
from ..behavior.choice.offered import is_offered
from ..behavior.choice.scheduling import numbered
from ..model import Behavior, Channel, Notice, Performance, SyncPoints, Utterance, Word
from ..model.edits import BehaviorEdit, BehaviorReference
from ..model.tables import SHIFT
from .forms import ChangedBehavior, added, formed, forms_of, unplayed
from .timing import INSTANT_S, SettledBehavior, moved, place_s, with_room
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


@dataclass(frozen=True, slots=True)
class _Outcome:
    """The result of an edit: its behaviour, None if it cannot be made, and notices about what could not be done."""

    edit: BehaviorEdit
    behavior: Behavior | None
    notices: tuple[Notice, ...] = ()


def edited(performance: Performance, edits: Sequence[BehaviorEdit], character: Character) -> Performance:
    """The performance with the edits applied; its notices say what could not be applied. Without edits it is unchanged.

    As before, the kept behaviours do not overlap on a channel or hand, and their sync points are in order.
    """
    if not edits:
        return performance
    found = find_behaviors(performance, edits)
    utterance = performance.utterance
    outcomes = [
        _outcome(number, edit, found.behaviors.get(number), utterance, character)
        for number, edit in enumerate(edits)
        if edit.of is None or edit.lock or number in found.behaviors
    ]
    made = [(each.edit, each.behavior) for each in outcomes if each.behavior]
    taken = {behavior.id for behavior in found.behaviors.values()}
    offered = tuple(each for each in performance.behaviors if is_offered(each))
    others = [each for each in performance.behaviors if each.id not in taken and not is_offered(each)]
    settled = with_room(
        [SettledBehavior(behavior, _lets_go(edit, behavior)) for edit, behavior in made if behavior.kept],
        [each for each in others if each.kept],
        partial(forms_of, character=character),
    )
    omitted = [behavior for _edit, behavior in made if not behavior.kept]
    behaviors = (*numbered((*settled, *omitted, *(each for each in others if not each.kept))), *offered)
    notices = [notice for each in outcomes for notice in each.notices]
    told = (*performance.notices, *found.notices, *notices, *_crowded_out(settled))
    return replace(performance, behaviors=behaviors, notices=told)


def _outcome(
    number: int, edit: BehaviorEdit, behavior: Behavior | None, utterance: Utterance, character: Character
) -> _Outcome:
    """The behaviour that one edit changes or adds."""
    words = utterance.words
    if edit.omit is not None and behavior is not None:
        return _Outcome(edit, replace(behavior, kept=False, reason=f"{edit.omit} by the author", edit=number))
    made = _formed(number, edit, behavior, words, character)
    if made.behavior is None or edit.omit is not None:
        return _Outcome(edit, None, made.notices)
    placed, notices = _moved(number, edit, made.behavior, words, utterance.duration_s or inf)
    return _Outcome(edit, placed, made.notices + notices)


def _formed(
    number: int, edit: BehaviorEdit, behavior: Behavior | None, words: Sequence[Word], character: Character
) -> ChangedBehavior:
    """The behaviour before its marks are moved."""
    if behavior is not None:
        return formed(edit, number, behavior, character)
    word = find_word(edit.word, words)
    if word is None:
        return ChangedBehavior(None, (word_gone(f"behaviors[{number}]", edit.word),) if edit.of is None else ())
    return added(edit, number, word, words, character)


def _moved(
    number: int, edit: BehaviorEdit, behavior: Behavior, words: Sequence[Word], end_s: float
) -> tuple[Behavior, tuple[Notice, ...]]:
    """The behaviour with its sync points where the author put them, or as near as possible."""
    marks = dict(edit.marks.in_order())
    places = {name: place_s(place, words) for name, place in marks.items()}
    gone = [place for name, place in marks.items() if places[name] is None]
    wanted_s = {name: at_s for name, at_s in places.items() if at_s is not None}
    if not wanted_s:
        return behavior, tuple(word_gone(f"behaviors[{number}].marks", place.at) for place in gone)
    outcome = moved(behavior.sync, wanted_s, end_s=end_s, lasting=_is_lasting(behavior))
    notices = (
        *(word_gone(f"behaviors[{number}].marks", place.at) for place in gone),
        *(_refused(number, name, at_s, behavior) for name, at_s in outcome.refused),
    )
    return replace(behavior, sync=_left(behavior, outcome.sync)), notices


def _left(behavior: Behavior, sync: SyncPoints) -> SyncPoints:
    """Leaving a posture takes an instant, because a BML posture whose end equals its relax point is held for good."""
    if behavior.kind is not Channel.POSTURE or _is_lasting(behavior) or sync.relax is None:
        return sync
    return replace(sync, end=max(sync.end, round(sync.relax + INSTANT_S, 3)))


def _is_lasting(behavior: Behavior) -> bool:
    """Whether the behaviour changes a state that lasts after it."""
    sync = behavior.sync
    lasts = behavior.lexeme == SHIFT if behavior.kind is Channel.GAZE else behavior.kind is Channel.POSTURE
    return lasts and sync.ready is not None and sync.ready >= sync.end


def _lets_go(edit: BehaviorEdit, behavior: Behavior) -> bool:
    """Whether the author left its end open, so that its retraction may be shortened."""
    return edit.marks.relax is None and edit.marks.end is None and not _is_lasting(behavior)


def _refused(number: int, name: str, at_s: float, behavior: Behavior) -> Notice:
    message = f"behaviors[{number}].marks.{name}: {behavior.lexeme} cannot have it at {at_s:.3f} s; "
    return Notice("edit_mark_moved", f"{message}it is as near as the order of its marks and the line allow")


def _crowded_out(settled: Iterable[Behavior]) -> Iterator[Notice]:
    """A notice for each edit whose behaviour is in the way of another edit's."""
    for behavior in settled:
        if behavior.edit is not None and not behavior.kept:
            yield unplayed(behavior.edit, f"{behavior.lexeme} is {behavior.reason}")

"""A line's delivery as data for a realizer: lip sync, the phrases between pauses, and the times of stress.

Lip sync says which of fifteen mouth shapes falls when, and how far the mouth goes into it (paper §3.8).

Departure from §3.8: the paper animates hand-made curves of diphones; its curves are not public, so we give the shapes
of the single phones, with their times, for the character's own rig to blend. Shapes and phones as in
docs/references.md; HH, which has no shape of its own, takes that of the phone after it.

The paper has "the word stress value drive the open-mouth shape" without a figure: here the vowels of a word reach
`LEAST_ARTICULATION` of their shape without emphasis, and all of it with the greatest emphasis. Consonants always reach
their shape, since lips that do not close are no P.

The lips are shut in the first two thirds of a P before another sound: after the burst comes aspiration (58 ms in
stressed syllables, Lisker & Abramson 1964), in which the mouth already has the next sound's shape. Aligners include it
in the P; in TIMIT, whose closures and bursts are labelled separately, a third of the P is burst and aspiration.

Phrases stand for intonation units, in which gestures flow into each other (Kipp, Neff et al. 2007, §3.3, take a
segmentation of the utterance): they end at a pause or the end of a sentence. Times are seconds of the words' intervals.

Where a text says which words are its rheme, gestures repeat their strokes on the emphases of the rheme (Gesture Engine
§5.1).
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from types import MappingProxyType

from ..model import Behavior, Channel, Function, Interval, Notice, Phone, Viseme, Word
from ..model.tables import OPENINGS, PHONES, SILENCE
from .timing.anchoring import stressed_vowel_s

SHORTEST_PAUSE_S = 0.2

SHORTEST_STROKE_S = 0.35
"""Between the ends of two strokes (`realizer/scheduling/repetition.py`)."""

_SENTENCE_ENDS = (".", "!", "?", ";", ":")
_CLOSERS = "\"'”’)]"


def phrases(words: tuple[Word, ...]) -> tuple[Interval, ...]:
    """The intervals of speech; words without times are in none."""
    return tuple(_phrases([word for word in words if word.interval]))


def emphases_s(words: tuple[Word, ...]) -> tuple[float, ...]:
    """The times at which the stressed vowels of the emphasised words begin."""
    return tuple(sorted(stressed_vowel_s(word) for word in words if word.interval and word.is_emphasised))


def expanded_in_rhemes(
    behaviors: Iterable[Behavior], words: tuple[Word, ...], functions: Sequence[Function]
) -> tuple[Behavior, ...]:
    """The behaviours, where those gestures whose stroke is in a rheme ask for further strokes on all of its later
    emphases: "If multiple intonational emphases are present within a rheme clause for which an appropriate gesture has
    been found […], that gesture's stroke will be repeated" (Gesture Engine §5.1)."""
    rhemes = [range(each.first, each.last + 1) for each in functions if each.given and _is_rheme(each)]
    if not rhemes:
        return tuple(behaviors)
    return tuple(_expanded(each, words, rhemes) for each in behaviors)


def _is_rheme(function: Function) -> bool:
    return (function.class_name, function.subtype) == ("information", "rheme")


def _expanded(behavior: Behavior, words: tuple[Word, ...], rhemes: Sequence[range]) -> Behavior:
    stroke_end_s = behavior.sync.stroke_end
    if behavior.kind is not Channel.GESTURE or stroke_end_s is None or behavior.after_strokes_s is not None:
        return behavior
    rheme = next((each for each in rhemes if behavior.first in each or behavior.last in each), None)
    if rheme is None:
        return behavior
    later = (time_s - stroke_end_s for time_s in emphases_s(tuple(word for word in words if word.index in rheme)))
    after_s = tuple(round(each, 3) for each in later if each >= SHORTEST_STROKE_S)
    return replace(behavior, after_strokes_s=after_s) if after_s else behavior


def _phrases(timed: list[Word]) -> Iterator[Interval]:
    first = 0
    for place, (word, following) in enumerate(pairwise(timed), start=1):
        if word.interval and following.interval and _parted(word, following.interval.start_s - word.interval.end_s):
            yield _whole(timed[first:place])
            first = place
    if timed:
        yield _whole(timed[first:])


def _whole(words: list[Word]) -> Interval:
    intervals = [word.interval for word in words if word.interval]
    return Interval(intervals[0].start_s, intervals[-1].end_s)


def _parted(word: Word, pause_s: float) -> bool:
    return pause_s >= SHORTEST_PAUSE_S or word.text.rstrip(_CLOSERS).endswith(_SENTENCE_ENDS)


LEAST_ARTICULATION = 0.6
ASPIRATION = 1 / 3
"""The share of a P after its burst."""

_VOWELS = frozenset({"aa", "E", "I", "O", "U"})
_SHAPES: Mapping[str, str] = MappingProxyType({phone: shape for shape, phones in PHONES.items() for phone in phones})


def visemes(words: tuple[Word, ...], duration_s: float) -> tuple[tuple[Viseme, ...], tuple[Notice, ...]]:
    """The mouth shapes from 0 to `duration_s`, one after the other without gaps or overlaps.

    Timed words whose phones are not known are silent, with a Notice `visemes_missing`.
    """
    shapes = _merged([viseme for word in words for viseme in _of_word(word)])
    mute = [word.text for word in words if word.interval and not word.phones]
    return tuple(_with_silence(shapes, duration_s)), _missing(mute)


def _of_word(word: Word) -> Iterator[Viseme]:
    scale = _articulation(word.emphasis or 0.0)
    for interval, label in zip(_intervals(word.phones), _labels(word.phones), strict=True):
        if interval.duration_s > 0:
            articulation = scale if label in _VOWELS else 1.0
            yield Viseme(label, interval, articulation, OPENINGS[label] * articulation)


def _intervals(phones: tuple[Phone, ...]) -> list[Interval]:
    """The interval of each phone's shape; the aspiration of a P has the shape of the next phone."""
    intervals = [phone.interval for phone in phones]
    for index, phone in enumerate(phones[:-1]):
        if phone.label == "P":
            burst_s = round(phone.interval.end_s - ASPIRATION * phone.interval.duration_s, 3)
            intervals[index] = replace(phone.interval, end_s=burst_s)
            intervals[index + 1] = replace(intervals[index + 1], start_s=burst_s)
    return intervals


def _articulation(emphasis: float) -> float:
    return LEAST_ARTICULATION + (1 - LEAST_ARTICULATION) * emphasis


def _labels(phones: tuple[Phone, ...]) -> list[str]:
    """The shape of each phone; one without a shape takes that of the next phone that has one, or else of the last."""
    labels = [_SHAPES.get(phone.label) for phone in phones]
    known = [label for label in labels if label]
    following = known[-1] if known else SILENCE
    filled = []
    for label in reversed(labels):
        following = label or following
        filled.append(following)
    return filled[::-1]


def _merged(shapes: list[Viseme]) -> list[Viseme]:
    """Merges equal shapes that touch."""
    merged: list[Viseme] = []
    for shape in shapes:
        last = merged[-1] if merged else None
        if last and last.label == shape.label and last.interval.end_s == shape.interval.start_s:
            merged[-1] = replace(
                max(last, shape, key=lambda each: each.articulation),
                interval=Interval(last.interval.start_s, shape.interval.end_s),
            )
        else:
            merged.append(shape)
    return merged


def _with_silence(shapes: list[Viseme], duration_s: float) -> Iterator[Viseme]:
    """The shapes, cut where they overlap or exceed the end, with silence in the gaps."""
    at_s = 0.0
    for shape in shapes:
        interval = Interval(max(shape.interval.start_s, at_s), min(shape.interval.end_s, duration_s))
        if interval.duration_s <= 0:
            continue
        if interval.start_s > at_s:
            yield _silence(at_s, interval.start_s)
        yield shape if interval == shape.interval else replace(shape, interval=interval)
        at_s = interval.end_s
    if duration_s > at_s:
        yield _silence(at_s, duration_s)


def _silence(start_s: float, end_s: float) -> Viseme:
    return Viseme(SILENCE, Interval(start_s, end_s), articulation=0.0, opening=0.0)


def _missing(mute: list[str]) -> tuple[Notice, ...]:
    if not mute:
        return ()
    shown = ", ".join(repr(text) for text in mute[:3]) + (", …" if len(mute) > 3 else "")
    message = f"the mouth stays shut in {len(mute)} words whose phones are not known ({shown}); send words with phones"
    return (Notice("visemes_missing", message),)

"""What annotations show, as plain observations: each gesture with its words and the gesture before it, and each tag
with what came of it. Times are seconds."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from ...model import Hand, Interval, Word
from ..annotation.model import Annotation, Phrase, TaggedWords
from ..profile import ANY_TAG, FIRST
from ..segments import time_of

NONE = ""
"""The lexeme of no gesture."""


@dataclass(frozen=True, slots=True)
class ObservedGesture:
    """A gesture, its tags, the lexeme and hand before it in the recording (None before the first), how long the main
    stroke ends after its word does, and the time from the stroke before to this one if both are in one segment."""

    phrase: Phrase
    tags: tuple[str, ...]
    before: str
    hand_before: Hand | None
    offset_s: float | None
    gap_s: float | None
    joined: bool


@dataclass(frozen=True, slots=True)
class ObservedTag:
    """A tag that was said, and what came with it: shares of lexemes and of none, which sum to 1.

    Where a gesture's words have several tags, each has its part of it.
    """

    tag: str
    outcome: Mapping[str, float]


def observed_gestures(annotation: Annotation) -> Iterator[ObservedGesture]:
    """The gestures of a recording in order of time."""
    unit_of = {phrase.interval: number for number, unit in enumerate(annotation.units) for phrase in unit.phrases}
    before: Phrase | None = None
    for phrase in annotation.phrases:
        words = words_meant(phrase, annotation.words)
        yield ObservedGesture(
            phrase=phrase,
            tags=tuple(each.tag for each in tags_meant(phrase, annotation)) if phrase.tag is None else (phrase.tag,),
            before=before.lexeme if before else FIRST,
            hand_before=before.hand if before else None,
            offset_s=phrase.main_s.end_s - time_of(annotation.words[words[1]]).end_s if words else None,
            gap_s=_gap_s(before, phrase, annotation),
            joined=before is not None and unit_of[before.interval] == unit_of[phrase.interval],
        )
        before = phrase


def observed_tags(annotation: Annotation) -> Iterator[ObservedTag]:
    """The tags of a recording, each with what came of it."""
    said = annotation.tags or ()
    outcomes: list[dict[str, float]] = [{} for _each in said]
    for phrase in annotation.phrases:
        meant = tags_meant(phrase, annotation)
        places = [place for place, each in enumerate(said) if any(each is other for other in meant)]
        for place in places:
            outcomes[place][phrase.lexeme] = outcomes[place].get(phrase.lexeme, 0.0) + 1 / len(places)
    for number, each in enumerate(said):
        shown = outcomes[number]
        scale = 1 / max(1.0, sum(shown.values()))
        outcome = {lexeme: scale * share for lexeme, share in shown.items()}
        yield ObservedTag(each.tag, {**outcome, NONE: 1 - sum(outcome.values())})


def words_meant(phrase: Phrase, words: Sequence[Word]) -> tuple[int, int] | None:
    """A phrase's affiliate, else the words that co-occur with its stroke."""
    if phrase.affiliate is not None:
        return phrase.affiliate
    main = phrase.main_s
    inside = [word.index for word in words if word.interval and _overlap(word.interval, main)]
    return (inside[0], inside[-1]) if inside else None


def tags_meant(phrase: Phrase, annotation: Annotation) -> tuple[TaggedWords, ...]:
    """The tags on the words that a phrase means, those of its own tag alone if it has one."""
    words = words_meant(phrase, annotation.words)
    if words is None:
        return ()
    on_words = [each for each in annotation.tags or () if each.first <= words[1] and words[0] <= each.last]
    return tuple(each for each in on_words if phrase.tag in (None, each.tag))


def level_tags(tag: str) -> tuple[str, ...]:
    """A tag, its class, and any: what is known of each stands for the one before."""
    return tuple(dict.fromkeys((tag, tag.partition(".")[0], ANY_TAG)))


def all_of(annotations: Iterable[Annotation]) -> tuple[tuple[ObservedGesture, ...], tuple[ObservedTag, ...]]:
    """The gestures and tags of several recordings."""
    recordings = tuple(annotations)
    gestures = tuple(each for annotation in recordings for each in observed_gestures(annotation))
    return gestures, tuple(each for annotation in recordings for each in observed_tags(annotation))


def _gap_s(before: Phrase | None, phrase: Phrase, annotation: Annotation) -> float | None:
    """From the last stroke of the gesture before to this one's first; None across segments."""
    if before is None or _segment(before, annotation) != _segment(phrase, annotation):
        return None
    last = before.strokes[-1] if before.strokes else before.main_s
    return phrase.main_s.start_s - last.end_s


def _segment(phrase: Phrase, annotation: Annotation) -> int:
    words = words_meant(phrase, annotation.words)
    place = words[1] if words else -1
    return next((number for number, (first, last) in enumerate(annotation.segments) if first <= place <= last), -1)


def _overlap(one: Interval, other: Interval) -> bool:
    return one.start_s < other.end_s and other.start_s < one.end_s

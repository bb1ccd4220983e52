"""Extracts observations from annotations: each gesture with its words and the previous gesture, and each tag with the
gestures that accompany it. Times are seconds."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from ...model import Hand, Word
from ..annotation.model import Annotation, GesturePhrase, TaggedWords
from ..annotation.spans import words_in_time
from ..annotation.tracks import InTime
from ..profile import ANY_TAG, FIRST
from ..segments import time_of

NONE = ""
"""The lexeme that stands for the absence of a gesture."""

HALF = 0.5
"""An interval of word numbers is widened by half a word, so that it overlaps the words it names."""


@dataclass(frozen=True, slots=True)
class ObservedGesture:
    """A gesture, its tags, the previous lexeme and hand in the recording (None for the first), the time from the end of
    its word to the end of the main stroke, and the time from the previous stroke if both are in one segment."""

    phrase: GesturePhrase
    tags: tuple[str, ...]
    before: str
    hand_before: Hand | None
    offset_s: float | None
    gap_s: float | None
    joined: bool


@dataclass(frozen=True, slots=True)
class ObservedTag:
    """A tag in the recording and the shares of lexemes, and of no gesture, that accompany it; they sum to 1.

    If a gesture's words have several tags, the gesture is divided among them.
    """

    tag: str
    outcome: Mapping[str, float]


@dataclass(frozen=True, slots=True, eq=False)
class _Recording:
    """An annotation with indices of words, tags and segments by time and by word; tags are identified by position."""

    words: InTime[Word]
    tags: tuple[TaggedWords, ...]
    tags_on: InTime[int]
    segments: InTime[int]

    @classmethod
    def of(cls, annotation: Annotation) -> "_Recording":
        tags, segments = annotation.tags or (), annotation.segments
        return cls(
            words=words_in_time(word for word in annotation.words if word.interval),
            tags=tags,
            tags_on=InTime.of(range(len(tags)), lambda place: (tags[place].first, tags[place].last)),
            segments=InTime.of(range(len(segments)), lambda place: segments[place]),
        )

    def meant(self, phrase: GesturePhrase) -> tuple[int, int] | None:
        """A phrase's affiliate; by default the words that overlap its stroke."""
        if phrase.affiliate is not None:
            return phrase.affiliate
        inside = self.words.touching(phrase.main_s.start_s, phrase.main_s.end_s)
        return (inside[0].index, inside[-1].index) if inside else None

    def places_meant(self, phrase: GesturePhrase) -> list[int]:
        """The positions of the tags on a phrase's affiliate; only of the phrase's own tag if it has one."""
        words = self.meant(phrase)
        on_words = self.tags_on.touching(words[0] - HALF, words[1] + HALF) if words else ()
        return sorted(place for place in on_words if phrase.tag in (None, self.tags[place].tag))

    def segment(self, phrase: GesturePhrase) -> int:
        """The number of the segment that contains a phrase; -1 for none."""
        words = self.meant(phrase)
        held = self.segments.touching(words[1] - HALF, words[1] + HALF) if words else ()
        return held[0] if held else -1


def observed_gestures(annotation: Annotation) -> Iterator[ObservedGesture]:
    """The gestures of a recording in order of time."""
    recording = _Recording.of(annotation)
    unit_of = {phrase.interval: number for number, unit in enumerate(annotation.units) for phrase in unit.phrases}
    before: GesturePhrase | None = None
    for phrase in annotation.phrases:
        words = recording.meant(phrase)
        tags = tuple(recording.tags[place].tag for place in recording.places_meant(phrase))
        yield ObservedGesture(
            phrase=phrase,
            tags=tags if phrase.tag is None else (phrase.tag,),
            before=before.lexeme if before else FIRST,
            hand_before=before.hand if before else None,
            offset_s=phrase.main_s.end_s - time_of(annotation.words[words[1]]).end_s if words else None,
            gap_s=_gap_s(before, phrase, recording),
            joined=before is not None and unit_of[before.interval] == unit_of[phrase.interval],
        )
        before = phrase


def observed_tags(annotation: Annotation) -> Iterator[ObservedTag]:
    """The tags of a recording, each with the gestures that accompany it."""
    recording = _Recording.of(annotation)
    outcomes: list[dict[str, float]] = [{} for _each in recording.tags]
    for phrase in annotation.phrases:
        places = recording.places_meant(phrase)
        for place in places:
            outcomes[place][phrase.lexeme] = outcomes[place].get(phrase.lexeme, 0.0) + 1 / len(places)
    for each, shown in zip(recording.tags, outcomes, strict=True):
        scale = 1 / max(1.0, sum(shown.values()))
        outcome = {lexeme: scale * share for lexeme, share in shown.items()}
        yield ObservedTag(each.tag, {**outcome, NONE: 1 - sum(outcome.values())})


def level_tags(tag: str) -> tuple[str, ...]:
    """The tag, its class, and `any`: each is the fallback of the one before."""
    return tuple(dict.fromkeys((tag, tag.partition(".")[0], ANY_TAG)))


def all_of(annotations: Iterable[Annotation]) -> tuple[tuple[ObservedGesture, ...], tuple[ObservedTag, ...]]:
    """The gestures and tags of several recordings."""
    recordings = tuple(annotations)
    gestures = tuple(each for annotation in recordings for each in observed_gestures(annotation))
    return gestures, tuple(each for annotation in recordings for each in observed_tags(annotation))


def _gap_s(before: GesturePhrase | None, phrase: GesturePhrase, recording: _Recording) -> float | None:
    """The time from the last stroke of the previous gesture to the first of this one; None across segments."""
    if before is None or recording.segment(before) != recording.segment(phrase):
        return None
    last = before.strokes[-1] if before.strokes else before.main_s
    return phrase.main_s.start_s - last.end_s

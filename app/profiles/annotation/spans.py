"""Converts the spans of tracks to values; their labels and attributes are checked, and mistakes recorded with their
times."""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path
from typing import TypeVar

from ...errors import did_you_mean
from ...model import Hand, Interval, Word
from ..segments import time_of
from .model import AnnotationMistake, LabelledInterval, PathForm, PhaseKind, Position, Swivel, TaggedWords
from .tracks import PHRASE_ATTRIBUTES, InTime, Track, TrackSpan

SIDEWAYS = ("XEP", "XP", "XC", "XCC", "XOppC", "XOppP", "XOppEP")
HEIGHTS = ("YUpperEP", "YUpperP", "YUpperC", "YCC", "YLowerC", "YLowerP", "YLowerEP")
DEPTHS = ("ZNear", "ZMiddle", "ZFar")
"""The sectors of gesture space in the terms of the gesture language (docs/gesture-language.md), ordered from the hand's
own side across, from the top down, and from the body outwards."""

HANDS: Mapping[str, Hand] = {
    "rh": Hand.RIGHT,
    "right": Hand.RIGHT,
    "lh": Hand.LEFT,
    "left": Hand.LEFT,
    "2h": Hand.BOTH,
    "both": Hand.BOTH,
}
PHASES: Mapping[str, PhaseKind] = {
    **{kind.value: kind for kind in PhaseKind},
    "prep": PhaseKind.PREPARATION,
    "retract": PhaseKind.RETRACTION,
    "indep._hold": PhaseKind.INDEPENDENT_HOLD,
    "independent_hold": PhaseKind.INDEPENDENT_HOLD,
    "post-stroke_hold": PhaseKind.HOLD,
    "pre-stroke_hold": PhaseKind.HOLD,
}
RESTS = ("clasped", "at_side", "in_pockets", "folded", "behind_back", "on_hips", "open")
"""The rest poses of the hands (docs/realizer-arms.md)."""

TOUCHING_S = 0.02
"""The tolerance for overlapping or protruding spans: half a frame of video."""

_LEXEME = re.compile(r"[A-Z][A-Z0-9_]*")
_WORDS = re.compile(r"(\d+)(?:\s*-\s*(\d+))?")
Named = TypeVar("Named", bound=StrEnum)


@dataclass(slots=True)
class Checking:
    """The state of checking a file: the mistakes so far, the timed words and the places of each, the playable lexemes
    and existing tags (None: any), and whether any phrase has a hand."""

    path: Path
    lexemes: Collection[str] | None = None
    tags: Collection[str] | None = None
    words: InTime[Word] = field(default_factory=lambda: words_in_time(()))
    places: Mapping[str, Sequence[int]] = field(default_factory=dict)
    hands_said: bool = True
    mistakes: list[AnnotationMistake] = field(default_factory=list)

    def wrong(self, track: str, time_s: float | None, message: str) -> None:
        """Records a mistake."""
        self.mistakes.append(AnnotationMistake(self.path, message, track, time_s))

    def words_in(self, start_s: float, end_s: float) -> tuple[int, int] | None:
        """The first and last word that overlap an interval."""
        inside = self.words.touching(start_s, end_s)
        return (inside[0].index, inside[-1].index) if inside else None


def checked_times(track: Track, checking: Checking, *, overlapping: bool = False) -> Iterator[TrackSpan]:
    """The spans of positive duration, in order; spans before 0, without duration or overlapping the previous one are
    mistakes."""
    last: TrackSpan | None = None
    for span in track.spans:
        if span.start_s < 0 or span.end_s <= span.start_s:
            checking.wrong(
                track.name, span.start_s, f"ends at {span.end_s:.3f} s; a span starts at 0 or later, ends later"
            )
            continue
        if last is not None and not overlapping and span.start_s < last.end_s - TOUCHING_S:
            checking.wrong(track.name, span.start_s, f"overlaps {last.label!r}, which ends at {last.end_s:.3f} s")
        yield span
        last = span


def words_in_time(words: Iterable[Word]) -> InTime[Word]:
    """The timed words."""
    return InTime.of(words, lambda word: (time_of(word).start_s, time_of(word).end_s))


def places_of(words: Iterable[Word]) -> dict[str, list[int]]:
    """The numbers of the words by their normalized text."""
    places: dict[str, list[int]] = {}
    for word in words:
        places.setdefault(_bare(word.text), []).append(word.index)
    return places


def words_of(track: Track, checking: Checking) -> tuple[Word, ...]:
    """The numbered words of a track; spans without a label are silence."""
    spans = [span for span in checked_times(track, checking) if span.label]
    return tuple(Word(number, span.label, Interval(span.start_s, span.end_s)) for number, span in enumerate(spans))


def tags_of(track: Track, checking: Checking) -> Iterator[TaggedWords]:
    """The tags of a track, on the words within their time; tags may overlap."""
    for span in checked_times(track, checking, overlapping=True):
        words = checking.words_in(span.start_s + TOUCHING_S, span.end_s - TOUCHING_S)
        if words is None:
            checking.wrong(track.name, span.start_s, f"no word is said in the time of the tag {span.label!r}")
        elif span.label:
            _check_tag(span.label, track.name, span, checking)
            yield TaggedWords(span.label, *words)


def tag_of(span: TrackSpan, checking: Checking) -> str | None:
    """The tag of a phrase, if it has one."""
    tag = span.attributes.get("tag")
    if tag:
        _check_tag(tag, "phrases", span, checking)
    return tag or None


def _check_tag(tag: str, track: str, span: TrackSpan, checking: Checking) -> None:
    """Records a mistake if a tag is not a communicative function, since no words could have it."""
    if checking.tags is not None and tag not in checking.tags:
        message = f"no function is called {tag!r}{did_you_mean(tag, checking.tags)} (docs/functions.md)"
        checking.wrong(track, span.start_s, message)


def labelled_of(track: Track, checking: Checking) -> tuple[LabelledInterval, ...]:
    """The spans with their labels."""
    return tuple(
        LabelledInterval(Interval(span.start_s, span.end_s), span.label) for span in checked_times(track, checking)
    )


def phase_kind(span: TrackSpan, checking: Checking) -> PhaseKind | None:
    """The kind of a phase."""
    name = span.label.strip().lower().replace(" ", "_")
    if name not in PHASES:
        checking.wrong("phases", span.start_s, f"no phase is called {span.label!r}{did_you_mean(name, PHASES)}")
    return PHASES.get(name)


def rest_of(span: TrackSpan, checking: Checking) -> str | None:
    """The rest pose after a unit; None if not annotated."""
    rest = span.label.strip().lower().replace(" ", "_")
    if rest and rest not in RESTS:
        hint = did_you_mean(rest, RESTS)
        message = f"the hands have no rest pose {span.label!r}{hint}; give one of {', '.join(RESTS)}, or nothing"
        checking.wrong("units", span.start_s, message)
    return rest or None


def lexeme_of(span: TrackSpan, checking: Checking) -> str:
    """The lexeme of a phrase, which must be in the gesture library."""
    lexeme = (span.label or span.attributes.get("lexeme", "")).strip().upper().replace(" ", "_").replace("-", "_")
    if not _LEXEME.fullmatch(lexeme):
        checking.wrong(
            "phrases", span.start_s, f"{span.label!r} is not a lexeme: letters, digits and _, a letter first"
        )
    elif checking.lexemes is not None and lexeme not in checking.lexemes:
        hint = did_you_mean(lexeme, checking.lexemes)
        checking.wrong("phrases", span.start_s, f"the library has no gesture {lexeme!r}{hint}")
    return lexeme


def unknown_attributes(span: TrackSpan, checking: Checking) -> None:
    """Records a mistake for each unknown attribute of a phrase."""
    for name in span.attributes.keys() - PHRASE_ATTRIBUTES:
        message = f"a phrase has no attribute {name!r}{did_you_mean(name, PHRASE_ATTRIBUTES)}"
        checking.wrong("phrases", span.start_s, message)


def hand_of(span: TrackSpan, checking: Checking) -> Hand:
    """The hand of a phrase, which is required; if no phrase has one, the track is reported once."""
    said = span.attributes.get("hand", "").strip().lower()
    if said not in HANDS and (said or checking.hands_said):
        checking.wrong("phrases", span.start_s, f"hand {said!r}; give RH, LH or 2H")
    return HANDS.get(said, Hand.RIGHT)


def path_of(span: TrackSpan, checking: Checking) -> PathForm:
    """The form of the stroke's path, straight by default."""
    said = span.attributes.get("path", PathForm.STRAIGHT).strip().lower()
    if said not in set(PathForm):
        checking.wrong("phrases", span.start_s, f"path {said!r}; give straight or curved")
        return PathForm.STRAIGHT
    return PathForm(said)


def position_of(span: TrackSpan, name: str, checking: Checking) -> Position | None:
    """The position of the hand at the start (`from`) or end (`to`) of the stroke; None if not annotated."""
    said = span.attributes.get(name, "").split()
    if not said:
        return None
    parts = [next((each for each in known if each in said), None) for known in (SIDEWAYS, HEIGHTS, DEPTHS)]
    swivel = next((each for each in Swivel if each in said), Swivel.NORMAL)
    extra = [word for word in said if word not in {*parts, *Swivel}]
    if None in parts or extra:
        message = (
            f"{name} {' '.join(said)!r}; give a sector across, in height and away, such as 'XC YCC ZMiddle normal'"
        )
        checking.wrong("phrases", span.start_s, message)
        return None
    sideways, height, depth = map(str, parts)
    return Position(sideways, height, depth, swivel)


def affiliate_of(span: TrackSpan, checking: Checking) -> tuple[int, int] | None:
    """The lexical affiliate of a phrase, given by numbers (`3`, `3-4`) or by the words themselves, of which the nearest
    occurrence in time is taken; None if not annotated."""
    said = span.attributes.get("affiliate", "").strip()
    if not said:
        return None
    numbers = _WORDS.fullmatch(said)
    found = (int(numbers[1]), int(numbers[2] or numbers[1])) if numbers else _nearest(said.split(), span, checking)
    if found is None or not found[0] <= found[1] < len(checking.words.things):
        checking.wrong("phrases", span.start_s, f"affiliate {said!r}: there are no such words")
        return None
    return found


def _nearest(said: Sequence[str], span: TrackSpan, checking: Checking) -> tuple[int, int] | None:
    wanted, words = [_bare(each) for each in said], checking.words
    starts = [
        first
        for first in checking.places.get(wanted[0], ())
        if [_bare(word.text) for word in words.things[first : first + len(wanted)]] == wanted
    ]
    first = min(starts, key=lambda each: abs(words.starts[each] - span.middle_s), default=None)
    return None if first is None else (first, first + len(wanted) - 1)


def _bare(text: str) -> str:
    return "".join(character for character in text.lower() if character.isalnum())

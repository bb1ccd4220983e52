"""Reads annotations in all supported formats, joins phases to phrases and phrases to units (NGS §3.1), and checks them.
The mistakes of all files are reported at once.

A phrase consists of an optional preparation, followed by holds and at least one stroke, or by one independent hold. A
retraction is the last phase of a unit, and may lie in its last phrase or after it. Phases outside a phrase or unit,
phrases outside a unit, and contradictory phases are mistakes.
"""

from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TypeVar

from ...errors import UnsupportedFormatError, did_you_mean
from ...model import Interval
from ..segments import segments_of
from .anvil import read_anvil
from .elan import read_elan
from .model import Annotation, AnnotationError, AnnotationMistake, GesturePhrase, Phase, PhaseKind, Unit
from .spans import (
    TOUCHING_S,
    Checking,
    affiliate_of,
    checked_times,
    hand_of,
    labelled_of,
    lexeme_of,
    path_of,
    phase_kind,
    places_of,
    position_of,
    rest_of,
    tag_of,
    tags_of,
    unknown_attributes,
    words_in_time,
    words_of,
)
from .tables import read_csv, read_json
from .textgrid import read_textgrid
from .tracks import KNOWN, NEEDED, InTime, Track, TrackSpan, stray_attributes, with_attributes

Marked = TypeVar("Marked", Phase, GesturePhrase)


def units_of(phases: Track, phrases: Track, units: Track, checking: Checking) -> tuple[Unit, ...]:
    """The units with their phrases and phases."""
    every = tuple(_phases(phases, checking))
    moving = _in_time([phase for phase in every if phase.kind is not PhaseKind.RETRACTION])
    back = _in_time([phase for phase in every if phase.kind is PhaseKind.RETRACTION])
    wholes = list(checked_times(units, checking))
    _check_hands(phrases, checking)
    made = (_phrase(span, moving, checking) for span in checked_times(phrases, checking))
    parts = _in_time([phrase for phrase in made if phrase is not None])
    for phase in _outside(moving.things, [part.interval for part in parts.things]):
        checking.wrong("phases", phase.interval.start_s, f"the {phase.kind} lies in no phrase that can be used")
    for part in _outside(parts.things, map(_interval, wholes)):
        checking.wrong("phrases", part.interval.start_s, f"{part.lexeme} lies in no unit")
    for retraction in _outside(back.things, map(_interval, wholes)):
        checking.wrong("phases", retraction.interval.start_s, "the retraction lies in no unit")
    return tuple(_unit(whole, parts, back, checking) for whole in wholes)


def _in_time(things: Iterable[Marked]) -> InTime[Marked]:
    return InTime.of(things, lambda thing: (thing.interval.start_s, thing.interval.end_s))


def _within(parts: InTime[Marked], whole: TrackSpan) -> tuple[Marked, ...]:
    return parts.within(whole.start_s - TOUCHING_S, whole.end_s + TOUCHING_S)


def _outside(parts: Iterable[Marked], wholes: Iterable[Interval]) -> Iterator[Marked]:
    """The parts that lie within no whole."""
    held = InTime.of(wholes, lambda whole: (whole.start_s - TOUCHING_S, whole.end_s + TOUCHING_S))
    yield from (part for part in parts if not held.any_holds(part.interval.start_s, part.interval.end_s))


def _phases(track: Track, checking: Checking) -> Iterator[Phase]:
    for span in checked_times(track, checking):
        kind = phase_kind(span, checking)
        if kind is not None:
            yield Phase(kind, _interval(span))


def _check_hands(phrases: Track, checking: Checking) -> None:
    """If no phrase has a hand, reports one mistake for the track."""
    checking.hands_said = not phrases.spans or any(span.attributes.get("hand") for span in phrases.spans)
    if not checking.hands_said:
        message = "no phrase has a hand: give each the attribute hand, or a track phrases.hand, with RH, LH or 2H"
        checking.wrong("phrases", None, message)


def _phrase(span: TrackSpan, phases: InTime[Phase], checking: Checking) -> GesturePhrase | None:
    own = _within(phases, span)
    message = _contradiction(own)
    if message:
        checking.wrong("phrases", span.start_s, f"{span.label}: {message}")
        return None
    unknown_attributes(span, checking)
    return GesturePhrase(
        interval=_interval(span),
        lexeme=lexeme_of(span, checking),
        hand=hand_of(span, checking),
        phases=own,
        path=path_of(span, checking),
        start=position_of(span, "from", checking),
        end=position_of(span, "to", checking),
        affiliate=affiliate_of(span, checking),
        tag=tag_of(span, checking),
    )


def _contradiction(phases: Sequence[Phase]) -> str | None:
    """The mistake in the phases of a phrase, if any."""
    kinds = [phase.kind for phase in phases]
    if PhaseKind.PREPARATION in kinds[1:]:
        return "a preparation is the first phase of its phrase"
    holds = kinds.count(PhaseKind.INDEPENDENT_HOLD)
    if PhaseKind.STROKE not in kinds and not holds:
        return "it has neither a stroke nor an independent hold"
    if holds and (PhaseKind.STROKE in kinds or holds > 1):
        return "an independent hold takes the place of all strokes"
    return None


def _unit(whole: TrackSpan, phrases: InTime[GesturePhrase], retractions: InTime[Phase], checking: Checking) -> Unit:
    own = _within(phrases, whole)
    if not own:
        checking.wrong("units", whole.start_s, "no gesture lies in this unit")
    back = [each.interval for each in _within(retractions, whole)]
    if len(back) > 1:
        checking.wrong("units", whole.start_s, f"{len(back)} retractions; a unit ends in one")
    elif back and own and back[0].start_s < own[-1].main_s.end_s - TOUCHING_S:
        checking.wrong("units", whole.start_s, "the retraction comes before the last stroke ends")
    return Unit(_interval(whole), own, back[0] if back else None, rest_of(whole, checking))


def _interval(span: TrackSpan) -> Interval:
    return Interval(span.start_s, span.end_s)


LARGEST_BYTES = 64 << 20

READERS: Mapping[str, Callable[[bytes, Path], tuple[Track, ...]]] = {
    ".anvil": read_anvil,
    ".eaf": read_elan,
    ".textgrid": read_textgrid,
    ".csv": read_csv,
    ".json": read_json,
}


def read_annotations(
    paths: Iterable[Path], lexemes: Collection[str] | None = None, tags: Collection[str] | None = None
) -> tuple[Annotation, ...]:
    """The annotations in files, in the formats given by their endings; `lexemes` are the playable lexemes, `tags` the
    existing tags (None: any).

    Raises UnsupportedFormatError, and AnnotationError with every mistake of all files.
    """
    made: list[Annotation] = []
    mistakes: list[AnnotationMistake] = []
    for path in paths:
        try:
            made.append(annotation_of(read_tracks(path), path, lexemes, tags))
        except AnnotationError as error:
            mistakes += error.mistakes
    if mistakes:
        raise AnnotationError(mistakes)
    return tuple(made)


def read_tracks(path: Path) -> tuple[Track, ...]:
    """The tracks of a file; raises as `read_annotations` does."""
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        message = f"{path}: annotations are read from {', '.join(READERS)}"
        raise UnsupportedFormatError("annotation_format", message, field="annotation")
    try:
        if path.stat().st_size > LARGEST_BYTES:
            raise AnnotationError([AnnotationMistake(path, f"larger than the {LARGEST_BYTES >> 20} MB allowed")])
        content = path.read_bytes()
    except OSError as error:
        raise AnnotationError([AnnotationMistake(path, f"cannot be read: {error.strerror}")]) from None
    return reader(content, path)


def annotation_of(
    tracks: Iterable[Track], path: Path, lexemes: Collection[str] | None = None, tags: Collection[str] | None = None
) -> Annotation:
    """The annotation made of tracks; raises AnnotationError with every mistake."""
    tracks = tuple(tracks)
    by_name = {track.name: track for track in with_attributes(tracks)}
    checking = Checking(path, lexemes, tags)
    for track, span in stray_attributes(tracks):
        checking.wrong(track.name, span.start_s, f"{span.label!r} labels nothing: there is no span")
    made = _whole(by_name, checking) if _has_all(by_name, checking) else None
    if made is None or checking.mistakes:
        raise AnnotationError(sorted(checking.mistakes, key=lambda each: (each.time_s or 0.0, each.track)))
    return made


def _has_all(tracks: Mapping[str, Track], checking: Checking) -> bool:
    """Whether no track is missing; otherwise only the times of the others are checked, not their nesting."""
    missing = [name for name in NEEDED if name not in tracks]
    for name in missing:
        checking.wrong(name, None, f"the track is missing{did_you_mean(name, tracks.keys() - KNOWN)}")
    for name, track in tracks.items() if missing else ():
        if name in KNOWN:
            deque(checked_times(track, checking, overlapping=name == "tags"), maxlen=0)
    return not missing


def _whole(tracks: Mapping[str, Track], checking: Checking) -> Annotation:
    """The annotation; its mistakes are recorded."""
    found = {name: tracks.get(name, Track(name, ())) for name in KNOWN}
    words = words_of(found["words"], checking)
    checking.words, checking.places = words_in_time(words), places_of(words)
    return Annotation(
        path=checking.path,
        duration_s=max((span.end_s for track in tracks.values() for span in track.spans), default=0.0),
        words=words,
        segments=tuple(_segments(found["segments"], checking)) or segments_of(words),
        tags=tuple(tags_of(found["tags"], checking)) if "tags" in tracks else None,
        units=units_of(found["phases"], found["phrases"], found["units"], checking),
        head=labelled_of(found["head"], checking),
        gaze=labelled_of(found["gaze"], checking),
        posture=labelled_of(found["posture"], checking),
        unread=tuple(sorted(tracks.keys() - KNOWN)),
    )


def _segments(track: Track, checking: Checking) -> Iterator[tuple[int, int]]:
    for span in checked_times(track, checking):
        words = checking.words_in(span.start_s, span.end_s)
        if words is not None:
            yield words

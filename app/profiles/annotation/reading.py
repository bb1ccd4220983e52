"""Annotations from files of any format that we know, checked: all mistakes of all files at once."""

from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from pathlib import Path

from ...errors import UnsupportedFormatError, did_you_mean
from ..segments import segments_of
from .anvil import read_anvil
from .elan import read_elan
from .hierarchy import units_of
from .mistakes import AnnotationError, AnnotationMistake
from .model import Annotation
from .spans import Checking, checked_times, labelled_of, places_of, tags_of, words_in_time, words_of
from .tables import read_csv, read_json
from .textgrid import read_textgrid
from .tracks import KNOWN, NEEDED, Track, stray_attributes, with_attributes

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
    """The annotations in files, by what their names end in; `lexemes` are those that can be played, `tags` those that
    there are (None: any).

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
    """The annotation that tracks make; raises AnnotationError with every mistake."""
    tracks = tuple(tracks)
    by_name = {track.name: track for track in with_attributes(tracks)}
    checking = Checking(path, lexemes, tags)
    for track, span in stray_attributes(tracks):
        checking.wrong(track.name, span.start_s, f"{span.label!r} is said of nothing: no span is there")
    made = _whole(by_name, checking) if _has_all(by_name, checking) else None
    if made is None or checking.mistakes:
        raise AnnotationError(sorted(checking.mistakes, key=lambda each: (each.time_s or 0.0, each.track)))
    return made


def _has_all(tracks: Mapping[str, Track], checking: Checking) -> bool:
    """Whether no track is missing; where one is, the times of the others are checked, not how they lie in it."""
    missing = [name for name in NEEDED if name not in tracks]
    for name in missing:
        checking.wrong(name, None, f"the track is missing{did_you_mean(name, tracks.keys() - KNOWN)}")
    for name, track in tracks.items() if missing else ():
        if name in KNOWN:
            deque(checked_times(track, checking, overlapping=name == "tags"), maxlen=0)
    return not missing


def _whole(tracks: Mapping[str, Track], checking: Checking) -> Annotation:
    """The annotation, its mistakes noted."""
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

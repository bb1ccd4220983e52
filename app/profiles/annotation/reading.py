"""Annotations from files of any format that we know, checked: all mistakes of all files at once."""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from pathlib import Path

from ...errors import UnsupportedFormatError
from ...yaml_files import did_you_mean
from ..segments import segments_of
from .anvil import read_anvil
from .elan import read_elan
from .hierarchy import units_of
from .mistakes import AnnotationError, AnnotationMistake
from .model import Annotation
from .spans import Checking, checked_times, labelled_of, tags_of, words_of
from .tables import read_csv, read_json
from .textgrid import read_textgrid
from .tracks import KNOWN, Track, with_attributes

LARGEST_BYTES = 64 << 20

READERS: Mapping[str, Callable[[bytes, Path], tuple[Track, ...]]] = {
    ".anvil": read_anvil,
    ".eaf": read_elan,
    ".textgrid": read_textgrid,
    ".csv": read_csv,
    ".json": read_json,
}


def read_annotations(paths: Iterable[Path], lexemes: Collection[str] | None = None) -> tuple[Annotation, ...]:
    """The annotations in files, by what their names end in; `lexemes` are those that can be played (None: any).

    Raises UnsupportedFormatError, and AnnotationError with every mistake of all files.
    """
    made: list[Annotation] = []
    mistakes: list[AnnotationMistake] = []
    for path in paths:
        try:
            made.append(annotation_of(read_tracks(path), path, lexemes))
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


def annotation_of(tracks: Iterable[Track], path: Path, lexemes: Collection[str] | None = None) -> Annotation:
    """The annotation that tracks make; raises AnnotationError with every mistake."""
    by_name = {track.name: track for track in with_attributes(tracks)}
    checking = Checking(path, lexemes)
    _check_names(by_name, checking)
    empty = {name: by_name.get(name, Track(name, ())) for name in KNOWN}
    checking.words = words_of(empty["words"], checking)
    made = Annotation(
        path=path,
        duration_s=max((span.end_s for track in by_name.values() for span in track.spans), default=0.0),
        words=checking.words,
        segments=tuple(_segments(empty["segments"], checking)) or segments_of(checking.words),
        tags=tuple(tags_of(by_name["tags"], checking)) if "tags" in by_name else None,
        units=units_of(empty["phases"], empty["phrases"], empty["units"], checking),
        head=labelled_of(empty["head"], checking),
        gaze=labelled_of(empty["gaze"], checking),
        posture=labelled_of(empty["posture"], checking),
    )
    if checking.mistakes:
        raise AnnotationError(sorted(checking.mistakes, key=lambda each: (each.time_s or 0.0, each.track)))
    return made


def _check_names(tracks: Mapping[str, Track], checking: Checking) -> None:
    for name in ("words", "phases", "phrases", "units"):
        if name not in tracks:
            close = did_you_mean(name, tracks.keys() - KNOWN)
            checking.wrong(name, None, f"the track is missing{close}")


def _segments(track: Track, checking: Checking) -> Iterator[tuple[int, int]]:
    for span in checked_times(track, checking):
        words = checking.words_in(span.start_s, span.end_s)
        if words is not None:
            yield words

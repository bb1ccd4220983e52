"""Reads Praat's TextGrid: each tier of intervals is a track; intervals without a label are nothing."""

import re
from collections.abc import Iterator
from pathlib import Path

from .mistakes import AnnotationError, AnnotationMistake
from .tracks import Span, Track, track_of

_NEGATIVE_TIME = re.compile(r"x(?:min|max)\s*=\s*-[\d.]*[1-9]")


def read_textgrid(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tiers of a file; raises AnnotationError for what is no TextGrid."""
    from praatio.utilities import textgrid_io  # type: ignore[import-untyped]
    from praatio.utilities.errors import PraatioException  # type: ignore[import-untyped]

    try:
        text = content.decode("utf-16" if content[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig")
        if _NEGATIVE_TIME.search(text):  # praatio would drop the sign
            raise ValueError("it has a time below 0")
        tiers = textgrid_io.parseTextgridStr(text, includeEmptyIntervals=False)["tiers"]
        intervals = [tier for tier in tiers if tier["class"] == "IntervalTier"]
        return tuple(track_of(tier["name"], _spans(tier["entries"])) for tier in intervals)
    except (PraatioException, ValueError, IndexError, KeyError, TypeError) as error:
        told = " ".join(str(error).split()) or "its layout is not Praat's"
        raise AnnotationError([AnnotationMistake(path, f"not a TextGrid that can be read: {told}")]) from None


def _spans(entries: list[tuple[str, str, str]]) -> Iterator[Span]:
    for start_s, end_s, label in entries:
        yield Span(float(start_s), float(end_s), label.strip())

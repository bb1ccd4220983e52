"""Exports events for annotation tools: Praat's TextGrid and ELAN's .eaf, on the clock of the recording.

Tiers: the words, the functions, every channel of movement, and beside each its reasons (`gesture.function`,
`gesture.rule`, …). Events that overlap are split into several tiers, `face`, `face_2`. The tools have no times before
the recording, so what begins in a lead-in is cut there.
"""

from collections.abc import Sequence

from ..profiles.annotation.elan import write_elan
from ..profiles.annotation.tracks import Span, Track, rows_of


def to_textgrid(tracks: Sequence[Track], duration_s: float) -> bytes:
    """The TextGrid (long format), as long as the recording or its last event."""
    from praatio.utilities import textgrid_io  # type: ignore[import-untyped]

    rows = [row for track in tracks for row in rows_of(track) if track.spans]
    end_s = max([duration_s, *(span.end_s for row in rows for span in row.spans)])
    grid = {"xmin": 0, "xmax": end_s, "tiers": [_tier(row, end_s) for row in rows]}
    return str(textgrid_io.getTextgridAsStr(grid, "long_textgrid", includeBlankSpaces=True)).encode()


def to_elan(tracks: Sequence[Track], media: str = "") -> bytes:
    """The .eaf; `media` is the recording's file."""
    return write_elan([row for track in tracks if track.spans for row in rows_of(track)], media=media)


def _tier(row: Track, end_s: float) -> dict[str, object]:
    entries = [(span.start_s, span.end_s, span.label) for span in _apart(row.spans)]
    return {"class": "IntervalTier", "name": row.name, "xmin": 0, "xmax": end_s, "entries": entries}


def _apart(spans: Sequence[Span]) -> list[Span]:
    """The spans with a duration: Praat has no intervals of length 0."""
    return [span for span in spans if span.end_s > span.start_s]

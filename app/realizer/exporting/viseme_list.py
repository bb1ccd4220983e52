"""Exports the visemes as a timed list, as lip-sync tools exchange them.

Conventions: each line is a time in seconds of the audio, a tab and a viseme that lasts until the next line (the format
of Rhubarb Lip Sync); the last line is `sil`, as are gaps between visemes.
"""

from collections.abc import Iterator, Sequence

from ...model import Viseme

SILENCE = "sil"


def to_viseme_text(visemes: Sequence[Viseme], duration_s: float) -> bytes:
    """The list as text; `duration_s` is the audio's duration."""
    return "".join(f"{start_s:.3f}\t{label}\n" for start_s, label in _changes(visemes, duration_s)).encode()


def _changes(visemes: Sequence[Viseme], duration_s: float) -> Iterator[tuple[float, str]]:
    """The start time of each viseme, with silences in the gaps."""
    shown, until_s = None, 0.0
    for each in visemes:
        if each.interval.start_s > until_s + 5e-4 and shown != SILENCE:
            yield until_s, SILENCE
            shown = SILENCE
        if each.label != shown:
            yield each.interval.start_s, each.label
        shown, until_s = each.label, each.interval.end_s
    if shown != SILENCE:
        yield until_s, SILENCE
    if duration_s > until_s:
        yield duration_s, SILENCE

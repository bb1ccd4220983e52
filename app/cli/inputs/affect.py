"""Reads `--affect`: a tone, three numbers, or a track in a CSV file."""

from ...model import AffectTrack
from ...schemas.affect import read_affect, read_affect_track
from ..files import read_bytes

LARGEST_TRACK_BYTES = 8 << 20


def optional_affect(told: str | None) -> AffectTrack | None:
    """The feeling that is given; None where the option is missing.

    Raises InputError `affect_wrong`, and as `read_bytes` does.
    """
    if told is None:
        return None
    if not told.lower().endswith(".csv"):
        return read_affect(told)
    return read_affect_track(read_bytes(told, limit=LARGEST_TRACK_BYTES, field="affect"), told)

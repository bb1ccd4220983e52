"""Computes all frame-wise measurements of a signal."""

from ..model import Audio, Contours
from .pitch.pitch import track_f0
from .signal.spectrum import energy_db, mel_db, mfcc


def contours_of(audio: Audio) -> Contours:
    """The contours of `audio` (paper §3.1.1 to §3.1.3)."""
    f0_hz = track_f0(audio)  # first, since it needs the most memory
    levels_db = mel_db(audio)
    return Contours(energy_db=energy_db(audio), f0_hz=f0_hz, mfcc=mfcc(levels_db), mel_db=levels_db)

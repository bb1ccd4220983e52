"""A stretch of a recording with what is measured in it, of which shorter stretches can be taken."""

from dataclasses import dataclass, fields

from ...model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Audio, Contours, FloatArray, Interval, VoiceQuality
from ..agitation.utterance_features import full_features

FEWEST_FRAMES = 30
"""What is shorter is not described."""


@dataclass(frozen=True, slots=True, eq=False)
class Stretch:
    """Sound with its contours and voice quality, frame by frame."""

    audio: Audio
    contours: Contours
    quality: VoiceQuality

    @property
    def duration_s(self) -> float:
        return self.audio.duration_s

    def between(self, interval: Interval) -> "Stretch | None":
        """The part in an interval; None if it is too short to be described."""
        first, last = (round(time_s / FRAME_SHIFT_S) for time_s in (interval.start_s, interval.end_s))
        frames = slice(max(first, 0), last)
        if len(self.contours.energy_db[frames]) < FEWEST_FRAMES:
            return None
        start, end = (round(time_s * SAMPLE_RATE_HZ) for time_s in (interval.start_s, interval.end_s))
        return Stretch(
            Audio(self.audio.samples[max(start, 0) : end]),
            Contours(**{each.name: getattr(self.contours, each.name)[frames] for each in fields(Contours)}),
            VoiceQuality(**{each.name: getattr(self.quality, each.name)[frames] for each in fields(VoiceQuality)}),
        )

    def features(self) -> FloatArray:
        """The features of affect, NaN where unknown."""
        return full_features(self.contours, self.quality)

"""What is measured of a signal for the features of agitation and affect."""

from dataclasses import replace

from understudy.acoustic.affect.line_affect import Stretch
from understudy.acoustic.agitation.voice_quality import voice_quality
from understudy.acoustic.stage import contours_of
from understudy.model import Audio, Contours, FloatArray, VoiceQuality


def measured(audio: Audio, f0_hz: FloatArray | None = None) -> tuple[Contours, VoiceQuality]:
    """The contours and the voice quality, with another f0 if one is given."""
    contours = contours_of(audio)
    contours = contours if f0_hz is None else replace(contours, f0_hz=f0_hz)
    return contours, voice_quality(audio, contours.f0_hz)


def stretch_of(audio: Audio) -> Stretch:
    """The whole signal as one stretch."""
    return Stretch(audio, *measured(audio))

"""A gesture's clip in the manner of the voice: faster or slower, and more or less tense.

Speed shortens or lengthens the stroke and what goes before and after it alike; tension makes the stroke stop sharply
(power) and its path through the keys less smooth (Gesture Engine §5.2). How big it is made is the request's size.
"""

from dataclasses import replace

from ...model import Manner
from .gesture import Clip, Expressivity, Markers


def mannered(clip: Clip, manner: Manner) -> Clip:
    """The clip in a manner, its amplitude apart."""
    if manner.speed == 1 and manner.tension == 1:
        return clip
    pace = 1 / manner.speed
    return replace(
        clip,
        markers=Markers(*(pace * getattr(clip.markers, name) for name in Markers.__slots__)),
        keys=tuple(replace(key, time_s=pace * key.time_s) for key in clip.keys),
        expressivity=_tensed(clip.expressivity, manner.tension - 1),
        stroke_speed_m_s=clip.stroke_speed_m_s * manner.speed,
    )


def _tensed(expressivity: Expressivity, more: float) -> Expressivity:
    """With more power and less fluidity, both within their bounds."""
    return replace(
        expressivity,
        power=min(max(expressivity.power + 0.5 * more, 0.0), 1.0),
        fluidity=min(max(expressivity.fluidity - 0.3 * more, 0.0), 1.0),
    )

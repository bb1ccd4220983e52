"""The gesture library as the BML scheduler needs it: how long strokes take and where hands are before and after them.

A behaviour has all the clips that `selection` may draw for it, whatever the seed.
"""

from collections.abc import Iterable, Iterator
from itertools import product
from types import MappingProxyType

from ...model import FloatArray, Hand, Level
from ...model.limits import ArmEnds, Forms, GestureForm, GestureTable, Offset
from ..arms.wrist_paths import relax_m, stroke_end_m, stroke_start_m
from ..gestures.gesture import Clip, Depth, HeightSector, SectorPlace, Sideways
from ..gestures.gesture_plan import GestureRequest
from ..gestures.gesture_space import sector_m
from ..head_and_gaze.gaze_targets import with_target
from .selection import Clips, clips_of, place_clip

_MIDDLE_M = sector_m(SectorPlace(Sideways.C, HeightSector.CC, Depth.MIDDLE))


def gesture_table(library: Clips, lexemes: Iterable[str]) -> GestureTable:
    """The forms of gestures with these lexemes."""
    return GestureTable(MappingProxyType(dict(_forms(library, sorted(set(lexemes))))))


def _forms(library: Clips, lexemes: list[str]) -> Iterator[tuple[tuple[str, Level, Hand], Forms]]:
    for lexeme, level, hand in product(lexemes, Level, Hand):
        request = GestureRequest("", lexeme, 0.0, 0.0, 0.0, hand, level)
        forms = tuple(_form(clip, request) for clip in clips_of(request, library))
        if forms:
            yield (lexeme, level, hand), forms


def _form(clip: Clip, request: GestureRequest) -> GestureForm:
    placed = with_target(place_clip(clip, request), MappingProxyType({}))
    places_of = (stroke_start_m, stroke_end_m, relax_m)
    ends = {arm: ArmEnds(*(_offset(place_m(placed, arm), placed.size) for place_m in places_of)) for arm in placed.arms}
    markers = clip.markers
    before_s, after_s = markers.stroke - markers.stroke_start, markers.stroke_end - markers.stroke
    return GestureForm(before_s, after_s, clip.stroke_speed_m_s, MappingProxyType(ends))


def _offset(wrist_m: FloatArray, size: float) -> Offset:
    """The wrist's offset from the middle, if the gesture had size 1."""
    x_m, y_m, z_m = (wrist_m - _MIDDLE_M) / size
    return float(x_m), float(y_m), float(z_m)

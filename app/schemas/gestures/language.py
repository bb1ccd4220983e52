"""The vocabulary of the gesture language and its valid combinations, for tools that offer nothing else (Gesture Engine
§4.3): for each direction of the fingers the palms at a right angle to it, for each hand form the thumbs it permits."""

from collections.abc import Iterable, Mapping
from itertools import product
from typing import Self

import numpy as np

from ...model import Hand, Level
from ...realizer.arms.plausibility import SHORT_M
from ...realizer.arms.posing import pose_arms
from ...realizer.body.skeleton import Skeleton, arm_joints
from ...realizer.gestures.checking import IN_ORDER, REPEATED
from ...realizer.gestures.definitions import FACTORS, MAX_DURATION_S, MIN_DURATION_S, RANGES, SUMMANDS
from ...realizer.gestures.gesture import (
    ArmKey,
    Bend,
    Depth,
    Finger,
    HandDirection,
    HandForm,
    HeightSector,
    SectorPlace,
    Sideways,
    Thumb,
    TrackForm,
)
from ...realizer.gestures.gesture_space import DEPTH_M, DIRECTIONS, HEIGHT, SHOULDERS_ABOVE_HIPS_M, SIDEWAYS_M, sector_m
from ...realizer.gestures.specifiers import (
    FEWEST_TURNS,
    MAX_DEGREES,
    MAX_OFFSET_M,
    MOST_DEGREES,
    MOST_PHASE_DEG,
    MOST_TURNS,
    THUMB_IN_FORM,
    TrackJoint,
    orthogonal,
)
from ..response_model import Number, ResponseModel

_AXES = (
    (HandDirection.UP, HandDirection.DOWN),
    (HandDirection.INWARDS, HandDirection.OUTWARDS),
    (HandDirection.AWAY, HandDirection.TOWARDS),
)


class SectorResponse(ResponseModel):
    """A sector of one axis, and its position: outwards from the middle, up from the hips or away from them."""

    name: str
    place_m: Number


class FormResponse(ResponseModel):
    """A hand form, and the thumb positions it permits."""

    name: HandForm
    thumbs: list[Thumb]


class OrientationResponse(ResponseModel):
    """A sum of directions; `partners` are the indices of those at a right angle to it."""

    directions: list[HandDirection]
    vector: tuple[Number, Number, Number]
    partners: list[int]


class FrameTypeResponse(ResponseModel):
    """A frame type; frames come in the order of this list, and types with `once` at most once."""

    name: str
    once: bool


class DerivationResponse(ResponseModel):
    """The default expressivity of a level: medium's amplitude and tempo times the factors, fluidity, power and
    repetition plus the summands."""

    factors: tuple[Number, Number]
    summands: tuple[Number, Number, Number]


class GestureLanguageResponse(ResponseModel):
    """The whole vocabulary, and what can be combined."""

    x: list[SectorResponse]
    y: list[SectorResponse]
    z: list[SectorResponse]
    out_of_reach: list[tuple[str, str, str]]
    forms: list[FormResponse]
    fingers: list[Finger]
    bends: list[Bend]
    orientations: list[OrientationResponse]
    frame_types: list[FrameTypeResponse]
    arms: list[Hand]
    joints: list[str]
    track_forms: list[TrackForm]
    track_joints: list[TrackJoint]
    levels: dict[Level, DerivationResponse]
    ranges: dict[str, tuple[Number, Number]]

    @classmethod
    def of(cls, skeleton: Skeleton) -> Self:
        """The language, and the sectors that an arm of this body does not reach."""
        heights_m = {str(name): share * SHOULDERS_ABOVE_HIPS_M for name, share in HEIGHT.items()}
        return cls(
            x=_sectors({str(name): place_m for name, place_m in SIDEWAYS_M.items()}),
            y=_sectors(heights_m),
            z=_sectors({str(name): place_m for name, place_m in DEPTH_M.items()}),
            out_of_reach=out_of_reach(skeleton),
            forms=[FormResponse(name=form, thumbs=_thumbs(form)) for form in HandForm],
            fingers=list(Finger),
            bends=list(Bend),
            orientations=_orientations(),
            frame_types=[FrameTypeResponse(name=type_, once=type_ not in REPEATED) for type_ in IN_ORDER],
            arms=list(Hand),
            joints=[name.removeprefix(Hand.LEFT) for name in arm_joints(Hand.LEFT)],
            track_forms=list(TrackForm),
            track_joints=list(TrackJoint),
            levels={level: DerivationResponse(factors=FACTORS[level], summands=SUMMANDS[level]) for level in Level},
            ranges={
                **RANGES,
                "duration_s": (MIN_DURATION_S, MAX_DURATION_S),
                "time": (0.0, 1.0),
                "offset_m": (-MAX_OFFSET_M, MAX_OFFSET_M),
                "degrees": (-MAX_DEGREES, MAX_DEGREES),
                "shoulder": (-1.0, 1.0),
                "curve": (-1.0, 1.0),
                "track_degrees": (-MOST_DEGREES, MOST_DEGREES),
                "track_turns": (FEWEST_TURNS, MOST_TURNS),
                "track_phase_deg": (-MOST_PHASE_DEG, MOST_PHASE_DEG),
            },
        )


def out_of_reach(skeleton: Skeleton) -> list[tuple[str, str, str]]:
    """The sectors whose centre the wrist misses by more than the checker tolerates."""
    places = [SectorPlace(x, y, z) for x, y, z in product(Sideways, HeightSector, Depth)]
    poses = pose_arms(skeleton, Hand.LEFT, [ArmKey(place=place) for place in places])
    return [
        (place.sideways, place.height, place.depth)
        for place, pose in zip(places, poses, strict=True)
        if pose.wrist_m is None or np.linalg.norm(pose.wrist_m - sector_m(place)) > SHORT_M
    ]


def _sectors(places_m: Mapping[str, float]) -> list[SectorResponse]:
    return [SectorResponse(name=name, place_m=place_m) for name, place_m in places_m.items()]


def _thumbs(form: HandForm) -> list[Thumb]:
    return [Thumb.DEFAULT] if form in THUMB_IN_FORM else list(Thumb)


def _orientations() -> list[OrientationResponse]:
    """All sums of at most one direction of each axis; the first, in line with the forearm, goes with all others."""
    sums = [[one for one in parts if one] for parts in product(*((None, *axis) for axis in _AXES))]
    return [
        OrientationResponse(
            directions=one,
            vector=_vector(one),
            partners=[number for number, other in enumerate(sums) if orthogonal(one, other)],
        )
        for one in sums
    ]


def _vector(directions: Iterable[HandDirection]) -> tuple[float, float, float]:
    x, y, z = (sum(DIRECTIONS[one][axis] for one in directions) for axis in range(3))
    return float(x), float(y), float(z)

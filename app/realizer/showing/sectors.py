"""Plays the places of a gesture script (NGS §3.3, §3.4): the wrist is in one sector of gesture space where the stroke
begins, and in another where it ends and is held.

The keys of the clip are moved: those before the stroke as its beginning, those from its end on as its end, those
between by their share of the stroke, so that what the library has between the two stays. A place is meant as it is,
whatever the gesture's size. What is further away than the arm is long, a stroke that would be too fast, and an elbow
that is elsewhere than its swivel, for wrist and joints do not allow it there, are told.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ...model import FloatArray, Hand
from ...model.schedule import Way
from ..arms.posing import elbow_swivel_deg
from ..arms.wrist_paths import amplitude
from ..body.skeleton import Skeleton
from ..gestures.gesture import ArmKey, Clip, Depth, HeightSector, SectorPlace, Sideways
from ..gestures.gesture_plan import PlacedGesture
from ..gestures.gesture_space import SHOULDERS_ABOVE_HIPS_M, offset_from_centre_m, sector_m
from ..gestures.specifiers import track_of
from .measures import begun_in_time

ARM_M = 0.53
"""From the shoulder to the wrist of the default body."""

_SHOULDER_M: FloatArray = np.array([0.17, SHOULDERS_ABOVE_HIPS_M, 0.0])
_SHOULDER_M.setflags(write=False)
_CENTRE = SectorPlace(Sideways.C, HeightSector.CC, Depth.MIDDLE)


def led(placed: PlacedGesture) -> PlacedGesture:
    """The gesture with its stroke from and to the sectors of its request, and with the tracks that are added to its
    own; not led where it points at a target, and where the arm is given by joint angles."""
    way = placed.request.way
    if way is None:
        return placed
    if way.tracks:
        tracks = (*placed.clip.tracks, *map(track_of, way.tracks))
        placed = replace(placed, clip=replace(placed.clip, tracks=tracks))
    if way.start is way.end is None or placed.aim_m is not None or not _is_placed(placed.clip):
        return placed
    clip = placed.clip
    for side in placed.arms:
        clip = _with_arm(clip, side, way, amplitude(placed))
    ends_m = {} if way.end is None else dict.fromkeys(placed.arms, sector_m(_place(way.end)))
    return replace(placed, clip=begun_in_time(clip, ends_m, amplitude(placed)))


def led_decisions(asked: Way | None, placed: PlacedGesture) -> Iterator[str]:
    """What of the places asked for a gesture does not show, in words."""
    if asked is None or asked.start is asked.end is None:
        return
    if placed.aim_m is not None or not _is_placed(placed.clip):
        why = "it points at a target" if placed.aim_m is not None else "its arm is given by joint angles"
        yield f"its sectors are ignored: {why}"
        return
    for name, sector in (("from", asked.start), ("to", asked.end)):
        if sector is not None:
            short_m = float(np.linalg.norm(sector_m(_place(sector)) - _SHOULDER_M)) - ARM_M
            if short_m > 0:
                yield f"{name} {' '.join(sector)} is {100 * short_m:.0f} cm out of reach"
    off_m = _starts_m(placed)
    if asked.start is not None and off_m > _NEAR_M:
        where = " ".join(asked.start)
        yield f"its stroke begins {100 * off_m:.0f} cm from {where}, to be no faster than hands are"
    yield from _swivels_missed(asked, placed)


def _swivels_missed(asked: Way, placed: PlacedGesture) -> Iterator[str]:
    """Where the elbow is at an end of the stroke, if it is not where it is asked for."""
    clip = placed.clip
    ends = (
        ("from", asked.start, asked.start_elbow_deg, clip.markers.stroke_start),
        ("to", asked.end, asked.end_elbow_deg, clip.markers.stroke_end),
    )
    for name, sector, wanted_deg, time_s in ends:
        if sector is None or wanted_deg is None:
            continue
        for side in placed.arms:
            arm = _key_at(clip, side, time_s)
            if arm is None or arm.place is None:
                continue
            found_deg = elbow_swivel_deg(Skeleton.standing(), arm, amplitude=amplitude(placed), manner=clip.manner)
            if abs(found_deg - wanted_deg) > _SWIVEL_NEAR_DEG:
                told = f"{name} {' '.join(sector)}: the {side} elbow is {found_deg:.0f}° out"
                yield f"{told}, not {wanted_deg:.0f}°, as far as wrist and joints allow"


def _key_at(clip: Clip, side: Hand, time_s: float) -> ArmKey | None:
    return next((key.left if side is Hand.LEFT else key.right for key in clip.keys if key.time_s == time_s), None)


_SWIVEL_NEAR_DEG = 10.0
"""Nearer than that, a swivel is as it is asked for."""

_NEAR_M = 0.03


def _starts_m(placed: PlacedGesture) -> float:
    """How far from its sector the stroke begins."""
    way = placed.request.way
    start = _at(placed.clip, placed.arms[0], placed.clip.markers.stroke_start)
    if way is None or way.start is None or start is None:
        return 0.0
    return float(np.linalg.norm(sector_m(start, amplitude(placed)) - sector_m(_place(way.start))))


def _is_placed(clip: Clip) -> bool:
    """Whether every arm that takes part has a place somewhere, and no joints of the arm that override it."""
    arms = [arm for key in clip.keys for arm in (key.left, key.right) if arm is not None]
    return any(arm.place for arm in arms) and not any(
        name in ("UpperArm", "LowerArm") for arm in arms for name, _degrees in arm.joints
    )


def _with_arm(clip: Clip, side: Hand, way: Way, size: float) -> Clip:
    """The clip with the keys of one arm moved."""
    edges = ((clip.markers.stroke_start, way.start), (clip.markers.stroke_end, way.end))
    start_m, end_m = (_difference_m(_at(clip, side, time_s), sector, size) for time_s, sector in edges)
    keys = []
    for key in clip.keys:
        arm = key.left if side is Hand.LEFT else key.right
        if arm is None or not clip.markers.start < key.time_s < clip.markers.end:
            keys.append(key)
            continue
        is_edge = any(key.time_s == time_s for time_s, _sector in edges)
        place = _at(clip, side, key.time_s) if is_edge else arm.place
        share = _share(clip, key.time_s)
        moved = replace(_moved(arm, place, _between(start_m, end_m, share), size), elbow_deg=_elbow_deg(way, share))
        keys.append(replace(key, left=moved) if side is Hand.LEFT else replace(key, right=moved))
    return replace(clip, keys=tuple(keys))


def _share(clip: Clip, time_s: float) -> float:
    """How much of the stroke is over."""
    begin_s, end_s = clip.markers.stroke_start, clip.markers.stroke_end
    return min(max((time_s - begin_s) / max(end_s - begin_s, 1e-6), 0.0), 1.0)


def _between(start_m: FloatArray | None, end_m: FloatArray | None, share: float) -> FloatArray:
    """The way by which a key is moved; what is not asked for stays."""
    zero = np.zeros(3)
    begun, ended = (zero if each is None else each for each in (start_m, end_m))
    return np.asarray((1 - share) * begun + share * ended)


def _elbow_deg(way: Way, share: float) -> float | None:
    """Where the elbow is at a share of the stroke; an end that leaves it to the wrist counts as in line with the
    shoulder."""
    if way.start_elbow_deg is way.end_elbow_deg is None:
        return None
    return (1 - share) * (way.start_elbow_deg or 0.0) + share * (way.end_elbow_deg or 0.0)


def _at(clip: Clip, side: Hand, time_s: float) -> SectorPlace | None:
    """The place of an arm that holds at a time: the last one said, else the first."""
    said = [
        (key.time_s, arm.place)
        for key in clip.keys
        if (arm := key.left if side is Hand.LEFT else key.right) is not None and arm.place is not None
    ]
    before = [place for said_s, place in said if said_s <= time_s]
    return before[-1] if before else said[0][1] if said else None


def _difference_m(place: SectorPlace | None, sector: tuple[str, str, str] | None, size: float) -> FloatArray | None:
    if place is None or sector is None:
        return None
    return np.asarray(sector_m(_place(sector)) - sector_m(place, size))


def _moved(arm: ArmKey, place: SectorPlace | None, way_m: FloatArray, size: float) -> ArmKey:
    if place is None:
        return arm
    offset_m = offset_from_centre_m(sector_m(place, size) + way_m, size)
    return replace(arm, place=replace(_CENTRE, offset_m=offset_m))


def _place(sector: tuple[str, str, str]) -> SectorPlace:
    return SectorPlace(Sideways(sector[0]), HeightSector(sector[1]), Depth(sector[2]))

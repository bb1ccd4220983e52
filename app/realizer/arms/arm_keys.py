"""Turns the gestures and rests of a plan into the key poses of one arm's track (Gesture Engine §5.1, §5.2).

A clip's keys are mapped to absolute time by their phases: preparation and retraction may be longer or shorter than in
the clip, the stroke never is. A hold has the same pose at both ends, with noise between them (paper §3.8); a repeated
stroke moves back by its amplitude and forth again. Expressivity shapes the spline at the keys: fluidity makes it flow
through them, power makes it stop abruptly and overshoot (Hartmann, Mancini & Pelachaud 2005); tension, continuity and
bias that a frame sets itself take the place of that.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, reduce

import numpy as np

from ...model import FloatArray, Hand
from ...model.figure import GestureManner
from ..body.skeleton import Skeleton
from ..geometry.rotations import from_axis_angle, multiply, slerp, turn_about_z
from ..gestures.gesture import ArmKey, ClipKey, Expressivity, FrameType, KeyCurve
from ..gestures.gesture_plan import ArmGesture, ArmRest, GesturePlan, Position, Repeat
from .interpolation import ArmTrack, TimedPose
from .posing import HAND_ROWS, PartialPose, pose_arms
from .rest_poses import BEHIND_BACK, LIFTED, rest_pose
from .shoulder_ways import within_the_shoulder
from .wrist_paths import amplitude, arm_key

REST_NOISE, HOLD_NOISE, ADDED_NOISE, STROKE_NOISE = 0.6, 1.0, 0.5, 0.1

_SHORTEST_KEY_S = 0.02
"""Keys closer together than this are merged: they add no information and would distort the curve between them."""
_UNSAID = KeyCurve()
_BACK = 0.5
"""The share of a repetition that the backward movement takes."""
FINGER_ROWS = 12
"""The last rows of a pose: four fingers of three joints."""
_HALF, _DECAYED = 0.45, 0.56
"""Where in the time of a way to rest its middle is, and how much of the way is behind it."""
_SHORTEST_ARC_S = 0.3
_USUAL_SHARE, _MOST_SHARE = 0.35, 0.6
"""Of the way to hanging that a repetition goes back: where the length of the way is unknown, and at most."""


def arm_track(skeleton: Skeleton, side: Hand, plan: GesturePlan) -> ArmTrack:
    """The keys of one arm from the first frame to the end of the plan."""
    gestures, rests = plan.of_arm(side)
    keys = [key for rest in rests for key in _rest_keys(skeleton, rest)]
    poses = tuple((rest.start_s, _resting(skeleton, side, rest.pose)) for rest in rests)
    arc = Arc(plan.style.retractions.arc_deg, poses)
    keys += [key for gesture in gestures for key in _gesture_keys(skeleton, gesture, arc)]
    if gestures and gestures[0].initial_progress:
        keys = _underway(skeleton, gestures[0], keys, from_behind=rests[0].pose == BEHIND_BACK)
        rests = tuple(rest for rest in rests if rest.start_s > 0.0)
    keys += [way for rest in rests if rest.pose == BEHIND_BACK for way in _past_the_hip(skeleton, rest, keys)]
    apart = tuple(_apart(sorted(keys, key=lambda key: key.time_s)))
    return ArmTrack(side, within_the_shoulder(side, apart))


def _past_the_hip(skeleton: Skeleton, behind: ArmRest, keys: Sequence[TimedPose]) -> Iterator[TimedPose]:
    """The keys on the ways to and from behind the back at which the arm hangs, since the straight way is through the
    body: when the hand, at an even speed, gets there."""
    hanging = _resting(skeleton, behind.side, "at_side")
    there = max((key for key in keys if key.time_s < behind.start_s), key=lambda key: key.time_s, default=None)
    back = min((key for key in keys if key.time_s > behind.end_s), key=lambda key: key.time_s, default=None)
    for other, rest_s in ((there, behind.start_s), (back, behind.end_s)):
        if other is not None and other.pose is not hanging:
            share = _share_behind(_resting(skeleton, behind.side, BEHIND_BACK), hanging, other.pose)
            yield TimedPose(rest_s + share * (other.time_s - rest_s), hanging)


def _share_behind(behind: PartialPose, hanging: PartialPose, other: PartialPose) -> float:
    """The share of the way from behind the back to the other pose until the arm hangs."""
    if behind.wrist_m is None or hanging.wrist_m is None or other.wrist_m is None:
        return _USUAL_SHARE
    places_m = (behind.wrist_m, other.wrist_m)
    first_m, second_m = (float(np.linalg.norm(each_m - hanging.wrist_m)) for each_m in places_m)
    return first_m / (first_m + second_m)


def _underway(skeleton: Skeleton, first: ArmGesture, keys: list[TimedPose], *, from_behind: bool) -> list[TimedPose]:
    """The keys, with the pose of the first frame moved towards the first gesture by the progress it has already
    made; a hand that comes `from_behind` the back has passed the hip."""
    posed = _posed(skeleton, first)
    start = _together(each.pose for each in posed if each.key.time_s <= first.placed.clip.markers.stroke_start)
    at_rest = next(key for key in keys if key.time_s == 0.0)
    at_rest = replace(at_rest, pose=_resting(skeleton, first.side, "at_side")) if from_behind else at_rest
    parts = slerp(at_rest.pose.parts, start.over(at_rest.pose).parts, np.array(first.initial_progress))
    until_s = first.markers.start
    waiting = [replace(at_rest, time_s=time_s, pose=PartialPose(parts)) for time_s in {0.0, until_s}]
    return [*waiting, *(key for key in keys if key.time_s > until_s)]


def _apart(keys: Iterable[TimedPose]) -> Iterator[TimedPose]:
    """The keys without those that follow another too closely; of two, a marked key is kept."""
    last: TimedPose | None = None
    for key in keys:
        if last is not None and key.time_s - last.time_s < _SHORTEST_KEY_S and not (last.marked and key.marked):
            last = key if key.marked else last
            continue
        if last is not None:
            yield last
        last = key
    if last is not None:
        yield last


def _rest_keys(skeleton: Skeleton, rest: ArmRest) -> Iterator[TimedPose]:
    pose = _resting(skeleton, rest.side, rest.pose)
    yield TimedPose(rest.start_s, pose, noise=REST_NOISE)
    for beat in rest.beats:
        yield from _repeat_keys(beat, pose, pose, _resting(skeleton, rest.side, LIFTED))
    yield TimedPose(rest.end_s, pose, noise=REST_NOISE)


@dataclass(frozen=True, slots=True, eq=False)
class _PosedKey:
    """A key of a clip, at its absolute time and with its pose."""

    time_s: float
    key: ClipKey
    pose: PartialPose


@dataclass(frozen=True, slots=True)
class Arc:
    """How far out the arms go on their ways to rest, and where those lead, by arm."""

    degrees: float
    rests: tuple[tuple[float, PartialPose], ...]

    def rest_at(self, time_s: float) -> PartialPose | None:
        """The pose of the rest that begins then."""
        return next((pose for start_s, pose in self.rests if abs(start_s - time_s) < _SHORTEST_KEY_S), None)


def _gesture_keys(skeleton: Skeleton, gesture: ArmGesture, arc: Arc) -> Iterator[TimedPose]:
    """The keys of a gesture, including its hold and those on the way back to rest."""
    posed = list(_posed(skeleton, gesture))
    markers = gesture.placed.clip.markers
    yield from (_timed(gesture, each) for each in posed if not markers.stroke_end < each.key.time_s == markers.relax)
    start = _together(each.pose for each in posed if each.key.time_s <= markers.stroke_start)
    end = _together(each.pose for each in posed if each.key.time_s <= markers.relax)
    turned = _together(each.pose for each in posed if each.key.time_s < markers.stroke_end)
    hanging = _resting(skeleton, gesture.side, "at_side")
    for repeat in (*gesture.placed.repeats, *gesture.beats):
        yield from _repeat_keys(repeat, turned if repeat.swings else start, end, hanging)
    held = next((each.key.curve for each in posed if each.key.time_s == markers.relax), KeyCurve())
    yield _shaped(TimedPose(gesture.markers.relax, end, noise=HOLD_NOISE), held)
    drops = gesture.blended_to is None and not any(each.key.time_s > markers.relax for each in posed)
    if drops and arc.degrees and gesture.markers.end - gesture.markers.relax > _SHORTEST_ARC_S:
        yield from _arced(gesture, end, arc)


def _arced(gesture: ArmGesture, end: PartialPose, arc: Arc) -> Iterator[TimedPose]:
    """The pose in the middle of a way to rest: outwards, and nearer to its end than in time, for a hand that has been
    let go comes down slower and slower."""
    rest = arc.rest_at(gesture.markers.end)
    if rest is not None:
        way_s = gesture.markers.end - gesture.markers.relax
        parts = slerp(end.parts, rest.parts, np.array(_DECAYED))
        parts[1] = multiply(_outwards(arc.degrees, gesture.side), parts[1])
        yield TimedPose(gesture.markers.relax + _HALF * way_s, PartialPose(parts), noise=STROKE_NOISE)


@lru_cache(maxsize=64)
def _outwards(degrees: float, side: Hand) -> FloatArray:
    """The rotation (4,) of an arm outwards. Cached; never mutated."""
    turn = np.radians(degrees) * (1.0 if side is Hand.LEFT else -1.0)
    return from_axis_angle((0.0, 0.0, 1.0), np.array(turn))


def _posed(skeleton: Skeleton, gesture: ArmGesture) -> Iterator[_PosedKey]:
    said = [(key, arm_key(key, gesture.side)) for key in gesture.placed.clip.keys if _is_played(gesture, key)]
    played = [(key, of_arm) for key, of_arm in said if of_arm is not None]
    asked, placed = tuple(of_arm for _key, of_arm in played), gesture.placed
    size, manner = amplitude(placed), placed.clip.manner
    poses = _poses(skeleton, gesture.side, asked, size=size, aim_m=placed.aim_m, manner=manner)
    if placed.aim_m is not None and placed.aimed_from_s > 0:
        free = _poses(skeleton, gesture.side, asked, size=size, aim_m=None, manner=manner)
        before = sum(key.time_s < placed.aimed_from_s for key, _of_arm in played)
        poses = (*free[:before], *poses[before:])
    for (key, _of_arm), pose in zip(played, poses, strict=True):
        made = _part_of_the_way(skeleton, gesture, pose) if placed.follows else pose
        made = _bent(made, gesture.side, placed.bends_deg) if placed.bends_deg else made
        yield _PosedKey(_on_the_clock(gesture, key.time_s), key, made)


def _part_of_the_way(skeleton: Skeleton, gesture: ArmGesture, pose: PartialPose) -> PartialPose:
    """A pose of a hand that only follows: between where it rests and `pose`, with relaxed fingers."""
    resting = _resting(skeleton, gesture.side, gesture.placed.basis).parts
    parts = slerp(resting, pose.parts, np.array(gesture.placed.share))
    parts[HAND_ROWS] = resting[HAND_ROWS]
    return PartialPose(parts)


def _bent(pose: PartialPose, side: Hand, bends_deg: tuple[float, ...]) -> PartialPose:
    """The pose with its fingers bent further, all three joints of each alike."""
    parts = pose.parts.copy()
    turn_about_z(parts[-FINGER_ROWS:], np.radians(np.repeat(bends_deg, 3)) * (-1.0 if side is Hand.LEFT else 1.0))
    return PartialPose(parts, pose.wrist_m)


@lru_cache(maxsize=1024)
def _poses(
    skeleton: Skeleton,
    side: Hand,
    asked: tuple[ArmKey, ...],
    *,
    size: float,
    aim_m: Position | None,
    manner: GestureManner,
) -> tuple[PartialPose, ...]:
    """The poses of these keys. Cached, because lines repeat keys and each pose searches for an elbow swivel; never
    mutated."""
    from_hips_m = None if aim_m is None else np.array(aim_m) - skeleton.offsets_m[0]
    return pose_arms(skeleton, side, asked, amplitude=size, aim_m=from_hips_m, manner=manner)


@lru_cache(maxsize=64)
def _resting(skeleton: Skeleton, side: Hand, name: str) -> PartialPose:
    return rest_pose(skeleton, side, name).as_partial()


def _is_played(gesture: ArmGesture, key: ClipKey) -> bool:
    """Whether a key is used. The plan decides the rests, so a clip's own start and end are not; nor are phases cut
    short."""
    clip, time_s = gesture.placed.clip.markers, key.time_s
    if time_s < clip.stroke_start:
        return gesture.blended_from is None and key.type is not FrameType.START
    if time_s <= clip.stroke_end:
        return True
    if time_s <= clip.relax:
        return not gesture.placed.repeats and gesture.markers.relax > gesture.markers.stroke_end
    return gesture.blended_to is None and key.type is not FrameType.END


def _on_the_clock(gesture: ArmGesture, clip_s: float) -> float:
    """The absolute time of a time in the clip: phases are stretched to the plan's, the stroke is only shifted."""
    clip, clock = gesture.placed.clip.markers, gesture.markers
    if clip.stroke_start <= clip_s <= clip.stroke_end:
        return gesture.placed.offset_s + clip_s
    before = ((clip.start, clock.start), (clip.ready, clock.ready), (clip.stroke_start, clock.stroke_start))
    after = ((clip.stroke_end, clock.stroke_end), (clip.relax, clock.relax), (clip.end, clock.end))
    first, middle, last = before if clip_s < clip.stroke_start else after
    (from_s, on_s), (to_s, off_s) = (first, middle) if clip_s < middle[0] else (middle, last)
    share = (clip_s - from_s) / (to_s - from_s) if to_s > from_s else 1.0
    return on_s + min(max(share, 0.0), 1.0) * (off_s - on_s)


def _timed(gesture: ArmGesture, posed: _PosedKey) -> TimedPose:
    expressivity, kind = gesture.placed.clip.expressivity, posed.key.type
    in_stroke = kind in {FrameType.STROKE_START, FrameType.STROKE, FrameType.STROKE_END}
    holds = kind in {FrameType.HOLD, FrameType.RELAX, FrameType.STROKE_END}
    tension, bias = _curve(expressivity, kind)
    noise = HOLD_NOISE if holds else ADDED_NOISE if posed.key.noise else STROKE_NOISE
    timed = TimedPose(posed.time_s, posed.pose, tension=tension, bias=bias, noise=noise, marked=in_stroke)
    return _shaped(timed, posed.key.curve)


def _shaped(timed: TimedPose, curve: KeyCurve) -> TimedPose:
    """The key with what its frame itself says of the curve."""
    if curve == _UNSAID:
        return timed
    said = {name: getattr(curve, name) for name in KeyCurve.__slots__}
    return replace(timed, **{name: value for name, value in said.items() if value is not None})


def _curve(expressivity: Expressivity, kind: FrameType) -> tuple[float, float]:
    """Tension and bias; both are 0 where fluidity and power are .5."""
    if kind is FrameType.STROKE_END:
        return expressivity.power - 0.5, 0.5 * (expressivity.power - 0.5)
    return 0.5 - expressivity.fluidity, 0.0


def _repeat_keys(repeat: Repeat, start: PartialPose, end: PartialPose, hanging: PartialPose) -> Iterator[TimedPose]:
    """Hold, move back towards the start of the stroke or towards hanging, and strike again on the emphasis."""
    turn_s = repeat.start_s + _BACK * (repeat.end_s - repeat.start_s)
    towards, share = start.over(end), repeat.amplitude
    if repeat.way_m is not None:
        towards, share = hanging, _share_of_way(end, hanging, repeat.way_m)
    back = slerp(end.parts, towards.parts, np.array(share))
    if not repeat.swings:
        back[HAND_ROWS] = end.parts[HAND_ROWS]
    yield TimedPose(repeat.start_s, end, noise=HOLD_NOISE)
    yield TimedPose(turn_s, PartialPose(back), noise=STROKE_NOISE)
    yield TimedPose(repeat.end_s, end, noise=HOLD_NOISE, marked=True)


def _share_of_way(end: PartialPose, hanging: PartialPose, way_m: float) -> float:
    """The share of the way to hanging that is about `way_m` long."""
    if end.wrist_m is None or hanging.wrist_m is None:
        return _USUAL_SHARE
    return min(_MOST_SHARE, way_m / max(float(np.linalg.norm(end.wrist_m - hanging.wrist_m)), 1e-6))


def _together(poses: Iterable[PartialPose]) -> PartialPose:
    """Poses in order, merged: for each part the last one that defines it."""
    return reduce(lambda below, pose: pose.over(below), poses)

"""The body's frames, while its schedule still changes.

The realizer makes motion from whole schedules. Here it makes takes: the schedule as known now, on a clock of `TAKE_S`,
whose frames are sent until the schedule changes or the take ends. Behaviours move the body only while they last, and
idle motion depends on the seed alone, so two takes of one clock are equal where their schedules are; where they differ,
a blend leads from one to the other. A new clock begins `BEFORE_S` before now, so that current behaviours begin within
it, and has another seed, or idle motion would repeat.

Lips follow the voice (`mouth`), except where the take has visemes of words.

A blend is without a jump: the difference in pose and velocity at that moment is added to the new motion and decays.

Each curve's difference follows the quintic that begins with it and its rate of change and ends at rest (Bollo 2016,
"Inertialization"), but begins without acceleration. Rotations differ by a rotation vector on the left. Radians, metres,
seconds.
"""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import floor, inf

import numpy as np

from ..model import Behavior, FloatArray, Interval, Schedule, Viseme
from ..realizer.body.motion import SHAPES
from ..realizer.face.face_tables import INDEX, VISEMES
from ..realizer.geometry.rotations import from_rotation_vector, inverse, length, multiply, to_rotation_vector
from ..realizer.realizing import Realizer, realize
from .mouth import MouthShape

TAKE_S, BEFORE_S = 12.0, 4.0

_LIPS_S = 0.05
"""The time constant of the lips, seconds."""

_EARLY_S = 1e-6
_JAW, _CLOSE = INDEX["jawOpen"], INDEX["mouthClose"]


@dataclass(frozen=True, slots=True)
class LiveBodyOptions:
    """The character, seed, frame rate and stillness of a live body."""

    character: str
    seed: int
    frame_rate_hz: int
    stillness: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class BodyFrame:
    """The body at `at_s`: local rotations (J, 4) as x y z w, position of the hips (3,), blendshapes (52,)."""

    at_s: float
    rotations: FloatArray
    hips_m: FloatArray
    shapes: FloatArray


@dataclass(frozen=True, slots=True)
class BodyRequest:
    """The behaviours and visemes that the body should perform, on the stream's clock."""

    behaviors: tuple[Behavior, ...] = ()
    visemes: tuple[Viseme, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Pose:
    """Local rotations (J, 4), place of the hips (3,), shapes of the face (52,); or of many frames, first axis time."""

    rotations: FloatArray
    hips_m: FloatArray
    shapes: FloatArray

    @classmethod
    def of(cls, frames: Sequence["Pose"]) -> "Pose":
        """Single frames stacked into a motion."""
        return cls(
            np.stack([each.rotations for each in frames]),
            np.stack([each.hips_m for each in frames]),
            np.stack([each.shapes for each in frames]),
        )

    def at(self, frames: int | slice) -> "Pose":
        """That frame, or those."""
        return Pose(self.rotations[frames], self.hips_m[frames], self.shapes[frames])


class LiveBody:
    """Gives frames up to a moment, each once. Memory is bounded."""

    def __init__(self, realizer: Realizer, performing: LiveBodyOptions) -> None:
        self._realizer, self._performing = realizer, performing
        self._frame_s = 1 / performing.frame_rate_hz
        self._next = self._clocks = self._begin = 0
        self._take: Pose | None = None
        self._offset: Offset | None = None
        self._shown: list[Pose] = []
        self._asked = BodyRequest()
        self._due_s = inf
        self._lips = np.zeros(len(SHAPES))

    def ask(self, asked: BodyRequest) -> None:
        """Sets what to perform from the next frame on."""
        if asked != self._asked:
            self._due_s = min(self._due_s, _differ_from_s(self._asked, asked, self._next * self._frame_s))
            self._asked = asked

    def frames_until(self, now_s: float, mouth: Sequence[MouthShape]) -> tuple[BodyFrame, ...]:
        """The frames up to now. `mouth` has the shapes from the voice since before the last frame."""
        last = floor(now_s / self._frame_s + _EARLY_S)
        frames: list[BodyFrame] = []
        while self._next <= last:
            count = min(last + 1 - self._next, self._frames_left() or self._retaken())
            frames += self._shown_frames(count, mouth)
        return tuple(frames)

    def _frames_left(self) -> int:
        """How many frames of the take still agree with what is asked."""
        if self._take is None:
            return 0
        left = self._begin + len(self._take.hips_m) - self._next
        return left if self._due_s == inf else max(0, min(left, floor(self._due_s / self._frame_s) - self._next))

    def _retaken(self) -> int:
        """Makes a take from the next frame on, blended from the last frames; returns the frames it has left."""
        if not self._clocks or self._next - self._begin >= round((TAKE_S - 1.0) / self._frame_s):
            self._clocks += 1
            self._begin = self._next - round(BEFORE_S / self._frame_s)
        self._take = take = self._realized(self._begin * self._frame_s)
        self._due_s = inf
        if self._shown:
            at = self._next - self._begin
            shown = Pose.of((self._shown * 2)[-2:])
            at_s = (self._next - 1) * self._frame_s
            self._offset = Offset.between(shown, take.at(slice(at - 2, at)), at_s=at_s, frame_s=self._frame_s)
        return self._frames_left()

    def _realized(self, begin_s: float) -> Pose:
        schedule = Schedule(
            behaviors=tuple(self._on_clock(begin_s)),
            duration_s=TAKE_S,
            visemes=tuple(_later(each, begin_s) for each in self._asked.visemes if each.interval.end_s > begin_s),
            character=self._performing.character,
            stillness=self._performing.stillness,
        )
        seed = self._performing.seed + self._clocks
        rate_hz = self._performing.frame_rate_hz
        motion = realize(self._realizer, schedule, frame_rate_hz=rate_hz, seed=seed, open_ended=True)
        return Pose(motion.body.rotations, motion.body.hips_m, motion.shapes)

    def _on_clock(self, begin_s: float) -> list[Behavior]:
        """The behaviours that are not over, on the take's clock."""
        going_on = (each for each in self._asked.behaviors if begin_s <= each.sync.start < begin_s + TAKE_S)
        return [replace(each, sync=each.sync.shifted(-begin_s)) for each in going_on]

    def _shown_frames(self, count: int, mouth: Sequence[MouthShape]) -> list[BodyFrame]:
        assert self._take is not None, "there is a take"
        first = self._next - self._begin
        times_s = np.arange(self._next, self._next + count) * self._frame_s
        poses = self._take.at(slice(first, first + count))
        if self._offset is not None:
            poses = self._offset.added(poses, times_s)
        self._shown = [*self._shown, *(poses.at(each) for each in range(count))][-2:]
        self._next += count
        lips = self._spoken(times_s, mouth)
        return [
            BodyFrame(at_s, poses.rotations[each], poses.hips_m[each], _with_lips(poses.shapes[each], lips[each]))
            for each, at_s in enumerate(times_s.tolist())
        ]

    def _spoken(self, times_s: FloatArray, mouth: Sequence[MouthShape]) -> FloatArray:
        """The mouth's shapes (frames × 52) by the voice."""
        table, begins_s = self._realizer.face.visemes, [each.at_s for each in mouth]
        worded = [each.interval for each in self._asked.visemes]
        shares, lips = 1 - np.exp(-self._frame_s / _LIPS_S), []
        for at_s in times_s.tolist():
            place, target = bisect_right(begins_s, at_s) - 1, np.zeros(len(SHAPES))
            if place >= 0 and not _is_in(worded, at_s):
                target = table.targets[VISEMES.index(mouth[place].viseme)] * mouth[place].articulation
                target[_JAW] = mouth[place].opening * table.widest_jaw
            self._lips = self._lips + shares * (target - self._lips)
            lips.append(self._lips)
        return np.array(lips)


def _differ_from_s(before: BodyRequest, after: BodyRequest, now_s: float) -> float:
    """The time from which what is asked moves the body differently; behaviours that are over do not count."""
    if before.visemes != after.visemes:
        return now_s
    ones, others = ({each.id: each for each in asked.behaviors} for asked in (before, after))
    moments_s = [inf]
    for name in ones.keys() | others.keys():
        one, other = ones.get(name), others.get(name)
        if one is None or other is None:
            alone = one or other
            assert alone is not None, "the name is one of theirs"
            moments_s += [alone.sync.start] if alone.sync.end > now_s else []
        elif one != other:
            moments_s.append(_unlike_from_s(one, other))
    return max(now_s, min(moments_s))


def _unlike_from_s(one: Behavior, other: Behavior) -> float:
    """From when on two states of a behaviour differ: the last sync point before the first that is another."""
    if replace(one, sync=other.sync) != other:
        return min(one.sync.start, other.sync.start)
    same_s = min(one.sync.start, other.sync.start)
    for mine, theirs in zip(one.sync.in_order(), other.sync.in_order(), strict=False):
        if mine != theirs:
            break
        same_s = mine[1]
    return same_s


def _with_lips(shapes: FloatArray, lips: FloatArray) -> FloatArray:
    shown: FloatArray = np.clip(np.maximum(shapes, lips), 0.0, 1.0)
    shown[_CLOSE] = min(shown[_CLOSE] * lips[_JAW], shown[_JAW]) if lips[_JAW] > shapes[_JAW] else shown[_CLOSE]
    return shown


def _is_in(intervals: Sequence[Interval], at_s: float) -> bool:
    return any(each.start_s <= at_s < each.end_s for each in intervals)


def _later(viseme: Viseme, begin_s: float) -> Viseme:
    interval = viseme.interval
    return replace(viseme, interval=Interval(max(0.0, interval.start_s - begin_s), interval.end_s - begin_s))


SHORTEST_S, LONGEST_S = 0.25, 0.9

SPEED = 4.0
"""The fastest decay of a difference, radians a second."""

_PEAK = 1.875
"""The quintic's peak speed, relative to a linear decay."""

FACE_S = 0.12


@dataclass(frozen=True, slots=True, eq=False)
class Offset:
    """The difference added from `from_s` on: rotation vectors (J, 3), position (3,) and shapes (52,), their rates of
    change, and each joint's time of decay (J,)."""

    from_s: float
    turned: FloatArray
    turning: FloatArray
    hips_m: FloatArray
    hips_m_per_s: FloatArray
    shapes: FloatArray
    lasts_s: FloatArray

    @classmethod
    def between(cls, shown: Pose, new: Pose, *, at_s: float, frame_s: float) -> "Offset":
        """`shown` are the last two frames that were sent, `new` the new motion's frames at the same times."""
        turned = to_rotation_vector(multiply(shown.rotations, inverse(new.rotations)))
        moved, reshaped = shown.hips_m - new.hips_m, shown.shapes - new.shapes
        by = length(turned[1])[:, 0]
        return cls(
            from_s=at_s,
            turned=turned[1],
            turning=(turned[1] - turned[0]) / frame_s,
            hips_m=moved[1],
            hips_m_per_s=(moved[1] - moved[0]) / frame_s,
            shapes=reshaped[1],
            lasts_s=np.clip(_PEAK * by / SPEED, SHORTEST_S, LONGEST_S),
        )

    def added(self, motion: Pose, times_s: FloatArray) -> Pose:
        """The motion (frames at `times_s`) plus the rest of the difference."""
        since_s = (times_s - self.from_s)[:, None, None]
        if since_s[0, 0, 0] >= LONGEST_S:
            return motion
        turned = _dying(since_s, self.lasts_s[:, None], self.turned, self.turning)
        hips = _dying(since_s[:, 0], np.full(3, LONGEST_S), self.hips_m, self.hips_m_per_s)
        shapes = _dying(since_s[:, 0], np.full(len(self.shapes), FACE_S), self.shapes, np.zeros_like(self.shapes))
        return Pose(
            multiply(from_rotation_vector(turned), motion.rotations),
            motion.hips_m + hips,
            np.clip(motion.shapes + shapes, 0.0, 1.0),
        )


def _dying(since_s: FloatArray, lasts_s: FloatArray, by: FloatArray, rate: FloatArray) -> FloatArray:
    """The quintic from `by` at `rate` to zero."""
    share = np.clip(since_s / lasts_s, 0.0, 1.0)
    cubed = share**3
    place = 1 - cubed * (10 - 15 * share + 6 * share**2)
    speed = share - cubed * (6 - 8 * share + 3 * share**2)
    return np.asarray(by * place + rate * lasts_s * speed)

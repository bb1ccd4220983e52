"""The shipped gestures compared with people's: wrist positions in strokes, durations and speeds of strokes.

    python -m benchmarks.realizer.gestures.gesture_library [--rate HZ]

Every definition of lexicon/gestures/ at every level of agitation, played alone: from arms that hang, through its keys,
and back. The wrist of the hand that leads is measured from stroke start to stroke end. Sectors are McNeill's, each
wrist counted as in the nearest of `understudy.realizer.gestures.gesture_space`, in the outer of its two rings (across
and up). "People" are the figures of shared/motion.md: percentiles 25, 50, 75, 95 of the peak speed of strokes;
percentiles 5, 50, 95 of height (0 the hips, 1 the shoulders) and of reach forward, in arm lengths; percentiles 10, 50,
90 of durations.
"""

import argparse
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from understudy.files import resource_folder
from understudy.model import FloatArray, Hand, Level
from understudy.realizer.arms.arm_reach import ArmBones
from understudy.realizer.arms.interpolation import ArmTrack, TimedPose, arm_motion
from understudy.realizer.arms.posing import pose_arm, wrist_of
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.gestures.gesture import Clip, FrameType, HeightSector, Sideways
from understudy.realizer.gestures.gesture_space import HEIGHT, SHOULDERS_ABOVE_HIPS_M, SIDEWAYS_M, sector_m
from understudy.realizer.gestures.library import LEADING, Library, clip

RINGS: Mapping[Sideways | HeightSector, int] = {
    **dict(zip(Sideways, (3, 2, 1, 0, 1, 2, 3), strict=True)),
    **dict(zip(HeightSector, (3, 2, 1, 0, 1, 2, 3), strict=True)),
}
RING_NAMES = ("centre-centre", "centre", "periphery", "extreme periphery")
PEOPLE_RINGS_PERCENT = (9, 24, 60, 7)
BEFORE_S, AFTER_S = 0.1, 0.1
"""For which the arms hang before a clip and after it: the paper's "small" begins with its stroke."""

STROKE_TYPES = frozenset({FrameType.STROKE, FrameType.STROKE_END})


@dataclass(frozen=True, slots=True)
class Stroke:
    """One clip's stroke: how long, how fast on the straight way and at its peak, by one hand or both."""

    level: Level
    duration_s: float
    mean_m_s: float
    peak_m_s: float
    two_handed: bool


def clips(library: Library) -> Iterator[Clip]:
    for definition in library.definitions:
        for level in definition.levels:
            yield clip(definition, level, definition.hand or LEADING, definition.categories[0])


def stroke(skeleton: Skeleton, found: Clip, rate_hz: int) -> Stroke:
    """The clip played from rest to rest."""
    side = LEADING if found.hand is Hand.BOTH else found.hand
    rest = rest_pose(skeleton, side, "at_side").as_partial()
    keys = [TimedPose(-BEFORE_S, rest)]
    for key in found.keys:
        arm = key.left if side is Hand.LEFT else key.right
        if arm is not None and key.type is not FrameType.END:
            pose = pose_arm(skeleton, side, arm, amplitude=found.expressivity.amplitude)
            keys.append(TimedPose(key.time_s, pose))
    marks = found.markers
    keys.append(TimedPose(marks.end + AFTER_S, rest))
    times_s = np.arange(0, marks.end, 1 / rate_hz)
    wrist_m = wrist_of(skeleton, side, arm_motion(ArmTrack(side, tuple(keys)), times_s, seed=0))
    speed_m_s = np.linalg.norm(np.gradient(wrist_m, 1 / rate_hz, axis=0), axis=-1)
    within = (times_s >= marks.stroke_start) & (times_s <= marks.stroke_end)
    return Stroke(
        level=found.level,
        duration_s=marks.stroke_end - marks.stroke_start,
        mean_m_s=found.stroke_speed_m_s,
        peak_m_s=float(speed_m_s[within].max()),
        two_handed=found.hand is Hand.BOTH,
    )


def stroke_places_m(found: Clip) -> Iterator[FloatArray]:
    """The wrists at the key poses inside strokes and at their ends."""
    for key in found.keys:
        for arm in (key.left, key.right):
            if arm is not None and arm.place is not None and key.type in STROKE_TYPES:
                yield sector_m(arm.place, found.expressivity.amplitude)


def ring(wrist_m: FloatArray) -> int:
    """0 for centre-centre to 3 for the extreme periphery."""
    sideways = min(SIDEWAYS_M, key=lambda sector: abs(SIDEWAYS_M[sector] - wrist_m[0]))
    height = min(HEIGHT, key=lambda sector: abs(HEIGHT[sector] * SHOULDERS_ABOVE_HIPS_M - wrist_m[1]))
    return max(RINGS[sideways], RINGS[height])


def percentiles(values: Sequence[float] | FloatArray, *which: int) -> str:
    return " ".join(f"{value:.2f}" for value in np.percentile(values, which))


def report(library: Library, rate_hz: int) -> Iterator[str]:
    skeleton = Skeleton.standing()
    every = list(clips(library))
    strokes = [stroke(skeleton, found, rate_hz) for found in every]
    yield f"{len(library.definitions)} gestures, {len(library.categories)} categories, {len(every)} clips"
    yield f"two-handed: {100 * np.mean([each.two_handed for each in strokes]):.0f} %; people 38 %"
    for level in Level:
        of_level = [each for each in strokes if each.level is level]
        yield f"{level}: stroke s {percentiles([each.duration_s for each in of_level], 10, 50, 90)}"
        yield f"{level}: mean speed m/s {percentiles([each.mean_m_s for each in of_level], 25, 50, 75, 95)}"
        yield f"{level}: peak speed m/s {percentiles([each.peak_m_s for each in of_level], 25, 50, 75, 95)}"
    yield f"all: peak speed m/s {percentiles([each.peak_m_s for each in strokes], 25, 50, 75, 95)}"
    yield f"all: fastest {max(each.peak_m_s for each in strokes):.2f} m/s; people .50 .85 1.22 1.86, .73 s (.23 2.64)"
    places_m = np.array([place for found in every for place in stroke_places_m(found)])
    counted = Counter(map(ring, places_m))
    for number, name in enumerate(RING_NAMES):
        yield f"{name}: {100 * counted[number] / len(places_m):.0f} %; people {PEOPLE_RINGS_PERCENT[number]} %"
    arm_m = ArmBones.of(skeleton).length_m
    yield f"height {percentiles(places_m[:, 1] / SHOULDERS_ABOVE_HIPS_M, 5, 50, 95)}; people -.05 .34 .98"
    yield f"reach {percentiles(places_m[:, 2] / arm_m, 5, 50, 95)}; people .14 .45 .76"


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--rate", type=int, default=120, help="frames a second")
    rate_hz = parser.parse_args().rate
    for line in report(Library.load(resource_folder("lexicon") / "gestures"), rate_hz):
        print(line)


if __name__ == "__main__":
    main()

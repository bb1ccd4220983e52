"""Accuracy with which every character points and looks at targets around it.

    python -m benchmarks.realizer.head_and_gaze.targets

Each character of the lexicon points and looks at targets 2 m away in all directions, from 0.3 to 2.2 m high, by the
hand of their side (`understudy.behavior.candidates.targets`). "Hand" is the angle at the shoulder between the target
and the wrist when the stroke ends, "eyes" the angle between the line of sight and the target 0.3 s after the look has
arrived.
"""

from collections.abc import Iterator
from itertools import product

import numpy as np

from understudy.model import Behavior, Channel, FloatArray, Hand, Schedule, SyncPoints, Target
from understudy.models import load_realizer
from understudy.realization import Realizer, realize
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import rotate

DISTANCE_M = 2.0
ANGLES_DEG = (-150, -90, -60, -30, 0, 30, 60, 90, 150)
HEIGHTS_M = (0.3, 0.9, 1.5, 2.2)
STROKE_S, LOOK_S = 1.5, 1.4
AHEAD = np.array([0.0, 0.0, 1.0])


def main() -> None:
    realizer = load_realizer()
    for name in realizer.performers:
        for told, angles in (("within 60°", ANGLES_DEG[2:-2]), ("at 90°", (-90, 90)), ("at 150°", (-150, 150))):
            errors = np.array([errors_deg(realizer, name, target) for target in targets(angles)])
            hand, eyes = (f"{np.median(each):.0f} / {each.max():.0f}" for each in errors.T)
            print(f"{name:13s} {told:10s} median / most, degrees: hand {hand}, eyes {eyes}")


def targets(angles_deg: tuple[int, ...]) -> Iterator[Target]:
    for angle, height_m in product(np.radians(angles_deg), HEIGHTS_M):
        yield Target("thing", (float(DISTANCE_M * np.sin(angle)), height_m, float(DISTANCE_M * np.cos(angle))))


def errors_deg(realizer: Realizer, character: str, target: Target) -> tuple[float, float]:
    """How far hand and eyes are off a target."""
    left = target.position_m[0] >= 0
    side, lexeme = (Hand.LEFT, "POINT_LEFT") if left else (Hand.RIGHT, "POINT_RIGHT")
    pointing = SyncPoints(0.6, 3.0, stroke=STROKE_S, stroke_end=STROKE_S + 0.2, relax=2.4)
    looking = SyncPoints(1.0, 3.0, ready=LOOK_S, relax=2.6)
    behaviors = (
        Behavior("point", Channel.GESTURE, lexeme, pointing, 0, 0, 1.0, hand=side, target=target.name),
        Behavior("look", Channel.GAZE, "LOOK", looking, 0, 0, 1.0, target=target.name),
    )
    motion = realize(realizer, Schedule(behaviors, 4.0, character=character, targets=(target,)))
    skeleton, body = realizer.performer(character).skeleton, motion.body
    frames = np.searchsorted(body.times_s, (motion.realized["point"].stroke_end or 0.0, LOOK_S + 0.3))
    places_m, turned = forward(skeleton, body.rotations[frames], body.hips_m[frames])
    shoulder, wrist = (skeleton.index[side.value + joint] for joint in ("UpperArm", "Hand"))
    hand = between_deg(places_m[0, wrist] - places_m[0, shoulder], target.position_m - places_m[0, shoulder])
    eyes = skeleton.chain("leftEye", "rightEye")
    seen = (between_deg(rotate(turned[1, eye], AHEAD), target.position_m - places_m[1, eye]) for eye in eyes)
    return hand, float(np.mean(list(seen)))


def between_deg(one: FloatArray, other: FloatArray) -> float:
    cosine = one @ other / np.linalg.norm(one) / np.linalg.norm(other)
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


if __name__ == "__main__":
    main()

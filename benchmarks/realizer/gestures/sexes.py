"""How the gestures of a woman and of a man differ: the same schedules, by two bodies of the same height.

    python -m benchmarks.realizer.gestures.sexes

Each gesture that has variants (lexicon/movement.yaml) is made alone, with the right hand and with both, by a woman, a
man and the neutral body of 1.73 m, at medium agitation. Measured `SETTLED_S` after the stroke, of the right arm: the
angle of the upper arm from straight down, to the side; how far the wrist is out from the shoulder and above the hips;
the bend of the wrist; the mean bend of the fingers' middle joints. A gesture differs where a wrist is `APART_M` or the
direction of the hand `APART_DEG` elsewhere; and standing for a minute, how far the hips go to the sides.
"""

from dataclasses import dataclass
from itertools import product
from pathlib import Path

import numpy as np

from understudy.authored_folders import lexicon_folder
from understudy.model import Behavior, Channel, FloatArray, Hand, Interval, Schedule, SyncPoints
from understudy.model.figure import Figure, Physique, Sex
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import rotate
from understudy.realizer.realizing import Realizer, realize

RATE_HZ = 30
SETTLED_S = 0.1
APART_M, APART_DEG = 0.05, 10.0
SYNC = SyncPoints(start=0.6, ready=1.1, stroke_start=1.1, stroke=1.5, stroke_end=1.6, relax=2.3, end=3.0)
STANDS_S = 60.0


@dataclass(frozen=True, slots=True)
class Pose:
    """The right arm at the end of a stroke; lengths in metres, angles in degrees."""

    elbow_deg: float
    out_m: float
    up_m: float
    wrist_deg: float
    fingers_deg: float
    wrist_m: FloatArray
    hand: FloatArray


def main() -> None:
    realizer = load(lexicon_folder())
    asked = list(product(realizer.style.variants, (Hand.RIGHT, Hand.BOTH)))
    found = {sex: [pose(realizer, sex, *each) for each in asked] for sex in Sex}
    for sex, poses in found.items():
        rows = np.array([(p.elbow_deg, 100 * p.out_m, 100 * p.up_m, p.wrist_deg, p.fingers_deg) for p in poses])
        elbow, out, up, wrist, fingers = np.median(rows, axis=0)
        print(
            f"{sex:8} upper arm {elbow:5.1f} deg out, wrist {out:5.1f} cm out, {up:5.1f} cm up, bent {wrist:5.1f} deg, "
            f"fingers {fingers:5.1f} deg, hips sideways sd {swayed_cm(realizer, sex):4.1f} cm"
        )
    pairs = zip(found[Sex.FEMALE], found[Sex.MALE], strict=True)
    differ = [apart(one, other) for one, other in pairs]
    print(f"woman and man differ in {sum(differ)} of {len(differ)} gestures of {len(realizer.style.variants)} lexemes")


def load(lexicon: Path) -> Realizer:
    """Performers by the names of their sexes."""
    return Realizer.load(lexicon, {sex.value: Figure(Physique(sex=sex)) for sex in Sex})


def pose(realizer: Realizer, sex: Sex, lexeme: str, hand: Hand) -> Pose:
    asked = Behavior(
        id="g", kind=Channel.GESTURE, lexeme=lexeme, sync=SYNC, first=0, last=0, priority=1.0, hand=hand, amount=0.5
    )
    motion = realize(realizer, Schedule((asked,), 3.6, character=sex.value), frame_rate_hz=RATE_HZ)
    skeleton, frame = realizer.performer(sex.value).skeleton, round(((SYNC.stroke_end or 0) + SETTLED_S) * RATE_HZ)
    at_m, turned = forward(skeleton, motion.body.rotations[frame], motion.body.hips_m[frame])
    hips, arm, elbow, wrist = skeleton.chain("hips", "rightUpperArm", "rightLowerArm", "rightHand")
    down = at_m[elbow] - at_m[arm]
    local = motion.body.rotations[frame]
    fingers = skeleton.chain(*(f"right{name}Intermediate" for name in ("Index", "Middle", "Ring", "Little")))
    return Pose(
        elbow_deg=float(np.degrees(np.arctan2(-down[0], -down[1]))),
        out_m=float(at_m[arm][0] - at_m[wrist][0]),
        up_m=float(at_m[wrist][1] - at_m[hips][1]),
        wrist_deg=float(np.degrees(2 * np.arcsin(-local[wrist][2]))),
        fingers_deg=float(np.degrees(2 * np.arcsin(np.abs(local[fingers][:, 2]))).mean()),
        wrist_m=at_m[wrist] - at_m[hips],
        hand=rotate(turned[wrist], np.array([-1.0, 0.0, 0.0])),
    )


def apart(one: Pose, other: Pose) -> bool:
    """Whether two poses are seen to differ."""
    turned_deg = np.degrees(np.arccos(np.clip(one.hand @ other.hand, -1.0, 1.0)))
    return bool(np.linalg.norm(one.wrist_m - other.wrist_m) >= APART_M or turned_deg >= APART_DEG)


def swayed_cm(realizer: Realizer, sex: Sex) -> float:
    """How far the hips of a talker without gestures go to the sides."""
    phrases = tuple(Interval(start_s, start_s + 2.5) for start_s in np.arange(0.5, STANDS_S - 3, 3.0))
    schedule = Schedule((), STANDS_S, character=sex.value, phrases=phrases)
    return float(100 * realize(realizer, schedule, frame_rate_hz=RATE_HZ).body.hips_m[:, 0].std())


if __name__ == "__main__":
    main()

"""Whether bodies show what sentences say of places, heights, sizes and numbers, and wave, at each level of agitation.

    python -m benchmarks.realizer.gestures.shown_amounts [--seeds N] [--characters NAME …]

Every sentence of `SENTENCES` is performed from its words alone and realized; of the gestures that show what it says,
the one that shows it best counts, `SETTLED_S` after its stroke. Bars are an animator's: a direction up ≥ 20°,
contrasted places ≥ 50° apart and the same thing within 20° of where it was, a child's height below 1.2 m, who is taller
than the speaker above his crown, something tiny between fingertips nearer than 3 cm or palms nearer than 8 cm, fingers
of a number spread ≥ 12°, a wave with two reversals of 10 cm of the fingertips.
"""

import argparse
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations, pairwise, product

import numpy as np

from understudy import say
from understudy.model import Behavior, Channel, FloatArray, Hand, Level, Performance
from understudy.model.slots import Slots
from understudy.models import Understudy
from understudy.realization import PreparedSchedule, realize_prepared
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.settings import Settings

RATE_HZ = 60
SETTLED_S = 0.15
"""When a hand that comes later is there too."""
WAVE_M = 0.10
"""The way of the fingertips in a wave."""
_PAD_M = 0.016
"""Tips of thumb and finger are this far from their last joints, and their pads so thick together."""
_PALM_M = 0.03
"""How much nearer two palms are than the wrists."""
_CROWN_M = 0.19
"""Over the joint of the head, in an average body."""


@dataclass(frozen=True, slots=True)
class Take:
    """A motion with the positions (T, J, 3) of the joints of its skeleton, and its gestures."""

    motion: Motion
    skeleton: Skeleton
    at_m: FloatArray
    gestures: tuple[Behavior, ...]

    @classmethod
    def of(cls, understudy: Understudy, performance: Performance) -> "Take":
        realizer = understudy.realizer
        realized = realize_prepared(realizer, PreparedSchedule.of(performance), frame_rate_hz=RATE_HZ)
        skeleton = realizer.performer(realized.schedule.character).skeleton
        at_m, _turned = forward(skeleton, realized.motion.body.rotations, realized.motion.body.hips_m)
        gestures = (each for each in realized.schedule.behaviors if each.kind is Channel.GESTURE)
        return cls(realized.motion, skeleton, at_m, tuple(gestures))

    def showing(self, said: Callable[[Slots], object]) -> Iterator["Pose"]:
        """The body as each gesture with such slots has ended its stroke."""
        for each in self.gestures:
            ends_s = self.motion.realized[each.id].stroke_end if each.id in self.motion.realized else None
            if each.slots is not None and said(each.slots) and ends_s is not None:
                frame = min(round((ends_s + SETTLED_S) * RATE_HZ), len(self.at_m) - 1)
                yield Pose(self.skeleton, self.at_m[frame], each)


@dataclass(frozen=True, slots=True)
class Pose:
    """The joints (J, 3) of a body that shows what a gesture says."""

    skeleton: Skeleton
    at_m: FloatArray
    gesture: Behavior

    def joint_m(self, name: str) -> FloatArray:
        return np.asarray(self.at_m[self.skeleton.index[name]])

    @property
    def side(self) -> str:
        """The hand that gestures; of both the higher one."""
        if self.gesture.hand in (Hand.LEFT, Hand.RIGHT):
            return str(self.gesture.hand)
        return max(("left", "right"), key=lambda side: float(self.joint_m(f"{side}Hand")[1]))

    def finger(self, name: str = "Index") -> FloatArray:
        way = self.joint_m(f"{self.side}{name}Distal") - self.joint_m(f"{self.side}{name}Proximal")
        return np.asarray(way / np.linalg.norm(way))

    def azimuth_deg(self) -> float:
        """Where the gesturing hand is, seen from the body's middle, to its left."""
        x, _y, z = self.joint_m(f"{self.side}Hand") - self.joint_m("upperChest")
        return float(np.degrees(np.arctan2(x, z)))


def pointed_deg(take: Take) -> float:
    """How far up the index finger points."""
    poses = take.showing(lambda slots: (slots.elevation_deg or 0) > 0)
    return max((float(np.degrees(np.arcsin(pose.finger()[1]))) for pose in poses), default=np.nan)


def apart_deg(take: Take) -> float:
    """The greatest angle between two places."""
    azimuths = [pose.azimuth_deg() for pose in take.showing(_of_a_place)]
    return max((abs(one - other) for one, other in combinations(azimuths, 2)), default=np.nan)


def strayed_deg(take: Take) -> float:
    """How far a thing is shown from where it was shown before."""
    by_thing: dict[str, list[float]] = {}
    for pose in take.showing(lambda slots: slots.referent):
        by_thing.setdefault(str(pose.gesture.slots and pose.gesture.slots.referent), []).append(pose.azimuth_deg())
    return max((abs(one - other) for own in by_thing.values() for one, other in pairwise(own)), default=np.nan)


def _of_a_place(slots: Slots) -> bool:
    return any((slots.side, slots.distance, slots.which, slots.referent))


def palm_m(take: Take) -> float:
    """The height of the palm that shows one, lowest of all gestures."""
    poses = take.showing(lambda slots: slots.height_m is not None)
    return min((float(pose.joint_m(f"{pose.side}MiddleProximal")[1]) for pose in poses), default=np.nan)


def over_crown_m(take: Take) -> float:
    """How far the palm is above the crown."""
    poses = take.showing(lambda slots: slots.height_m is not None)
    highest = (pose.joint_m(f"{pose.side}MiddleProximal")[1] - pose.joint_m("head")[1] - _CROWN_M for pose in poses)
    return max(map(float, highest), default=np.nan)


def tiny_m(take: Take) -> float:
    """What is left between two fingertips or palms; palms count three eighths, as their bar is 8 cm and not 3."""
    found = []
    for pose in take.showing(lambda slots: slots.size_m is not None):
        tips = pose.joint_m(f"{pose.side}ThumbDistal") - pose.joint_m(f"{pose.side}IndexDistal")
        palms = pose.joint_m("leftHand") - pose.joint_m("rightHand")
        both = 3 / 8 * (float(np.linalg.norm(palms)) - _PALM_M)
        found.append(both if pose.gesture.hand is Hand.BOTH else min(float(np.linalg.norm(tips)) - _PAD_M, both))
    return min(found, default=np.nan)


def spread_deg(take: Take) -> float:
    """The least angle between neighbouring fingers of a number."""
    found = []
    for pose in take.showing(lambda slots: (slots.count or 0) > 1):
        names = ("Index", "Middle", "Ring", "Little")[: pose.gesture.slots.count if pose.gesture.slots else 0]
        ways = [pose.finger(name) for name in names]
        found.append(min(float(np.degrees(np.arccos(np.clip(a @ b, -1, 1)))) for a, b in pairwise(ways)))
    return max(found, default=np.nan)


def reversals(take: Take) -> float:
    """How often the fingertips of a raised hand go back after a way of `WAVE_M`; nothing of hands opened in welcome."""
    found = []
    for each in take.gestures:
        sync = take.motion.realized[each.id]
        waves = each.lexeme in ("GREETING", "FAREWELL") and each.hand is not Hand.BOTH  # both are opened in welcome
        if waves and sync.stroke_start is not None and sync.relax is not None:
            rows = slice(round(sync.stroke_start * RATE_HZ), round((sync.relax + 0.1) * RATE_HZ))
            tips = take.skeleton.chain("leftMiddleDistal", "rightMiddleDistal")
            found += [swings(take.at_m[rows, tip, 0]) - 1 for tip in tips]
    return max(found, default=np.nan)


def swings(aside_m: FloatArray, least_m: float = WAVE_M) -> int:
    """How many ways of at least that length a curve goes to and fro."""
    found, from_m, to_m = 0, aside_m[0], aside_m[0]
    for value in aside_m:
        if (value - to_m) * (to_m - from_m) >= 0:
            to_m = value
        elif abs(value - to_m) >= least_m / 2:
            found += abs(to_m - from_m) >= least_m
            from_m, to_m = to_m, value
    return found + int(abs(to_m - from_m) >= least_m)


@dataclass(frozen=True, slots=True)
class Bar:
    """What is measured of a motion, and from or up to where it is right."""

    measure: Callable[[Take], float]
    limit: float
    at_most: bool = False

    def met(self, value: float) -> bool:
        return value <= self.limit if self.at_most else value >= self.limit


BARS: Mapping[str, Bar] = {
    "up there, degrees": Bar(pointed_deg, 20.0),
    "contrasted places, degrees": Bar(apart_deg, 50.0),
    "the same place, degrees": Bar(strayed_deg, 20.0, at_most=True),
    "a child, m": Bar(palm_m, 1.2, at_most=True),
    "over the crown, m": Bar(over_crown_m, 0.0),
    "tiny, m between fingers": Bar(tiny_m, 0.03, at_most=True),
    "fingers apart, degrees": Bar(spread_deg, 12.0),
    "reversals of a wave": Bar(reversals, 2.0),
}

SENTENCES: Mapping[str, tuple[str, ...]] = {
    "up there, degrees": (
        "There is an eagle way up there, above the cliffs.",
        "Look, they hung the lantern up there under the roof.",
        "She lives up there, on the very top floor.",
        "Can you see the smoke up there in the sky?",
    ),
    "contrasted places, degrees": (
        "The spears go on this wall, the shields over there.",
        "On the one hand we are safe here, on the other hand we starve.",
        "Put the barrels on the left and the sacks on the right.",
        "You take this door, and I take that one.",
        "This one is mine, and that one is yours.",
    ),
    "the same place, degrees": (
        "That door is locked. Nobody has ever opened that door.",
        "See that tower over there? The king was born in that tower.",
        "The bridge over there is old. I would never cross that bridge.",
    ),
    "a child, m": (
        "The last time we met you were only this tall.",
        "My daughter was this high when we moved here.",
        "When he was a little boy, he was this tall.",
    ),
    "over the crown, m": (
        "Your brother is taller than me now!",
        "Look at her, she is even taller than I am.",
        "The guard was a giant, much taller than me.",
    ),
    "tiny, m between fingers": (
        "There was only a tiny crack in the glass.",
        "I saw a tiny light, far below us.",
        "It is just a tiny little scratch.",
    ),
    "fingers apart, degrees": (
        "We have three ships left.",
        "I have told you twice already.",
        "There were four of them in the hall.",
        "Two men went in, and nobody came out.",
    ),
    "reversals of a wave": (
        "Hello there! Come on in.",
        "Goodbye, my friends, and take care!",
        "Hi, everybody!",
    ),
}


@dataclass(frozen=True, slots=True)
class Case:
    """A sentence, and who says it how."""

    text: str
    level: Level
    seed: int
    character: str


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--seeds", type=int, default=1)
    arguments.add_argument("--characters", nargs="+", default=["default"])
    options = arguments.parse_args()
    with Understudy.load(Settings()) as understudy:
        for name, sentences in SENTENCES.items():
            cases = [Case(*each) for each in product(sentences, Level, range(options.seeds), options.characters)]
            report(name, {case: BARS[name].measure(performed(understudy, case)) for case in cases})


def performed(understudy: Understudy, case: Case) -> Take:
    """A sentence from its words alone."""
    said = say(understudy, case.text, agitation=case.level, seed=case.seed, character=case.character)
    return Take.of(understudy, said)


def report(name: str, found: Mapping[Case, float]) -> None:
    bar = BARS[name]
    good, shown = sum(map(bar.met, found.values())), sum(not np.isnan(value) for value in found.values())
    print(
        f"{name:28} {'<=' if bar.at_most else '>='} {bar.limit:g}: {good} of {shown}, of {len(found)} asked for",
        flush=True,
    )
    for case, value in found.items():
        if not bar.met(value) and not np.isnan(value):
            print(f"    {value:6.2f} {case.character} {case.level} {case.seed} {case.text}", flush=True)


if __name__ == "__main__":
    main()

"""How curved the strokes of a profile's gestures are.

    python -m benchmarks.profiles.arcs

The six recorded lines by both example profiles, realized as they are and with every stroke as the library has it. Of
the gestures that the profile has curved: how far the leading wrist is beside the straight line from where its stroke
starts to where it ends, at most, as a share of the line (of a half circle .5), and how much its place at both differs.
Strokes shorter than 5 cm are not counted.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from benchmarks.realizer.liveliness import recorded_lines
from understudy.model import FloatArray, Hand, Schedule
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import realize, schedule_of
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import forward
from understudy.realizer.realizing import Realizer
from understudy.settings import Settings

PROFILES = ("sweeping", "sparing")
SHORTEST_M = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class Bend:
    """How far a stroke is beside its line, curved and as the library has it, and how far its ends moved, metres."""

    curved: float
    plain: float
    ends_m: float


def main() -> None:
    with Understudy.load(Settings()) as understudy:
        for profile in PROFILES:
            bends: list[Bend] = []
            for line in recorded_lines().values():
                schedule = schedule_of(perform(understudy, line, Options(profile=profile)))
                bends += bends_of(understudy.realizer, schedule)
            middle = np.median([(bend.curved, bend.plain, bend.ends_m) for bend in bends], axis=0)
            print(
                f"{profile}: {len(bends)} curved strokes, beside their line by {middle[0]:.2f} of it (median), as the "
                f"library has them {middle[1]:.2f}; ends moved by {100 * middle[2]:.1f} cm"
            )


def bends_of(realizer: Realizer, schedule: Schedule) -> Iterator[Bend]:
    """The bends of a schedule's curved strokes."""
    plain = replace(schedule, behaviors=tuple(replace(each, curved=False) for each in schedule.behaviors))
    curved_motion, plain_motion = realize(realizer, schedule), realize(realizer, plain)
    for behavior in schedule.behaviors:
        if behavior.curved and behavior.id in curved_motion.realized:
            sync = curved_motion.realized[behavior.id]
            begins_s, ends_s = sync.stroke_start or 0.0, sync.stroke_end or 0.0
            frames = slice(round(60 * begins_s), round(60 * ends_s) + 1)
            side = "left" if behavior.hand is Hand.LEFT else "right"
            ways = [
                wrists_m(realizer, schedule.character, each, side)[frames] for each in (curved_motion, plain_motion)
            ]
            if len(ways[0]) > 2 and np.linalg.norm(ways[1][-1] - ways[1][0]) > SHORTEST_M:
                ends_m = float(np.linalg.norm((ways[0] - ways[1])[[0, -1]], axis=1).max())
                yield Bend(beside(ways[0]), beside(ways[1]), ends_m)


def beside(way_m: FloatArray) -> float:
    """How far a way (T, 3) is at most from the line between its ends, as a share of that line."""
    line_m = way_m[-1] - way_m[0]
    along = line_m / np.linalg.norm(line_m)
    from_start_m = way_m - way_m[0]
    across_m = from_start_m - (from_start_m @ along)[:, None] * along
    return float(np.linalg.norm(across_m, axis=1).max() / np.linalg.norm(line_m))


def wrists_m(realizer: Realizer, character: str, motion: Motion, side: str) -> FloatArray:
    """Where a wrist is (T, 3), from the hips."""
    skeleton = realizer.performer(character).skeleton
    positions, _turned = forward(skeleton, motion.body.rotations, np.zeros_like(motion.body.hips_m))
    return np.asarray(positions[:, skeleton.index[f"{side}Hand"]])


if __name__ == "__main__":
    main()

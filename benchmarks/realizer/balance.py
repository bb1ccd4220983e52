"""Whether the centre of mass stays over the feet without physics.

    python -m benchmarks.realizer.balance [--every N] [--characters NAME …]

Every line of `benchmarks.realizer.liveliness` by each character at 60 frames a second. The support polygon is the
convex hull of the soles, as in `app/realizer/physics/physical_body.py`; the margin is the distance of the centre of
mass (de Leva's segment masses) from its nearest edge, negative outside. How far the centre goes forward is measured
in the frames in which a hand is farther from the body than .35 m, against those in which both are nearer than .25 m.
"""

import argparse

import numpy as np
from scipy.spatial import ConvexHull

from benchmarks.realizer.liveliness import recorded_lines
from understudy.model import FloatArray
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import realize, schedule_of
from understudy.realizer.body.masses import centre_of_mass_m
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import rotate
from understudy.realizer.physics.physical_body import FEET
from understudy.settings import Settings

CORNERS_M: FloatArray = np.array([[x, 0.0, z] for x in (-0.045, 0.045) for z in (-0.06, 0.20)])
"""Of a sole, in the foot's space."""

HANDS = ("leftHand", "rightHand")


FAR_M, NEAR_M = 0.35, 0.25


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--every", type=int, default=1)
    arguments.add_argument("--characters", nargs="+", default=["default", "expansive", "formal_elder", "reserved"])
    options = arguments.parse_args()
    with Understudy.load(Settings()) as understudy:
        for character in options.characters:
            skeleton = understudy.realizer.performer(character).skeleton
            lines = list(recorded_lines().values())[:: options.every]
            moved = [schedule_of(perform(understudy, line, Options(character=character))) for line in lines]
            bodies = [realize(understudy.realizer, schedule).body for schedule in moved]
            report(character, len(lines), np.concatenate([margin_m(skeleton, body) for body in bodies]))
            found_m = np.concatenate([reach_and_centre_m(skeleton, body) for body in bodies])
            far_m, near_m = found_m[found_m[:, 0] > FAR_M, 1], found_m[found_m[:, 0] < NEAR_M, 1]
            if len(far_m) and len(near_m):
                print(f"  hands far away carry the centre {1000 * (far_m.mean() - near_m.mean()):.1f} mm forward")
            else:
                print("  hands are never far away, or always")


def report(character: str, lines: int, margins_m: FloatArray) -> None:
    least, low, middle = 100 * np.percentile(margins_m, (0, 5, 50))
    outside = 100 * float(np.mean(margins_m < 0))
    print(f"{character}: {lines} lines, {len(margins_m)} frames, {outside:.2f} % outside the soles' hull")
    print(f"  margin, cm: median {middle:.1f}, p5 {low:.1f}, least {least:.1f}")


def margin_m(skeleton: Skeleton, body: BodyMotion) -> FloatArray:
    """The margin (T,) of the centre of mass; feet do not move."""
    places_m, turned = forward(skeleton, body.rotations, body.hips_m)
    corners_m = [
        places_m[0, foot] + rotate(turned[0, foot], skeleton.proportions.scale * CORNERS_M)
        for foot in skeleton.chain(*FEET)
    ]
    edges = ConvexHull(np.concatenate(corners_m)[:, [0, 2]]).equations
    centres_m = centre_of_mass_m(skeleton, places_m, turned)[:, [0, 2]]
    return np.asarray(-(centres_m @ edges[:, :2].T + edges[:, 2]).max(axis=1))


def reach_and_centre_m(skeleton: Skeleton, body: BodyMotion) -> FloatArray:
    """How far the farther wrist is before the hips, and the centre of mass before the world's middle (T, 2)."""
    places_m, turned = forward(skeleton, body.rotations, body.hips_m)
    reach_m = (places_m[:, skeleton.chain(*HANDS), 2] - body.hips_m[:, 2:]).max(axis=1)
    return np.stack([reach_m, centre_of_mass_m(skeleton, places_m, turned)[:, 2]], axis=1)


if __name__ == "__main__":
    main()

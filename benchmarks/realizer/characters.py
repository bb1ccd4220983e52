"""Validity of every character's body: its size, hands outside it, joints within limits, feet on the floor.

    python -m benchmarks.realizer.characters [--sentences N] [--node-modules FOLDER]

Each character of the lexicon, and bodies at the ends of the ranges that docs/characters.md allows, realize the same N
spoken sentences of GUM (`benchmarks.bml.schedule`). "Tall" and "sole" are the mannequin's highest and lowest point in
the T-pose; "inside" is the deepest that a hand or forearm ever is in the body or the other arm, "limits" the frames in
which a joint is beyond its limit, "feet" how far an ankle ever moves from where it stands, "short" the share of the
library's key poses whose wrist stays more than 3 cm from its place around this body. With node and `npm install
gltf-validator three` in FOLDER, the GLB is judged by Khronos' validator, and the joints in the GLB and the BVH by
three.js (`benchmarks.realizer.exporting.formats`).
"""

import argparse
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np

from benchmarks.bml.schedule import Stages, performed, spoken_sentences
from benchmarks.realizer.exporting.formats import judge
from understudy.files import resource_folder
from understudy.model import Hand, Level, Schedule
from understudy.model.figure import PLAIN, Figure, Physique, Sex
from understudy.models import load_characters, load_gestures
from understudy.realization import Realizer, realize, schedule_of
from understudy.realizer.arms.posing import pose_arm
from understudy.realizer.body.body_space import on_body_m
from understudy.realizer.body.contacts import penetrations_m
from understudy.realizer.body.limits import violations
from understudy.realizer.body.skeleton import forward
from understudy.realizer.gestures.gesture_space import sector_m
from understudy.realizer.gestures.library import clip
from understudy.realizer.mannequin.skinning import Mannequin
from understudy.realizer.realizing import RealizedCharacter

EXTREMES: Mapping[str, Physique] = {
    "small_slim": Physique(Sex.FEMALE, 30, 1.45, 0.85, 0.85, 0.85),
    "small_stout": Physique(Sex.FEMALE, 30, 1.45, 1.4, 1.0, 1.2),
    "tall_slim": Physique(Sex.MALE, 30, 2.05, 0.85, 1.0, 0.85),
    "tall_stout": Physique(Sex.MALE, 100, 2.05, 1.4, 1.2, 1.2),
}
SHORT_M = 0.03
MM, PERCENT = 1000.0, 100.0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sentences", type=int, default=40)
    parser.add_argument("--node-modules", type=Path, help="where gltf-validator and three are")
    given = parser.parse_args()
    figures: dict[str, Figure] = {each.name: each.figure for each in load_characters().by_name.values()}
    figures |= {name: replace(PLAIN, physique=physique) for name, physique in EXTREMES.items()}
    realizer = Realizer.with_library(load_gestures(), resource_folder("lexicon"), figures)
    stages = Stages.load("default")
    texts = [text for text in islice(spoken_sentences(), 4 * given.sentences) if len(text.split()) > 3]
    performances = [performed(stages, text, seed=0) for text in texts[: given.sentences]]
    for name, performer in realizer.performers.items():
        schedules = [schedule_of(replace(each, character=name)) for each in performances]
        print(f"{name:13s}", *_size(performer), *_motion(realizer, name, schedules), _short(performer), sep="  ")
    if given.node_modules:
        for name, performer in realizer.performers.items():
            print(name)
            judge(given.node_modules.resolve(), realizer.rigs, performer.skeleton, performer.looks)


def _size(performer: RealizedCharacter) -> Iterator[str]:
    mannequin = Mannequin.around(performer.skeleton, performer.looks)
    heights_m = np.concatenate([part.surface.positions_m[:, 1] for part in mannequin.parts])
    asked_m = performer.skeleton.proportions.physique.height_m
    yield f"tall {heights_m.max():.3f} m (asked {asked_m:.2f})"
    yield f"sole {MM * heights_m.min():.0f} mm"


def _motion(realizer: Realizer, name: str, schedules: Sequence[Schedule]) -> Iterator[str]:
    skeleton = realizer.performer(name).skeleton
    inside_m, beyond, moved_m, frames = 0.0, 0, 0.0, 0
    for schedule in schedules:
        body = realize(realizer, schedule, frame_rate_hz=30).body
        inside_m = max(inside_m, float(penetrations_m(skeleton, body.rotations, body.hips_m).max()))
        beyond += int(np.count_nonzero(violations(skeleton, body.rotations).any(axis=-1)))
        places_m, _turned = forward(skeleton, body.rotations, body.hips_m)
        ankles_m = places_m[:, skeleton.chain("leftFoot", "rightFoot")]
        moved_m = max(moved_m, float(np.linalg.norm(ankles_m - ankles_m[:1], axis=-1).max()))
        frames += len(body.times_s)
    yield f"inside {MM * inside_m:.1f} mm"
    yield f"limits {beyond} of {frames}"
    yield f"feet {MM * moved_m:.2f} mm"


def _short(performer: RealizedCharacter) -> str:
    missed = asked = 0
    for definition in performer.library.definitions:
        if Level.MEDIUM not in definition.levels:
            continue
        made = clip(definition, Level.MEDIUM, definition.hand or Hand.RIGHT, definition.categories[0])
        for key in made.keys:
            said = key.right or key.left
            if said is None or said.place is None or said.joints:
                continue
            pose = pose_arm(performer.skeleton, Hand.LEFT, said, amplitude=made.expressivity.amplitude)
            place_m = on_body_m(performer.skeleton, sector_m(said.place, made.expressivity.amplitude))
            asked += 1
            missed += pose.wrist_m is not None and float(np.linalg.norm(pose.wrist_m - place_m)) > SHORT_M
    return f"short {PERCENT * missed / asked:.1f} %"


if __name__ == "__main__":
    main()

"""All gestures as silhouettes at the end of their strokes, and the pairs of different meaning that look alike.

    python -m benchmarks.realizer.gestures.silhouettes [--level LEVEL] [--output SHEET.png] [--record]

Gestures mean the same if they share a category, or a family of lexicon/acting/families.yaml; what looks alike is in
`likeness.py`. The sheet needs matplotlib (`understudy[plot]`).
"""

import argparse
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

import yaml

from benchmarks.figures import add_record_option, record
from benchmarks.realizer.gestures.likeness import Likeness, StrokePose, draw_silhouettes, likenesses, stroke_pose
from understudy.files import resource_folder
from understudy.model import Hand, Level
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.gestures.gesture import Definition
from understudy.realizer.gestures.library import Library, clip

LEXICON = resource_folder("lexicon")


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--level", type=Level, choices=list(Level), default=Level.MEDIUM)
    arguments.add_argument("--output", type=Path)
    add_record_option(arguments)
    options = arguments.parse_args()
    library = Library.load(LEXICON / "gestures")
    poses = stroke_poses(library, options.level)
    found = [each for each in likenesses(poses) if mean_different_things(library, each)]
    twins = [each for each in found if each.twins]
    print(f"{len(poses)} gestures; {len(found)} pairs of different meaning look alike, {len(twins)} from the start on")
    for each in sorted(twins, key=lambda pair: pair.apart_m):
        print(f"{100 * each.apart_m:5.1f} cm {each.apart_deg:3.0f} degrees  {each.one}, {each.other}")
    if options.record:
        record("bodies", "gestures of different meaning that look alike, pairs", len(found))
        record("bodies", "gestures of different meaning that look alike from the start on, pairs", len(twins))
    if options.output:
        options.output.write_bytes(draw_silhouettes(Skeleton.standing(), poses, columns=16))


def stroke_poses(library: Library, level: Level) -> list[StrokePose]:
    """Of every gesture that is for the level; those of either hand by the right one."""
    skeleton = Skeleton.standing()
    fit = (each for each in library.definitions if level in each.levels)
    return [stroke_pose(skeleton, clip(each, level, each.hand or Hand.RIGHT, each.categories[0])) for each in fit]


def mean_different_things(library: Library, pair: Likeness) -> bool:
    """Whether the two share neither a category nor a family."""
    families = families_of()
    one, other = (_meanings(library.definition(name), families) for name in (pair.one, pair.other))
    return not one & other


def _meanings(definition: Definition, families: Mapping[str, frozenset[str]]) -> set[str]:
    own = set(definition.categories)
    return own.union(*(families.get(category, frozenset()) for category in own))


@cache
def families_of() -> dict[str, frozenset[str]]:
    """The families in which each category stands."""
    table = yaml.safe_load((LEXICON / "behaviors.yaml").read_text())
    entries = table.get("behaviors", table)
    found: dict[str, set[str]] = {}
    for family, behavior in _behaviors():
        entry = entries.get(behavior)
        if isinstance(entry, dict) and "lexeme" in entry:
            found.setdefault(entry["lexeme"], set()).add(f"family {family}")
    return {category: frozenset(families) for category, families in found.items()}


def _behaviors() -> Iterator[tuple[str, str]]:
    """Each gesture family with each of its behaviours."""
    families = yaml.safe_load((LEXICON / "acting" / "families.yaml").read_text())["gesture"]
    for family, behaviors in families.items():
        for each in behaviors:
            yield family, each["behavior"] if isinstance(each, dict) else each


if __name__ == "__main__":
    main()

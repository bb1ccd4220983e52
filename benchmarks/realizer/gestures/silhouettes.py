"""All gestures as silhouettes at the end of their strokes, and the pairs of different meaning that look alike.

    python -m benchmarks.realizer.gestures.silhouettes [--level LEVEL] [--all] [--output SHEET.png] [--record]

Gestures mean the same if they share a category, or a family of lexicon/acting/families.yaml; what looks alike is in
`likeness.py`. A pair is mixed up unless its meanings are near kin or one of it is a beat (kin.yaml): only then is
somebody misled. Mirror images and the levels of agitation of one gesture are never a pair. The pairs among the
commonest gestures (commonest.yaml) come first; then twins, which look alike from the start of the stroke on, or with
`--all` all pairs. The sheet needs matplotlib (`understudy[plot]`).
"""

import argparse
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path

import yaml

from benchmarks.figures import add_record_option, record
from benchmarks.realizer.gestures.commonest import commonest
from benchmarks.realizer.gestures.likeness import Likeness, StrokePose, draw_silhouettes, likenesses, stroke_pose
from understudy.files import resource_folder
from understudy.model import Hand, Level
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.gestures.gesture import Definition
from understudy.realizer.gestures.library import Library, clip

LEXICON = resource_folder("lexicon")
KIN = Path(__file__).with_name("kin.yaml")


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--level", type=Level, choices=list(Level), default=Level.MEDIUM)
    arguments.add_argument("--all", action="store_true")
    arguments.add_argument("--output", type=Path)
    add_record_option(arguments)
    options = arguments.parse_args()
    library = Library.load(LEXICON / "gestures")
    poses = stroke_poses(library, options.level)
    found = pairs_of(library, poses)
    report(library, found, options.level, every=options.all)
    if options.record:
        record_figures(library, found)
    if options.output:
        options.output.write_bytes(draw_silhouettes(Skeleton.standing(), poses, columns=16))


def report(library: Library, found: Sequence[Likeness], level: Level, *, every: bool) -> None:
    twins, misled = [each for each in found if each.twins], [each for each in found if mixed_up(library, each)]
    print(f"{level}: {len(found)} pairs of different meaning look alike, {len(twins)} from the start on;")
    print(f"{len(misled)} would be mixed up, {sum(each.twins for each in misled)} from the start on")
    print_pairs("among the commonest", [each for each in found if of_the_commonest(each)])
    print_pairs("all" if every else "from the start on", found if every else twins)


def print_pairs(what: str, pairs: Sequence[Likeness]) -> None:
    print(f"{what}: {len(pairs)}")
    for each in sorted(pairs, key=lambda pair: pair.apart_m):
        print(f"{100 * each.apart_m:5.1f} cm {each.apart_deg:3.0f} degrees  {each.one}, {each.other}")


def record_figures(library: Library, found: Sequence[Likeness]) -> None:
    misled = [each for each in found if mixed_up(library, each)]
    twins, common = [each for each in found if each.twins], [each for each in found if of_the_commonest(each)]
    record("bodies", "gestures of different meaning that look alike, pairs", len(found))
    record("bodies", "gestures of different meaning that look alike from the start on, pairs", len(twins))
    record("bodies", "gestures that would be mixed up (neither near kin nor a beat), pairs", len(misled))
    record("bodies", "gestures that look alike among the 60 commonest, pairs", len(common))


def stroke_poses(library: Library, level: Level) -> list[StrokePose]:
    """Of every gesture that is for the level; those of either hand by the right one."""
    skeleton = Skeleton.standing()
    fit = (each for each in library.definitions if level in each.levels)
    return [stroke_pose(skeleton, clip(each, level, each.hand or Hand.RIGHT, each.categories[0])) for each in fit]


def pairs_of(library: Library, poses: Sequence[StrokePose]) -> list[Likeness]:
    """The pairs of different meaning that look alike."""
    return [each for each in likenesses(poses) if mean_different_things(library, each)]


def of_the_commonest(pair: Likeness) -> bool:
    """Whether both are among the commonest gestures."""
    return {pair.one, pair.other} <= commonest().keys()


def mean_different_things(library: Library, pair: Likeness) -> bool:
    """Whether the two share neither a category nor a family."""
    families = families_of()
    one, other = (_meanings(library.definition(name), families) for name in (pair.one, pair.other))
    return not one & other


def mixed_up(library: Library, pair: Likeness) -> bool:
    """Whether somebody who takes the one for the other is misled."""
    table = _kin()
    one, other = (set(library.definition(name).categories) for name in (pair.one, pair.other))
    beats = set(table["beats"])
    return not (one | other) & beats and not any(one & set(group) and other & set(group) for group in table["kin"])


@cache
def _kin() -> Mapping[str, list[list[str]]]:
    found: Mapping[str, list[list[str]]] = yaml.safe_load(KIN.read_text())
    return found


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

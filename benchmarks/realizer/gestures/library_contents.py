"""Contents of the gesture library and time to load it.

    python -m benchmarks.realizer.gestures.library_contents

Counts of categories, definitions and clips at each level of agitation by each hand; the mean speeds of strokes; the
median time of loading the library and of asking for the clips of a category, in milliseconds of processor time.
"""

import statistics
import time
from collections.abc import Callable, Iterable

import numpy as np

from understudy.authoring.catalogue import load_gestures
from understudy.files import resource_folder
from understudy.model import Hand, Level
from understudy.realizer.gestures.gesture import Clip
from understudy.realizer.gestures.library import Library

RUNS = 7
MILLISECONDS = 1000.0


def main() -> None:
    library = load_gestures()
    hands = [(one.hand or "one") for one in library.definitions]
    print(f"{len(library.categories)} categories, {len(library.definitions)} definitions: {_counted(hands)}")
    print(f"classes: {_counted(one.gesture_class for one in library.definitions)}")
    print(f"{len(library.aliases)} lexemes of other BML")
    variants = [len(definitions) for definitions in library.by_category.values()]
    print(f"definitions a category: {_counted(variants)}")
    for level in Level:
        told = (f"{hand} {len(list(_clips(library, level, hand)))}" for hand in Hand)
        print(f"clips at {level} agitation: {', '.join(told)}")
    for level in Level:
        _print_speeds(level, [clip for hand in (Hand.RIGHT, Hand.BOTH) for clip in _clips(library, level, hand)])
    _print_times(library)


def _clips(library: Library, level: Level, hand: Hand) -> Iterable[Clip]:
    return (clip for category in library.categories for clip in library.clips(category, level, hand))


def _print_speeds(level: Level, clips: list[Clip]) -> None:
    speeds = [clip.stroke_speed_m_s for clip in clips]
    lengths = [clip.markers.stroke_end - clip.markers.stroke_start for clip in clips]
    spread = ", ".join(f"p{share} {np.percentile(speeds, share):.2f}" for share in (5, 25, 50, 75, 95))
    print(f"strokes at {level}: {spread} m/s; median {np.median(lengths):.2f} s; {sum(np.array(speeds) == 0)} in place")


def _print_times(library: Library) -> None:
    folder = resource_folder("lexicon") / "gestures"
    print(f"loading: {_median_ms(lambda: Library.load(folder)):.0f} ms")
    asking_ms = _median_ms(lambda: list(_clips(library, Level.MEDIUM, Hand.RIGHT))) / len(library.categories)
    print(f"the clips of a category: {asking_ms:.2f} ms")


def _counted(values: Iterable[object]) -> str:
    listed = [str(value) for value in values]
    return ", ".join(f"{value}: {listed.count(value)}" for value in sorted(set(listed)))


def _median_ms(work: Callable[[], object]) -> float:
    times = []
    for _ in range(RUNS):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return statistics.median(times) * MILLISECONDS


if __name__ == "__main__":
    main()

"""The amount of movement: kept behaviours per second on all channels, by kind and by origin.

    python -m benchmarks.bml.movements [--texts FILE.jsonl] [--character NAME] [--seed N]

FILE has on each line either a "text" or "words" as the directed lines write them, "0:Okay" (default:
../shared/directing/dev-lines.jsonl). Words and times are made as in `benchmarks.bml.schedule`. Visemes are not counted.
"""

import argparse
import json
from collections import Counter
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

from benchmarks.bml.schedule import Outcome, Stages, outcome
from understudy.model import Behavior, Channel
from understudy.model.tables import GAZE_LEXEMES

DIRECTED = Path(__file__).resolve().parents[3] / "shared" / "directing" / "dev-lines.jsonl"

CROWDED_S = 0.6
"""No two blinks begin within this time."""

LONGEST_LOOK_S = 2.0
REPEATED_S = 4.0


def text_of(line: dict[str, Any]) -> str:
    """The text of a line, or its numbered words joined."""
    return str(line["text"]) if "text" in line else " ".join(word.split(":", 1)[1] for word in line["words"])


def kept(line: Outcome) -> Iterator[tuple[Behavior, str]]:
    """The kept behaviours and the class of the function that asked for each, or "itself"."""
    classes = {function.id: f"{function.class_name} {function.subtype}".strip() for function in line.functions}
    for behavior in line.behaviors:
        if behavior.kept:
            asked = f"a moment {behavior.moment}" if behavior.moment else "itself"
            yield behavior, classes.get(behavior.function or "", asked)


def of_kind(line: Outcome, kind: Channel) -> list[Behavior]:
    return [behavior for behavior, _ in kept(line) if behavior.kind is kind]


def crowded_blinks(line: Outcome) -> int:
    blinks = [behavior for behavior in of_kind(line, Channel.EYES) if behavior.lexeme == "BLINK"]
    return sum(later.sync.start - earlier.sync.start < CROWDED_S for earlier, later in pairwise(blinks))


def idle_glances(line: Outcome) -> int:
    """Looks at a target when the gaze is there already."""
    count, at = 0, "listener"
    for gaze in of_kind(line, Channel.GAZE):
        assert gaze.lexeme in GAZE_LEXEMES
        count += gaze.direction is None and gaze.target == at and gaze.sync.start > 0
        if gaze.lexeme == "SHIFT":
            at = gaze.target or at
    return count


def long_looks(line: Outcome) -> int:
    asides = [gaze for gaze in of_kind(line, Channel.GAZE) if gaze.function is None and gaze.direction]
    return sum(gaze.sync.end - gaze.sync.start > LONGEST_LOOK_S for gaze in asides)


def repeated_heads(line: Outcome) -> int:
    """The same head movement twice running, the second within a few seconds and with no other function."""
    classes = {behavior.id: asked for behavior, asked in kept(line)}
    return sum(
        later.lexeme == earlier.lexeme
        and later.sync.start - earlier.sync.start < REPEATED_S
        and (later.moment or classes[later.id]) == (earlier.moment or classes[earlier.id])
        for earlier, later in pairwise(of_kind(line, Channel.HEAD))
    )


FAULTS: tuple[tuple[str, Callable[[Outcome], int]], ...] = (
    ("blinks within .6 s of the last", crowded_blinks),
    ("looks at whom one looks at", idle_glances),
    ("idle looks over 2 s", long_looks),
    ("head movements made twice running", repeated_heads),
)


def report(outcomes: list[Outcome], most: int) -> None:
    seconds = sum(each.duration_s for each in outcomes)
    everything = [entry for each in outcomes for entry in kept(each)]
    by_channel = Counter(behavior.kind for behavior, _ in everything)
    print(f"{len(outcomes)} texts, {seconds / 60:.1f} minutes, {len(everything) / seconds:.2f} movements a second")
    print("a second: " + ", ".join(f"{kind} {count / seconds:.2f}" for kind, count in by_channel.most_common()))
    own = sum(asked == "itself" for _, asked in everything)
    print(f"of these the body's own: {own / seconds:.2f}, asked for: {(len(everything) - own) / seconds:.2f}")
    blinks = sum(behavior.lexeme == "BLINK" for behavior, _ in everything)
    print(f"blinks a minute: {60 * blinks / seconds:.1f}")
    print(", ".join(f"{name}: {sum(map(count, outcomes))}" for name, count in FAULTS))
    spent = Counter(
        (behavior.kind.value, behavior.lexeme, "a moment" if behavior.moment else asked)
        for behavior, asked in everything
    )
    for (kind, lexeme, asked), count in spent.most_common(most):
        print(f"  {count / seconds:.3f} a second  {kind} {lexeme} for {asked}")


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--texts", type=Path, default=DIRECTED)
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--most", type=int, default=40, help="how many of the commonest movements are listed")
    options = arguments.parse_args()
    stages = Stages.load(options.character)
    lines = [json.loads(line) for line in options.texts.read_text(encoding="utf-8").splitlines()]
    report([outcome(stages, text_of(line), options.seed) for line in lines], options.most)


if __name__ == "__main__":
    main()

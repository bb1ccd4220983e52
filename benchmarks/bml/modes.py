"""How often a gesture fits what is said, in the three modes of the paper's study (§5): by meaning, stress and chance.

    python -m benchmarks.bml.modes [--texts FILE.jsonl] [--character NAME] [--seeds N]

FILE has on each line a "text" and its "functions" as people marked them (default: ../shared/data/functions/dev.jsonl).
A marked function is met where a gesture on one of its words is one that the mapping rules offer for its class (Table 2
and its extension). The share of strokes in the first half of their line tells whether a mode spreads them. Head, eyes
and face are the same in all modes and are not counted. Words and times are made as in `benchmarks.bml.schedule`.
"""

import argparse
import json
from collections import defaultdict
from pathlib import Path
from typing import Any

from benchmarks.bml.schedule import TEXTS, Outcome, Stages, outcome
from understudy.model import Behavior, Channel, Mode
from understudy.rules.mapping import MappingRules


def lexemes_by_class(rules: MappingRules, stages: Stages) -> dict[str, set[str]]:
    """The gesture lexemes that the rules offer for each class; rules for any class (`_`) say nothing of one."""
    offered: dict[str, set[str]] = defaultdict(set)
    entries = stages.character.entries
    for rule in rules.program.rules:
        gestures = {entries[name].lexeme for name in rule.calls if entries[name].channel is Channel.GESTURE}
        for mention in rule.joins:
            if mention.predicate == "fcn":
                for class_name in mention.arguments[0].split("|"):
                    offered[class_name] |= gestures
    return offered


def met(marked: dict[str, Any], gestures: list[Behavior], offered: dict[str, set[str]]) -> bool:
    return any(
        gesture.lexeme in offered[marked["class"]]
        and gesture.first <= marked["last"]
        and gesture.last >= marked["first"]
        for gesture in gestures
    )


def kept_gestures(line: Outcome) -> list[Behavior]:
    return [behavior for behavior in line.behaviors if behavior.kept and behavior.kind is Channel.GESTURE]


def early(line: Outcome) -> int:
    """How many gestures strike in the first half of their line."""
    return sum((gesture.sync.stroke or 0.0) < line.duration_s / 2 for gesture in kept_gestures(line))


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--texts", type=Path, default=TEXTS)
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--seeds", type=int, default=5)
    options = arguments.parse_args()
    stages = Stages.load(options.character)
    offered = lexemes_by_class(stages.mapping, stages)
    lines = [json.loads(line) for line in options.texts.read_text(encoding="utf-8").splitlines()]
    shares = {}
    for mode in Mode:
        found = total = strokes = in_first_half = 0
        for seed in range(options.seeds):
            for line in lines:
                performed = outcome(stages, line["text"], seed, mode)
                gestures = kept_gestures(performed)
                found += sum(met(marked, gestures, offered) for marked in line["functions"])
                total += len(line["functions"])
                strokes += len(gestures)
                in_first_half += early(performed)
        shares[mode] = found / total
        print(
            f"{mode:8s} {found} of {total} marked functions met ({100 * found / total:.1f} %), {strokes} gestures, "
            f"{100 * in_first_half / strokes:.0f} % in the first half of their line"
        )
    least = max(min(shares.values()), 1 / total)
    print("ratio " + " : ".join(f"{share / least:.1f}" for share in shares.values()))


if __name__ == "__main__":
    main()

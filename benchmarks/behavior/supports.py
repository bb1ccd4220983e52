"""Which scales of priority and weight choose best: plans of directed lines that the encoder was not trained on.

    python -m benchmarks.behavior.supports LINES.jsonl

LINES have words and one reading each (`more/lines.jsonl` of the directing folder, before it was trained on). For each
pair of scales it prints score.py's F of the planned gestures, without clock and hands, as in `supports.py`'s sum.
"""

import argparse
import json
from collections import Counter
from pathlib import Path
from typing import Any
from unittest import mock

from benchmarks.behavior.directing import load_score
from understudy.behavior.reading import supports
from understudy.behavior.reading.planning import Understood, plan
from understudy.behavior.reading.player import Player
from understudy.library.language import find_functions
from understudy.model import Channel, Function
from understudy.models import BehaviorModels, LanguageModels
from understudy.rules.mapping import offer_movements
from understudy.settings import Settings

SCALES = ((0.0, 0.0), (0.05, 0.25), (0.1, 0.5), (0.05, 0.5), (0.1, 1.0))
"""Of priority and of the logarithm of a weight."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lines", type=Path)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    arguments = parser.parse_args()
    language, behavior = LanguageModels.load(Settings()), BehaviorModels.load(Settings())
    score = load_score(arguments.directing, behavior.families.shows)
    records = score.read(arguments.lines)
    texts = [json.loads(row) for row in arguments.lines.read_text(encoding="utf-8").splitlines()]
    lines = {row["id"]: understood(language, behavior, row["words"]) for row in texts}
    for priority, weight in SCALES:
        with mock.patch.multiple(supports, PRIORITY_SCALE=priority, WEIGHT_SCALE=weight):
            total = sum((judged(score, behavior, lines[name], records[name]) for name in lines), Counter[str]())
        score.show(f"priority {priority}, weight {weight}", total, len(lines))


def understood(language: LanguageModels, behavior: BehaviorModels, words: list[str]) -> Understood:
    """The line with its functions and what the mapping rules offer."""
    analysis = find_functions(language, " ".join(word.split(":", 1)[1] for word in words))
    functions: tuple[Function, ...] = analysis.functions
    offers = offer_movements(behavior.rules, analysis.utterance, functions, seed=0, facts=analysis.facts)
    return Understood(analysis.utterance, functions, analysis.facts, offers)


def judged(score: Any, behavior: BehaviorModels, line: Understood, record: Any) -> Counter[str]:  # noqa: ANN401
    """The counts of a line's planned gestures, each by the likeliest lexeme on its word."""
    found = plan(behavior.planner, line, Player(behavior.families, behavior.characters.named("default").entries))
    names = list(behavior.planner.lexemes)
    made = []
    for moment in found.moments:
        if moment.channel is Channel.GESTURE and found.worths is not None:
            best = names[int(found.worths.log_odds[moment.stroke].argmax())]
            made.append((moment.stroke, score.FAMILIES[best]))
    return Counter(score.judge([record], made))


if __name__ == "__main__":
    main()

"""What changes with the seed and with agitation: other gestures, and how many.

    python -m benchmarks.behavior.takes [--directing FOLDER] [--seeds N]

The 78 lines that three directors read are performed from their recordings with each seed; it prints F of each take by
score.py of that folder, and in how many pairs of takes a line's gestures differ. Then each line is performed as if its
voice had low, medium and high agitation: how many gestures, and the mean over them of the path of the leading wrist in
the stroke and of its peak speed (`manner.py`).
"""

import argparse
import json
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.behavior.directing import READERS, gestures_of, load_score
from benchmarks.behavior.manner import strokes
from benchmarks.figures import add_record_option, record
from understudy.acoustic.stage import hear_manners
from understudy.model import Agitation, Analysis, Channel, Level, Line, Performance
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import analyze, perform_analysis
from understudy.settings import Settings


def gestures(performance: Performance) -> list[str]:
    """The lexemes of the gestures in order of time."""
    return [each.lexeme for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE]


def takes(
    understudy: Understudy,
    analyses: Mapping[str, Analysis],
    score: Any,  # noqa: ANN401
    folder: Path,
    seeds: int,
) -> tuple[float, float]:
    """Prints F of each take, and how often takes differ; returns the mean F and the share of pairs that differ."""
    records = [score.read(folder / name) for name in READERS]
    made = []
    for seed in range(seeds):
        total: Counter[str] = Counter()
        lines = {name: perform_analysis(understudy, each, Options(seed=seed)) for name, each in analyses.items()}
        for name, performance in lines.items():
            total += score.judge([record[name] for record in records], gestures_of(score, performance))
        worth = score.f_of(total["worth"] / total["n"], total["given"] / total["weight"])
        made.append((worth, {name: gestures(performance) for name, performance in lines.items()}))
        print(f"seed {seed}: F {worth:.3f}, {total['n'] / len(lines):.2f} gestures a line")
    differ = [one[name] != other[name] for (_, one), (_, other) in combinations(made, 2) for name in analyses]
    mean, share = sum(worth for worth, _ in made) / seeds, sum(differ) / len(differ)
    print(f"mean F {mean:.3f}; other gestures in {share:.2f}")
    return mean, share


def agitations(understudy: Understudy, analyses: Mapping[str, Analysis]) -> tuple[float, float, float]:
    """Prints the gestures a line, their path, m, and their peak speed, m/s, at each level; returns those of high
    agitation over those of low."""
    found = {}
    for level in Level:
        performances = [perform_analysis(understudy, _with(each, level), Options()) for each in analyses.values()]
        made = sum(len(gestures(each)) for each in performances) / len(performances)
        played = [stroke for each in performances for stroke in strokes(each, understudy.realizer)]
        path_m, peak_m_s = np.mean(played, axis=0).tolist()
        print(f"agitation {level}: {made:.2f} gestures a line, path {path_m:.3f} m, peak {peak_m_s:.2f} m/s")
        found[level] = made, path_m, peak_m_s
    more, farther, faster = (high / low for high, low in zip(found[Level.HIGH], found[Level.LOW], strict=True))
    return more, farther, faster


def _with(analysis: Analysis, level: Level) -> Analysis:
    """The analysis of a voice of this agitation, with movements in its manner."""
    certain = Agitation(**{each.value: float(each is level) for each in Level})
    utterance = replace(analysis.utterance, agitation=certain)
    if analysis.heard and utterance.affect:
        manners = hear_manners(analysis.heard, utterance.words, certain, utterance.affect)
        utterance = replace(utterance, manners=manners)
    return replace(analysis, utterance=utterance)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--seeds", type=int, default=10)
    add_record_option(parser)
    arguments = parser.parse_args()
    folder: Path = arguments.directing
    with Understudy.load(Settings()) as understudy:
        score = load_score(folder, understudy.behavior.families.shows)
        analyses = {}
        for line in map(json.loads, (folder / "dev-lines.jsonl").read_text(encoding="utf-8").splitlines()):
            text = " ".join(word.split(":", 1)[1] for word in line["words"])
            sound = (folder / "audio" / f"{line['id']}.flac").read_bytes()
            analyses[line["id"]] = analyze(understudy, Line(sound, text))
        mean, differ = takes(understudy, analyses, score, folder, arguments.seeds)
        more, farther, faster = agitations(understudy, analyses)
    if arguments.record:
        record("choice", "takes: mean F of ten seeds", mean, bar="≥ 0.56")
        record("choice", "takes: pairs with other gestures", differ, bar="≥ 0.60", aim="≥ 0.75")
        record("choice", "takes: gestures at high agitation over low", more, "×", bar="≥ 1.35")
        record("choice", "takes: path of strokes at high agitation over low", farther, "×", bar="≥ 1.2")
        record("choice", "takes: speed of strokes at high agitation over low", faster, "×", bar="≥ 1.4")


if __name__ == "__main__":
    main()

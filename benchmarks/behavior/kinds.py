"""Agreement with directors on held-out lines of each kind, by the words alone.

    python -m benchmarks.behavior.kinds [--directing FOLDER] [--written 3]

Performs the carefully directed lines that no reader was trained on (`training.acting.directed.is_held_out`; their kinds
were), each word with a usual duration, and scores them with score.py of the folder against the one reading that each
has. With `--written` they are all lines of that series of our own (`training/acting/lines/KIND_3.jsonl`), held out or
not: those that were written after the shipped reader was trained are as new to it.
"""

import argparse
import json
import re
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from benchmarks.behavior.directing import gestures_of, load_score, others_of
from training.acting.directed import DirectedLine, is_held_out, read_lines
from understudy.library.language import find_functions
from understudy.model import Analysis, Interval
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis
from understudy.settings import Settings

WORD_S, CHARACTER_S, PAUSE_S, SILENCE_S = 0.12, 0.045, 0.25, 0.2
"""What a word takes, each of its characters, a pause at punctuation, and the silence at both ends."""


def timed(analysis: Analysis) -> Analysis:
    """The analysis of words alone, with usual times."""
    words, now_s = [], SILENCE_S
    for word in analysis.utterance.words:
        end_s = now_s + WORD_S + CHARACTER_S * len(word.text)
        words.append(replace(word, interval=Interval(now_s, end_s)))
        now_s = end_s + (PAUSE_S if word.text[-1] in ",.;:!?" else 0.0)
    return replace(analysis, utterance=replace(analysis.utterance, words=tuple(words), duration_s=now_s + SILENCE_S))


def measure(directing: Path, series: str) -> None:
    """Performs and scores the lines, and prints the agreement by kind."""
    readings: dict[tuple[str, tuple[str, ...]], list[DirectedLine]] = defaultdict(list)
    for line in read_lines(directing):
        if not line.is_delivery and (_is_of(line, series) if series else is_held_out(line)):
            readings[line.source, line.words].append(line)
    totals: dict[str, Counter[str]] = defaultdict(Counter)
    counts: Counter[str] = Counter()
    with Understudy.load(Settings()) as understudy:
        score = load_score(directing, understudy.behavior.families.shows)
        for (kind, words), lines in readings.items():
            performance = perform_analysis(understudy, timed(find_functions(understudy, " ".join(words))), Options())
            records = _records(score, lines)
            judged = score.judge(records, gestures_of(score, performance))
            judged += score.other_channels(records, *others_of(score, performance))
            for name in ("all", kind):
                totals[name] += judged
                counts[name] += 1
    for name, total in totals.items():
        score.show(f"{name}, {counts[name]} lines", total, counts[name])


def _is_of(line: DirectedLine, series: str) -> bool:
    return re.fullmatch(rf"[a-z]+{re.escape(series)}-\d+", line.name) is not None


def _records(score: Any, lines: Sequence[DirectedLine]) -> list[dict[str, Any]]:  # noqa: ANN401
    """The readings of a line as score.py reads them: pointings are one family."""
    records = json.loads(json.dumps([line.reading for line in lines]))
    for record in records:
        for moment in record["moments"]:
            moment["gesture"] = list(dict.fromkeys(score.SAME.get(each, each) for each in moment.get("gesture") or ()))
        for each in record.get("avoid", ()):
            each["what"] = [score.SAME.get(what, what) for what in each["what"]]
    return list(records)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--written", default="", help="the number of a series of our own lines")
    options = parser.parse_args()
    measure(options.directing, options.written)


if __name__ == "__main__":
    main()

"""Analyses held-out lines as they may be given.

    python -m training.acting.held_out OUT.pkl --plain INDEX.jsonl --deliveries INDEX.jsonl …

Each carefully directed line that the reader was not trained on is given by its words alone and as a synthetic voice
says it plainly (`training/affect/plain_speech.py --held-out`); each delivery as a synthetic voice says it
(`training/focus/speaking.py`). The constants of the choice are chosen on these (`training/acting/constants.py`).
"""

import argparse
import json
import pickle
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from understudy.errors import UnderstudyError
from understudy.library.language import find_functions
from understudy.model import Analysis, Interval, Line
from understudy.models import Understudy
from understudy.performance import analyze
from understudy.settings import Settings

from .cases import DELIVERED, PLAIN, WORDS, Case
from .directed import DirectedLine, is_held_out, read_lines

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


def first_recordings(indexes: Iterable[Path]) -> dict[str, Path]:
    """The first recording of each line, by its name."""
    found: dict[str, Path] = {}
    for index in indexes:
        for row in map(json.loads, index.read_text(encoding="utf-8").splitlines()):
            found.setdefault(row["id"], index.parent / row["path"])
    return found


def cases(understudy: Understudy, lines: Iterable[DirectedLine], recordings: dict[str, Path]) -> Iterator[Case]:
    """The lines as they may be given."""
    for line in lines:
        text = " ".join(line.words)
        if not line.is_delivery:
            yield Case(line, WORDS, timed(find_functions(understudy, text)))
        if line.name not in recordings:
            continue
        try:
            analysis = analyze(understudy, Line(recordings[line.name].read_bytes(), text))
        except UnderstudyError:
            continue
        yield Case(line, DELIVERED if line.is_delivery else PLAIN, replace(analysis, heard=None))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--plain", type=Path, required=True)
    parser.add_argument("--deliveries", type=Path, nargs="+", required=True)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    arguments = parser.parse_args()
    lines = [line for line in read_lines(arguments.directing) if is_held_out(line)]
    recordings = first_recordings([arguments.plain, *arguments.deliveries])
    with Understudy.load(Settings()) as understudy:
        arguments.output.write_bytes(pickle.dumps(list(cases(understudy, lines, recordings))))


if __name__ == "__main__":
    main()

"""Agreement with directors: the bars of the choice of gestures, head movements and faces.

    python -m benchmarks.behavior.directing [--directing FOLDER] [--choice terms|priority] [--character NAME] [--record]
    python -m benchmarks.behavior.directing --notes [--directing FOLDER]
    python -m benchmarks.behavior.directing --held-out READINGS.npz … --terms TERMS.pkl

The first performs the 78 lines that three directors read, from their recordings, and scores them with score.py of that
folder; lexemes that its table does not know stand for what lexicon/acting/families.yaml says. It prints the movements a
second over all channels and the processor time of planning, mapping, scheduling and writing for lines of 15 words.

With --notes each line is performed with each reader's own notes (`perform --direction`) and scored against that reader
alone; beside it what is possible, a gesture of his first choice on the word of each of his strokes.

The last scores plans, without clock and hands, on the lines of directed.jsonl, each read by an encoder trained
without its dialogue (as the first one shipped was, by `training.acting.encoder read --fold K` of its time) and weighed
by weights fitted to the other folds; by source too.
"""

import argparse
import importlib.util
import json
import os
import pickle
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.behavior.agreement import Bars, agreement, record_all
from benchmarks.figures import add_record_option
from training.acting.directed import FAMILIES, DirectedLine, folds_of, gesture_choices, read_lines
from training.acting.thresholds import read_readings
from training.acting.weights import examples_of, fitted, lexeme_worths, price_of
from understudy.behavior.reading.strokes import strokes
from understudy.behavior.reading.word_times import usual_times_s
from understudy.bml.writing.writer import write_bml
from understudy.model import Analysis, Channel, Line, Performance, SingleArray, Word
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import analyze, perform_analysis
from understudy.schemas.direction import read_direction
from understudy.settings import Settings

BARS: Bars = {
    "F": ("≥ 0.64", "≥ 0.70"),
    "accepted F": ("≥ 0.86", "≥ 0.92"),
    "forbidden": ("≤ 0.012", "≤ 0.01"),
    "strokes within a word, F": (None, None),
    "gestures a line": ("≥ 2.0", "≤ 2.5"),
    "head done": ("≥ 0.78", "≥ 0.85"),
    "face done": ("≥ 0.76", "≥ 0.85"),
    "tones right": ("≥ 0.82", "≥ 0.9"),
}

READERS = ("dev-a.jsonl", "dev-b.jsonl", "dev-c.jsonl")
AFTER_STROKE_S = 0.06
"""score.py takes the word that is spoken this long after a stroke has ended for the stroke's."""


def load_score(folder: Path, shows: Mapping[str, Sequence[str]]) -> Any:  # noqa: ANN401 - a module found at run time
    """score.py as a module, with what our own lexemes show beside what its table says."""
    specification = importlib.util.spec_from_file_location("score", folder / "score.py")
    assert specification is not None
    assert specification.loader is not None
    score = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(score)
    for lexeme, families in shows.items():
        merged = [score.SAME.get(family, family) for family in families]
        score.FAMILIES.setdefault(lexeme, list(dict.fromkeys(merged)))
    return score


def gestures_of(score: Any, performance: Performance) -> list[tuple[int, list[str]]]:  # noqa: ANN401
    """The stroke's word and the families of each gesture, as score.py reads them from a trace."""
    timed = [_timed(word) for word in performance.utterance.words if word.interval]
    found = []
    for behavior in performance.behaviors:
        if behavior.kept and behavior.kind is Channel.GESTURE:
            end_s = behavior.sync.stroke_end if behavior.sync.stroke_end is not None else behavior.sync.start
            families = score.FAMILIES.get(behavior.lexeme, [behavior.lexeme.lower()])
            found.append((score.word_at(timed, end_s + AFTER_STROKE_S), families))
    return found


def others_of(score: Any, performance: Performance) -> tuple[list[Any], list[Any]]:  # noqa: ANN401
    """Head movements with a rule and faces: first word, last word, kinds."""
    kept = [behavior for behavior in performance.behaviors if behavior.kept]
    head = [
        (each.first, each.last, score.HEAD.get(each.lexeme, set()))
        for each in kept
        if each.kind is Channel.HEAD and each.rule is not None
    ]
    face = [(each.first, each.last, score.FACE.get(each.lexeme, set())) for each in kept if each.kind is Channel.FACE]
    return head, face


def on_recordings(folder: Path, character: str) -> dict[str, float]:
    """Performs and scores the lines that three directors read; the figures."""
    total: Counter[str] = Counter()
    movements, seconds, spent_s, words = 0, 0.0, 0.0, 0
    with Understudy.load(Settings()) as understudy:
        score = load_score(folder, understudy.behavior.families.shows)
        records = [score.read(folder / name) for name in READERS]
        for line in map(json.loads, (folder / "dev-lines.jsonl").read_text().splitlines()):
            analysis = _analyzed(understudy, folder, line)
            began_s = time.process_time()
            performance = perform_analysis(understudy, analysis, Options(character=character))
            write_bml(performance)
            spent_s, words = spent_s + time.process_time() - began_s, words + len(line["words"])
            each = [record[line["id"]] for record in records]
            total += score.judge(each, gestures_of(score, performance))
            total += score.other_channels(each, *others_of(score, performance))
            movements += sum(behavior.kept for behavior in performance.behaviors)
            seconds += performance.utterance.duration_s or 0.0
    score.show(f"{len(records[0])} lines", total, len(records[0]))
    print(f"movements a second, all channels: {movements / seconds:.2f}")
    print(f"planning, mapping, scheduling, writing: {1000 * 15 * spent_s / words:.1f} ms for 15 words")
    return agreement(score, total, len(records[0]))


def with_notes(folder: Path, character: str) -> None:
    """Performs the lines as each reader directs them, and scores them against him alone."""
    with Understudy.load(Settings()) as understudy:
        score = load_score(folder, understudy.behavior.families.shows)
        lines = [json.loads(line) for line in (folder / "dev-lines.jsonl").read_text().splitlines()]
        analyses = {line["id"]: _analyzed(understudy, folder, line) for line in lines}
        for name in READERS:
            records, played, possible = score.read(folder / name), Counter[str](), Counter[str]()
            for row in (folder / name).read_text(encoding="utf-8").splitlines():
                line_id = json.loads(row)["id"]
                direction = replace(read_direction(row.encode()), complete=True)
                options = Options(character=character)
                performance = perform_analysis(understudy, analyses[line_id], options, direction)
                record = [records[line_id]]
                played += score.judge(record, gestures_of(score, performance))
                ideal = [(each["stroke"], each["gesture"][:1]) for each in score.gestural(record[0])]
                possible += score.judge(record, ideal)
            score.show(f"{name}, as directed", played, len(records))
            score.show(f"{name}, possible", possible, len(records))


def _analyzed(understudy: Understudy, folder: Path, line: Mapping[str, Any]) -> Analysis:
    text = " ".join(word.split(":", 1)[1] for word in line["words"])
    return analyze(understudy, Line((folder / "audio" / f"{line['id']}.flac").read_bytes(), text))


def held_out(folder: Path, paths: Iterable[Path], terms_path: Path, folds: int) -> None:
    """Scores plans on the lines that the encoders had not seen, by source."""
    readings: dict[str, SingleArray] = {}
    for path in paths:
        readings |= read_readings(path)
    terms, score = pickle.loads(terms_path.read_bytes()), load_score(folder, {})
    every = read_lines(folder)
    fold, lines = folds_of(every, folds), [line for line in every if line.name in readings]
    totals: dict[str, Counter[str]] = {}
    counts: Counter[str] = Counter()
    for number in range(folds):
        training = [line for line in lines if fold[line.name] != number]
        test = [line for line in lines if fold[line.name] == number and line.source != "own"]
        for line, planned in _planned(training, test, readings, terms):
            judged = score.judge([_record(score, line)], planned)
            for name in ("all", line.source):
                totals.setdefault(name, Counter()).update(judged)
                counts[name] += 1
    for name, total in totals.items():
        score.show(f"{name}, {counts[name]} lines", total, counts[name])


def _planned(
    training: Sequence[DirectedLine],
    test: Sequence[DirectedLine],
    readings: Mapping[str, SingleArray],
    terms: Mapping[str, Sequence[frozenset[str]]],
) -> Iterator[tuple[DirectedLine, list[tuple[int, list[str]]]]]:
    """The strokes of each test line with the families that their lexemes show, by weights fitted to other lines."""
    examples = examples_of(training, readings, terms)
    model = fitted(examples)
    price = price_of(training, [each for each, _ in lexeme_worths(training, readings, model.worth(examples))])
    worth = model.worth(examples_of(test, readings, terms, examples.names))
    for line, (each, shown) in zip(test, lexeme_worths(test, readings, worth), strict=True):
        yield (
            line,
            [
                (stroke.word, _families(shown[int(each.of(stroke.window)[stroke.word].argmax())]))
                for stroke in strokes(each, price, usual_times_s(len(each.stroke)))
            ],
        )


def _families(shown: SingleArray) -> list[str]:
    """The families that a lexeme shows, the first first."""
    return [FAMILIES[int(place)] for place in np.argsort(-shown, kind="stable") if shown[place] > 0]


def _record(score: Any, line: DirectedLine) -> dict[str, Any]:  # noqa: ANN401
    moments = [dict(moment, gesture=gesture_choices(moment)) for moment in line.reading["moments"]]
    avoid = [
        dict(each, what=[score.SAME.get(family, family) for family in each["what"]])
        for each in line.reading.get("avoid", ())
    ]
    return {"moments": moments, "avoid": avoid}


def _timed(word: Word) -> dict[str, float]:
    assert word.interval is not None, "only timed words are asked"
    return {"index": word.index, "start_s": word.interval.start_s, "end_s": word.interval.end_s}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--choice", choices=("terms", "priority"), default="terms")
    parser.add_argument("--character", default="default")
    parser.add_argument("--notes", action="store_true")
    parser.add_argument("--held-out", nargs="+", type=Path)
    parser.add_argument("--terms", type=Path)
    parser.add_argument("--folds", type=int, default=2)
    add_record_option(parser)
    arguments = parser.parse_args()
    if arguments.held_out:
        held_out(arguments.directing, arguments.held_out, arguments.terms, arguments.folds)
        return
    if arguments.notes:
        with_notes(arguments.directing, arguments.character)
        return
    os.environ["UNDERSTUDY_CHOICE"] = arguments.choice
    figures = on_recordings(arguments.directing, arguments.character)
    if arguments.record:
        record_all("78 lines", figures, BARS)


if __name__ == "__main__":
    main()

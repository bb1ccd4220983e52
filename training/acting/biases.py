"""Sets the biases of the families by what three directors want of held-out lines.

    python -m training.acting.biases CASES.pkl [--weights models/acting/weights.json] [--share 1.0]

CASES are those of `training/acting/held_out.py`; those by words alone count that three directors read with care.
Readers differ in which families they like: the quick ones hardly ever present. A family of which the reader expects
less than the directors want gets the logarithm of the ratio of both, times `--share`, as a further bias. Each half of
the lines is calibrated by the other for the figures that are printed: F of what is performed, before and after. The
weights that are written are calibrated by all lines.
"""

import argparse
import json
import pickle
import zlib
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.behavior.directing import gestures_of, load_score, others_of
from benchmarks.behavior.kinds import records_of
from understudy.behavior.reading.encoder import Delivery, Encoder
from understudy.model import FloatArray
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis
from understudy.settings import Settings

from .cases import WORDS, Case
from .directed import FAMILIES, targets_of
from .second_readings import readings_by_three

FEW = 6.0
"""Added to both sums of a family, so that rare ones hardly change."""
FOLDS = 2

Readings = Mapping[str, Sequence[dict[str, Any]]]


def missing(encoder: Encoder, cases: Sequence[Case], careful: Readings) -> FloatArray:
    """The logarithm of what directors want of each family (F,) beside what the reader expects."""
    read, wanted = (np.full(len(FAMILIES), FEW) for _sum in range(2))
    for case in cases:
        if case.way == WORDS:
            utterance = case.analysis.utterance
            read += encoder.read([word.text for word in utterance.words], Delivery.of(utterance)).at_word.sum(axis=0)
            lines = [replace(case.line, reading=each) for each in careful[case.line.name]]
            wanted += np.mean([targets_of(line).at_word.sum(axis=0) for line in lines], axis=0)
    return np.asarray(np.log(wanted / read))


def with_biases(understudy: Understudy, more: FloatArray) -> Understudy:
    """The models with further biases (F,), in the order of `FAMILIES`."""
    models = understudy.behavior
    choice = models.planner.choice
    own = np.array([more[FAMILIES.index(family)] for family in choice.families], np.float32)
    planner = replace(models.planner, choice=replace(choice, bias=choice.bias + own))
    return replace(understudy, behavior=replace(models, planner=planner))


def judged(understudy: Understudy, score: Any, cases: Sequence[Case], careful: Readings) -> dict[str, Counter[str]]:  # noqa: ANN401
    """The counts of score.py by way, of whole performances."""
    totals: dict[str, Counter[str]] = defaultdict(Counter)
    for case in cases:
        performance = perform_analysis(understudy, case.analysis, Options())
        records = records_of(score, [replace(case.line, reading=each) for each in careful[case.line.name]])
        totals[case.way] += score.judge(records, gestures_of(score, performance))
        totals[case.way] += score.other_channels(records, *others_of(score, performance))
        totals[case.way]["cases"] += 1
    return totals


def calibrated(
    understudy: Understudy,
    score: Any,  # noqa: ANN401
    cases: Sequence[Case],
    careful: Readings,
    share: float,
) -> dict[str, Counter[str]]:
    """The counts of each half of the cases with the biases of the other."""
    totals: dict[str, Counter[str]] = defaultdict(Counter)
    folds = [zlib.crc32(case.line.group.encode()) // 8 % FOLDS for case in cases]
    for fold in range(FOLDS):
        others = [case for case, own in zip(cases, folds, strict=True) if own != fold]
        tested = [case for case, own in zip(cases, folds, strict=True) if own == fold]
        more = share * missing(understudy.behavior.planner.encoder, others, careful)
        for way, counts in judged(with_biases(understudy, more), score, tested, careful).items():
            totals[way] += counts
    return totals


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", type=Path)
    parser.add_argument("--weights", type=Path, default=Path("models/acting/weights.json"))
    parser.add_argument("--share", type=float, default=1.0)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    arguments = parser.parse_args()
    careful = readings_by_three()
    cases: list[Case] = pickle.loads(arguments.cases.read_bytes())
    cases = [case for case in cases if case.line.name in careful]
    understudy = Understudy.for_words(Settings())
    score = load_score(arguments.directing, understudy.behavior.families.shows)
    for name, share in (("before", 0.0), ("after", arguments.share)):
        for way, counts in calibrated(understudy, score, cases, careful, share).items():
            score.show(f"{name}, {way}", counts, counts["cases"])
    more = arguments.share * missing(understudy.behavior.planner.encoder, cases, careful)
    written = json.loads(arguments.weights.read_text(encoding="utf-8"))
    for family, bias in zip(FAMILIES, more, strict=True):
        written["bias"][family] = round(written["bias"][family] + float(bias), 3)
    arguments.weights.write_text(json.dumps(written, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

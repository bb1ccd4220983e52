"""Measures whether functions of different classes on the same words compete, as the paper has it (§3.3), or stand
beside each other, for both ways of choosing.

    python -m training.acting.competing CASES.pkl [--directing FOLDER] [--every N]

CASES are those of `training/acting/held_out.py`, held-out training lines. Each is performed, with clock and hands, by
terms and by priority, with functions that compete and with functions that do not; printed is what score.py of the
folder says of all ways together, and the share of functions that stand beside another one on their words.
"""

import argparse
import pickle
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Literal
from unittest import mock

from benchmarks.behavior.directing import gestures_of, load_score, others_of
from understudy import performance
from understudy.model import Analysis, Function
from understudy.models import Understudy
from understudy.options import Options
from understudy.rules.priorities import resolved_as_in_paper
from understudy.settings import Settings

from .cases import Case
from .constants import Measure, f_of

CHOICES: tuple[Literal["terms", "priority"], ...] = ("terms", "priority")


@contextmanager
def nothing_dropped() -> Iterator[None]:
    """The choice by priority without competition across classes."""
    with mock.patch.object(performance, "resolved_as_in_paper", tuple):
        yield


def judged(measure: Measure, cases: Sequence[Case], choice: Literal["terms", "priority"]) -> Counter[str]:
    """The counts of score.py over the performances of the cases."""
    total: Counter[str] = Counter()
    for case in cases:
        made = performance.perform_analysis(measure.understudy, case.analysis, Options(choice=choice))
        record = [measure.record(case)]
        total += measure.score.judge(record, gestures_of(measure.score, made))
        total += measure.score.other_channels(record, *others_of(measure.score, made))
    return total


def beside_others(functions: Sequence[Function]) -> int:
    """How many kept functions share a word with another kept one of another class."""
    kept = [each for each in functions if each.kept]
    return sum(
        any(
            one.class_name != other.class_name and one.first <= other.last and other.first <= one.last for other in kept
        )
        for one in kept
    )


def competing(case: Case) -> Case:
    """A case whose functions have competed across classes."""
    analysis: Analysis = case.analysis
    return replace(case, analysis=replace(analysis, functions=resolved_as_in_paper(analysis.functions)))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", type=Path)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--every", type=int, default=1, help="only each nth case")
    arguments = parser.parse_args()
    beside: list[Case] = pickle.loads(arguments.cases.read_bytes())[:: arguments.every]
    apart = [competing(case) for case in beside]
    for name, cases in (("table", beside), ("all compete", apart)):
        kept = sum(function.kept for case in cases for function in case.analysis.functions)
        shared = sum(beside_others(case.analysis.functions) for case in cases)
        print(f"{name}: {kept} functions kept, {shared} of them beside one of another class")
    understudy = Understudy.for_words(Settings())
    measure = Measure(understudy, load_score(arguments.directing, understudy.behavior.families.shows))
    for choice in CHOICES:
        for name, cases in (("table", beside), ("all compete", apart)):
            with nothing_dropped():
                counts = judged(measure, cases, choice)
            measure.score.show(f"{choice}, {name}, {len(cases)} lines", counts, len(cases))
            print(f"F {f_of(measure.score, counts):.4f}", flush=True)


if __name__ == "__main__":
    main()

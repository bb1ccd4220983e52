"""Chooses the constants of the choice by held-out training lines.

    python -m training.acting.constants CASES.pkl [--takes N]

CASES are those of `training/acting/held_out.py`. Each constant is moved in turn, for as long as that gains `LEAST_GAIN`
of the objective: the mean F of the three ways in which lines are given (words alone, said plainly, delivered; score.py
of the folder), less what is forbidden. Plans are scored, without clock and hands. Which lines are chosen on is swapped
(`FOLDS`): printed is F of each half with the constants of the other one, and with those of all lines, which are the
ones to be written down. The price is chosen again on whole performances, since hands and time forbid some of what is
planned. `--takes` tells what the size of chance and its variety cost and give.
"""

import argparse
import json
import pickle
import zlib
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from itertools import combinations, product
from pathlib import Path
from typing import Any, cast
from unittest import mock

from benchmarks.behavior.directing import gestures_of, load_score
from understudy.behavior.candidates import attitudes
from understudy.behavior.reading import planning, strokes, supports, worths
from understudy.behavior.reading.encoder import WORDS_ALONE, Delivery, Encoder, Reading
from understudy.behavior.stage import Performer, performer_of, plan_line
from understudy.model import Channel, Moment, Performance
from understudy.models import BehaviorModels, Understudy
from understudy.options import Options
from understudy.performance import perform_analysis
from understudy.rules.mapping import map_functions
from understudy.settings import Settings

from .cases import Case

Constants = Mapping[str, float]

PLACES: Mapping[str, tuple[Any, ...]] = {
    "FOCUS_WEIGHT": (worths,),
    "OTHER_SHARE": (worths,),
    "AT_WORD_SHARE": (planning,),
    "PACE_WEIGHT": (planning,),
    "PLACE": (strokes,),
    "PRECISE": (strokes,),
    "SHARE_POWER": (strokes,),
    "UNPLACED": (strokes,),
    "PRIORITY_SCALE": (supports,),
    "WEIGHT_SCALE": (supports,),
    "WORDS_SHARE": (attitudes,),
    "TEMPERATURE": (worths,),
    "VARIETY": (worths,),
}
"""The modules that have each constant; `price` is that of the weights."""

STEPS: Mapping[str, tuple[float, ...]] = {
    "price": (0.36, 0.4, 0.44, 0.48, 0.52, 0.56),
    "FOCUS_WEIGHT": (0.1, 0.2, 0.3, 0.4),
    "PLACE": (0.0, 0.15, 0.3, 0.45),
    "PRECISE": (0.0, 0.15, 0.3),
    "SHARE_POWER": (0.25, 0.4, 0.5, 1.0),
    "AT_WORD_SHARE": (0.3, 0.5, 0.7),
    "WEIGHT_SCALE": (0.25, 0.5, 0.75),
    "PRIORITY_SCALE": (0.05, 0.1, 0.2),
}
"""What each may be; the order is that in which they are moved."""

LEAST_GAIN = 0.002
FORBIDDEN_COSTS = 0.5
FOLDS = 2

TEMPERATURES, VARIETIES = (0.18, 0.22, 0.26), (6.0, 8.0)
SEEDS = 4
CHANCE_COSTS = 0.02
"""F that takes may lose against the best one."""


@dataclass(frozen=True, slots=True)
class Remembering:
    """An encoder that reads each line once."""

    encoder: Encoder
    found: dict[tuple[tuple[str, ...], Delivery], Reading] = field(default_factory=dict)

    def __getattr__(self, name: str) -> Any:  # noqa: ANN401
        return getattr(self.encoder, name)

    def read(self, words: Sequence[str], delivery: Delivery = WORDS_ALONE) -> Reading:
        key = tuple(words), delivery
        if key not in self.found:
            self.found[key] = self.encoder.read(words, delivery)
        return self.found[key]


@dataclass(frozen=True, slots=True)
class Measure:
    """The models, and score.py."""

    understudy: Understudy
    score: Any

    @property
    def models(self) -> BehaviorModels:
        return self.understudy.behavior

    def performer(self, case: Case, seed: int) -> Performer:
        """Who performs a case."""
        analysis = case.analysis
        mapped = map_functions(
            self.models.rules, analysis.utterance, analysis.functions, seed=seed, facts=analysis.facts
        )
        return performer_of(self.models, analysis, Options(seed=seed), mapped=mapped)

    def planned(self, performer: Performer) -> tuple[list[Any], list[Any], list[Any]]:
        """Gestures, head movements and faces of a plan, as score.py reads them."""
        plan = plan_line(performer)
        gestures: list[Any] = []
        heads: list[Any] = []
        faces: list[Any] = []
        for moment in (*plan.plan.moments, *(each.moment for each in plan.held if each.moment)):
            if moment.channel is Channel.GESTURE:
                gestures.append((moment.stroke, self._families(plan.plan, moment)))
            elif moment.channel in (Channel.HEAD, Channel.FACE):
                table = self.score.HEAD if moment.channel is Channel.HEAD else self.score.FACE
                lexeme = performer.character.entries[self._behavior(moment)].lexeme
                told = (moment.first, moment.last, table.get(lexeme, set()))
                (heads if moment.channel is Channel.HEAD else faces).append(told)
        return gestures, heads, faces

    def judged(self, case: Case, performer: Performer) -> Counter[str]:
        """The counts of score.py."""
        record = self.record(case)
        gestures, heads, faces = self.planned(performer)
        return Counter(self.score.judge([record], gestures) + self.score.other_channels([record], heads, faces))

    def record(self, case: Case) -> dict[str, Any]:
        """The reading of a case as score.py has it: pointings are one family."""
        record: dict[str, Any] = json.loads(json.dumps(case.line.reading))
        same = self.score.SAME
        for moment in record["moments"]:
            moment["gesture"] = list(dict.fromkeys(same.get(each, each) for each in moment.get("gesture") or ()))
        for each in record.get("avoid", ()):
            each["what"] = [same.get(what, what) for what in each["what"]]
        return record

    def _families(self, plan: planning.Plan, moment: Moment) -> list[str]:
        if moment.set_against is not None or plan.worths is None:
            return list(dict.fromkeys(self.score.SAME.get(each, each) for each in moment.families[:2]))
        best = plan.worths.best(moment.stroke)
        return list(self.score.FAMILIES[best])

    def _behavior(self, moment: Moment) -> str:
        """The behaviour that shows a head movement or face; an attitude's moment names it."""
        families = self.models.families
        listed = families.head if moment.channel is Channel.HEAD else families.face
        name = moment.families[0]
        return listed[name][0].name if name in listed else name


def f_of(score: Any, counts: Mapping[str, int]) -> float:  # noqa: ANN401
    return float(score.f_of(counts["worth"] / max(counts["n"], 1), counts["given"] / max(counts["weight"], 1e-9)))


def with_constants(models: BehaviorModels, constants: Constants) -> BehaviorModels:
    """The models with this price."""
    planner = models.planner
    price = constants.get("price", planner.choice.price)
    return replace(models, planner=replace(planner, choice=replace(planner.choice, price=price)))


def patched(constants: Constants) -> ExitStack:
    """The constants in their modules for as long as the stack is open."""
    stack = ExitStack()
    for name, value in constants.items():
        for module in PLACES.get(name, ()):
            stack.enter_context(mock.patch.object(module, name, value))
    return stack


def judged(measure: Measure, cases: Sequence[Case], constants: Constants, seed: int = 0) -> dict[str, Counter[str]]:
    """The counts by way."""
    own = replace(measure, understudy=replace(measure.understudy, behavior=with_constants(measure.models, constants)))
    totals: dict[str, Counter[str]] = defaultdict(Counter)
    with patched(constants):
        for case in cases:
            totals[case.way] += own.judged(case, own.performer(case, seed))
            totals[case.way]["cases"] += 1
    return totals


def objective(measure: Measure, totals: Mapping[str, Counter[str]]) -> float:
    """The mean F, less what is forbidden."""
    worth = [f_of(measure.score, each) - FORBIDDEN_COSTS * each["bad"] / max(each["n"], 1) for each in totals.values()]
    return sum(worth) / len(worth)


def chosen(measure: Measure, cases: Sequence[Case], start: Constants) -> dict[str, float]:
    """The constants that are best on the cases, each moved in turn."""
    best = dict(start)
    reached = objective(measure, judged(measure, cases, best))
    for name, steps in STEPS.items():
        tried = {step: objective(measure, judged(measure, cases, best | {name: step})) for step in steps}
        step = max(tried, key=lambda each: tried[each])
        print(f"  {name}: {' '.join(f'{each:g} {worth:.4f}' for each, worth in tried.items())}", flush=True)
        if tried[step] > reached + LEAST_GAIN:
            best[name], reached = step, tried[step]
    return best


def shown(measure: Measure, name: str, totals: Mapping[str, Counter[str]]) -> None:
    for way, counts in totals.items():
        measure.score.show(f"{name}, {way}", counts, counts["cases"])


def halves(cases: Sequence[Case]) -> Iterator[tuple[list[Case], list[Case]]]:
    """The cases by line, to choose on and to test."""
    for fold in range(FOLDS):
        inside = [zlib.crc32(case.line.group.encode()) // 8 % FOLDS == fold for case in cases]
        yield (
            [case for case, tested in zip(cases, inside, strict=True) if not tested],
            [case for case, tested in zip(cases, inside, strict=True) if tested],
        )


def prices(measure: Measure, cases: Sequence[Case], constants: Constants) -> None:
    """Prints what whole performances reach at each price."""
    for price in STEPS["price"]:
        told = {**constants, "price": price}
        understudy = replace(measure.understudy, behavior=with_constants(measure.models, told))
        totals: dict[str, Counter[str]] = defaultdict(Counter)
        with patched(told):
            for case in cases:
                judged_once = gestures_judged(measure, [case], [performed(understudy, case, 0)])
                totals[case.way] += judged_once + Counter(cases=1)
        each = ", ".join(
            f"{way} F {f_of(measure.score, counts):.3f} of {counts['n'] / counts['cases']:.2f} gestures a line"
            for way, counts in totals.items()
        )
        print(f"price {price} in performances: {objective(measure, totals):.4f} ({each})", flush=True)


def takes(measure: Measure, cases: Sequence[Case], constants: Constants) -> None:
    """Prints what chance costs whole performances, and in how many pairs of takes their gestures differ."""
    best = None
    for temperature, variety in ((0.0, 0.0), *product(TEMPERATURES, VARIETIES)):
        told = {**constants, "TEMPERATURE": temperature, "VARIETY": variety}
        understudy = replace(measure.understudy, behavior=with_constants(measure.models, told))
        with patched(told):
            made = [
                [performed(understudy, case, seed) for case in cases] for seed in range(SEEDS if temperature else 1)
            ]
        worth = [f_of(measure.score, gestures_judged(measure, cases, each)) for each in made]
        mean = sum(worth) / len(worth)
        best = best or mean
        pairs = [
            lexemes(a) != lexemes(b) for one, other in combinations(made, 2) for a, b in zip(one, other, strict=True)
        ]
        print(
            f"temperature {temperature}, variety {variety}: F {mean:.3f} ({mean - best:+.3f}), other gestures in "
            f"{sum(pairs) / max(len(pairs), 1):.2f}",
            flush=True,
        )


def performed(understudy: Understudy, case: Case, seed: int) -> Performance:
    return perform_analysis(understudy, case.analysis, Options(seed=seed))


def lexemes(performance: Performance) -> list[str]:
    """Its gestures."""
    return [each.lexeme for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE]


def gestures_judged(measure: Measure, cases: Sequence[Case], made: Sequence[Performance]) -> Counter[str]:
    judged_each = (
        measure.score.judge([measure.record(case)], gestures_of(measure.score, performance))
        for case, performance in zip(cases, made, strict=True)
    )
    return sum(judged_each, Counter[str]())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", type=Path)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--takes", type=int, help="choose the size of chance, on so many cases, and nothing else")
    arguments = parser.parse_args()
    cases: list[Case] = pickle.loads(arguments.cases.read_bytes())
    understudy = Understudy.for_words(Settings())
    planner = understudy.behavior.planner
    planner = replace(planner, encoder=cast("Encoder", Remembering(planner.encoder)))
    models = replace(understudy.behavior, planner=planner)
    measure = Measure(replace(understudy, behavior=models), load_score(arguments.directing, models.families.shows))
    now = {name: float(getattr(places[0], name)) for name, places in PLACES.items() if name in STEPS}
    now["price"] = planner.choice.price
    if arguments.takes:
        takes(measure, cases[:: len(cases) // arguments.takes], now)
        return
    shown(measure, "now", judged(measure, cases, now))
    best = chosen(measure, cases, now)
    shown(measure, f"all lines, {best}", judged(measure, cases, best))
    prices(measure, cases, best)
    for number, (others, tested) in enumerate(halves(cases)):
        own = chosen(measure, others, now)
        shown(measure, f"half {number} now", judged(measure, tested, now))
        shown(measure, f"half {number} with those of the other {own}", judged(measure, tested, own))


if __name__ == "__main__":
    main()

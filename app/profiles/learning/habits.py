"""Estimates the habits of a speaker other than the tables: lexemes, units, phases, rests, head and eyes (NGS §3.2)."""

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from statistics import fmean

from ...model import Hand, Interval
from ..annotation.model import Annotation, LabelledInterval, PhaseKind, Unit
from ..profile import (
    FormHabit,
    HeadHabit,
    LexemeHabit,
    Occurrence,
    PhaseHabit,
    RestHabit,
    Spread,
    UnitHabit,
)
from ..segments import SHORTEST_REST_S
from ..space import size_of
from .observations import ObservedGesture
from .tables import shares_of

OWN_MEAN = 3.0
"""The weight of the speaker's overall mean in the mean of a lexeme, in gestures."""

LONGEST_UNIT = 6
"""Units of this many or more gestures are counted together (the table in NGS §1)."""

USUAL_MERGE_S = 1.5
"""The distance within which the paper joins neighbours to one unit."""

AT_LISTENER = frozenset({"listener", "addressee", "camera"})
"""The labels of a gaze at the addressee."""

MOST_OCCURRENCES = 12
"""The largest number of occurrences of one lexeme in the GestureDB of a profile."""


def lexeme_habits(
    gestures: Sequence[ObservedGesture], hands: Mapping[str, Mapping[Hand, float]]
) -> dict[str, LexemeHabit]:
    """The habit of each lexeme; means and deviations of rare lexemes are shrunk towards the speaker's overall ones."""
    shares = shares_of(Counter(each.phrase.lexeme for each in gestures))
    strokes = spread_of(map(_strokes, gestures))
    offset = spread_of(_offsets(gestures))
    habits = {}
    for lexeme, share in sorted(shares.items()):
        own = [each for each in gestures if each.phrase.lexeme == lexeme]
        habits[lexeme] = LexemeHabit(
            share=share,
            hands=hands[lexeme],
            strokes=spread_of(map(_strokes, own), strokes),
            offset_s=spread_of(_offsets(own), offset),
            held=sum(not each.phrase.strokes for each in own) / len(own),
        )
    return habits


def _strokes(gesture: ObservedGesture) -> float:
    return float(max(1, len(gesture.phrase.strokes)))


def _offsets(gestures: Iterable[ObservedGesture]) -> Iterator[float]:
    return (each.offset_s for each in gestures if each.offset_s is not None)


def spread_of(values: Iterable[float], prior: Spread | None = None) -> Spread:
    """The mean and deviation, shrunk towards `prior`, which counts as `OWN_MEAN` values."""
    found = list(values)
    weight = OWN_MEAN if prior else 0.0
    mean, deviation = (prior.mean, prior.deviation) if prior else (0.0, 0.0)
    total = len(found) + weight
    if not total:
        return Spread(0.0)
    pooled = (sum(found) + weight * mean) / total
    squares = sum((each - pooled) ** 2 for each in found) + weight * (deviation**2 + (mean - pooled) ** 2)
    return Spread(pooled, (squares / total) ** 0.5)


def unit_habit(annotations: Iterable[Annotation], gestures: Sequence[ObservedGesture]) -> UnitHabit:
    """The habit of units: their sizes, the distance that best separates neighbours within units from those in different
    units, and the share of nearer neighbours that are joined although there is time for a rest, by the number of
    gestures so far in the unit."""
    sizes = Counter(min(len(unit.phrases), LONGEST_UNIT + 1) for each in annotations for unit in each.units)
    gaps = [(each.gap_s, each.joined) for each in gestures if each.gap_s is not None]
    threshold_s = _threshold_s(gaps)
    return UnitHabit(
        merge_within_s=threshold_s,
        joined=_joined_by_size(gestures, threshold_s),
        sizes=tuple(sizes[size] / sizes.total() for size in range(1, LONGEST_UNIT + 2)),
    )


def _joined_by_size(gestures: Iterable[ObservedGesture], threshold_s: float) -> tuple[float, ...]:
    """The share of near gestures, which could also begin a unit, that are joined to a unit of 1, 2, … gestures; for
    rare sizes shrunk towards the share over all sizes."""
    free: dict[int, list[bool]] = {size: [] for size in range(1, LONGEST_UNIT + 1)}
    size = 0
    for each in gestures:
        if each.gap_s is not None and SHORTEST_REST_S <= each.gap_s < threshold_s:
            free[min(size, LONGEST_UNIT)].append(each.joined)
        size = size + 1 if each.joined else 1
    every = [joined for of_size in free.values() for joined in of_size]
    usual = Spread(sum(every) / len(every) if every else 1.0)
    return tuple(spread_of(map(float, of_size), usual).mean for of_size in free.values())


def _threshold_s(gaps: Sequence[tuple[float, bool]]) -> float:
    """The distance with the fewest classification errors; of equals, the one nearest to the paper's."""
    ordered = sorted({gap_s for gap_s, _joined in gaps})
    between = [USUAL_MERGE_S, *((one + other) / 2 for one, other in pairwise(ordered))]
    if ordered:
        between += [ordered[0] / 2, ordered[-1] + 0.1]
    joined, parted = (sorted(gap_s for gap_s, is_joined in gaps if is_joined is kind) for kind in (True, False))

    def mistakes(threshold_s: float) -> int:
        return bisect_left(parted, threshold_s) + len(joined) - bisect_left(joined, threshold_s)

    return min(between, key=lambda each: (mistakes(each), abs(each - USUAL_MERGE_S)))


def phase_habit(annotations: Iterable[Annotation]) -> PhaseHabit:
    """The durations of phases; usual values for phases that are not annotated (docs/references.md)."""
    phrases = [phrase for annotation in annotations for phrase in annotation.phrases]
    phases = [phase for phrase in phrases for phase in phrase.phases]
    back = [unit.retraction for annotation in annotations for unit in annotation.units if unit.retraction]
    after = [stroke for phrase in phrases for stroke in phrase.strokes[1:]]

    def of_kind(kind: PhaseKind) -> list[Interval]:
        return [phase.interval for phase in phases if phase.kind is kind]

    return PhaseHabit(
        preparation_s=_durations_s(of_kind(PhaseKind.PREPARATION), Spread(0.45, 0.1)),
        hold_s=_durations_s(of_kind(PhaseKind.HOLD), Spread(0.3, 0.2)),
        retraction_s=_durations_s(back, Spread(0.53, 0.1)),
        after_stroke_s=_durations_s(after, Spread(0.35, 0.05)),
    )


def _durations_s(intervals: Iterable[Interval], usual: Spread) -> Spread:
    return spread_of((each.duration_s for each in intervals), usual)


def rest_habit(annotations: Iterable[Annotation]) -> RestHabit:
    """The rest poses by the time until the next unit: the most frequent annotated rest, by default the paper's."""
    usual = RestHabit()
    marked: dict[str, Counter[str]] = {"near": Counter(), "medium": Counter(), "far": Counter()}
    for annotation in annotations:
        for unit, gap_s in _gaps_between(annotation.units, annotation.duration_s):
            distance = "near" if gap_s < usual.near_s else "far" if gap_s > usual.far_s else "medium"
            if unit.rest:
                marked[distance][unit.rest.strip().lower().replace(" ", "_")] += 1
    commonest = {name: counts.most_common(1)[0][0] for name, counts in marked.items() if counts}
    return RestHabit(
        near=commonest.get("near", usual.near),
        medium=commonest.get("medium", usual.medium),
        far=commonest.get("far", usual.far),
    )


def _gaps_between(units: Sequence[Unit], end_s: float) -> Iterator[tuple[Unit, float]]:
    for unit, following in pairwise(units):
        yield unit, following.interval.start_s - unit.interval.end_s
    if units:
        yield units[-1], end_s - units[-1].interval.end_s


def head_habit(annotations: Sequence[Annotation], seconds: float) -> HeadHabit:
    """The habits of head, eyes and body, if annotated."""
    heads = Counter(each.label for annotation in annotations for each in annotation.head)
    postures = Counter[str]()
    for annotation in annotations:
        for each in annotation.posture:
            postures[each.label] += round(1000 * each.interval.duration_s)
    return HeadHabit(
        per_minute={label: 60 * count / seconds for label, count in sorted(heads.items())},
        eye_contact=_eye_contact([each for annotation in annotations for each in annotation.gaze]),
        postures=tuple(label for label, _time in postures.most_common()),
    )


def _eye_contact(gaze: Sequence[LabelledInterval]) -> float | None:
    total_s = sum(each.interval.duration_s for each in gaze)
    at_s = sum(each.interval.duration_s for each in gaze if each.label.lower() in AT_LISTENER)
    return at_s / total_s if total_s else None


def form_habits(gestures: Iterable[ObservedGesture]) -> dict[str, FormHabit]:
    """The size of each lexeme whose positions are annotated."""
    positions: dict[str, list[float]] = {}
    for each in gestures:
        marked = [place for place in (each.phrase.start, each.phrase.end) if place]
        if marked:
            positions.setdefault(each.phrase.lexeme, []).append(size_of(marked))
    return {lexeme: FormHabit(size=round(fmean(sizes), 3)) for lexeme, sizes in sorted(positions.items())}


def database_of(gestures: Iterable[ObservedGesture]) -> tuple[Occurrence, ...]:
    """The GestureDB: the start and end positions of strokes, the most frequent of each lexeme first."""
    made = Counter(
        Occurrence(each.phrase.lexeme, each.phrase.hand, each.phrase.start, each.phrase.end, each.phrase.path)
        for each in gestures
        if each.phrase.start and each.phrase.end
    )
    kept: dict[str, list[Occurrence]] = {}
    for occurrence, _count in made.most_common():
        kept.setdefault(occurrence.lexeme, []).append(occurrence)
    return tuple(each for lexeme in sorted(kept) for each in kept[lexeme][:MOST_OCCURRENCES])

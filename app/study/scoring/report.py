"""Statistics as the papers' tables, in Markdown, which is also what a terminal shows, and as JSON."""

import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict

from ..comparison import DIMENSIONS, SINGLETONS, UNITS, Comparison
from .choices import Agreement, ChoiceStatistics, DimensionStatistics, choice_statistics
from .ratings import Preference, RatingStatistics, Variance, rating_statistics
from .reading import Answers

Statistics = RatingStatistics | ChoiceStatistics

SIGNIFICANT = 0.05
SMALLEST_P = 0.001


def report_json(statistics: Statistics) -> bytes:
    """Every figure, unrounded, by the names of the dataclasses."""
    return json.dumps(asdict(statistics), indent=2, allow_nan=False).encode() + b"\n"


def report_markdown(statistics: Statistics) -> str:
    """The tables."""
    lines = _ratings(statistics) if isinstance(statistics, RatingStatistics) else _choices(statistics)
    return "\n".join(lines) + "\n"


def _ratings(found: RatingStatistics) -> Iterator[str]:
    yield f"{found.raters} raters, {found.lines} lines, {found.ratings} ratings from 1 to 10"
    if found.incomplete:
        yield f"left out: {found.incomplete} lines of a rater who did not rate every clip"
    header = ("mode", "mean (sd)", "normalised (sd)", "highest grade", "lowest grade")
    asked = found.by_choice
    yield from _table(
        (*header, "best", "worst") if asked else header,
        [_rating_row(name, found, None if asked is None else asked[name]) for name in found.graded.means],
    )
    for title, variance in (("as rated", found.graded), ("normalised by rater", found.normalised)):
        yield from _variance(title, variance)


def _rating_row(name: str, found: RatingStatistics, asked: Preference | None) -> list[str]:
    graded, normalised, preference = found.graded.means[name], found.normalised.means[name], found.by_grade[name]
    said = [_percent(asked.first), _percent(asked.last)] if asked else []
    return [
        name,
        f"{graded.mean:.2f} ({graded.deviation:.2f})",
        f"{normalised.mean:.2f} ({normalised.deviation:.2f})",
        _percent(preference.first),
        _percent(preference.last),
        *said,
    ]


def _variance(title: str, variance: Variance) -> Iterator[str]:
    anova = variance.anova
    yield ""
    if anova is None:
        yield f"One-way ANOVA, {title}: none, for raters do not vary within any mode"
        return
    yield f"One-way ANOVA, {title}: F({anova.between}, {anova.within}) = {anova.f:.2f}, {_p(anova.p)}"
    rows = [
        [
            f"{each.first} - {each.second}",
            f"{each.difference:+.2f}",
            f"{each.low:+.2f} to {each.high:+.2f}",
            _p(each.p),
            "yes" if each.p < SIGNIFICANT else "no",
        ]
        for each in variance.differences
    ]
    yield from _table(("Tukey HSD", "difference", "95 %", "p", "significant"), rows)


def _choices(found: ChoiceStatistics) -> Iterator[str]:
    yield f"{found.raters} raters, {found.lines} lines"
    rows = [_dimension_row(name, each) for name, each in found.dimensions.items()]
    yield from _table(("more …", UNITS, SINGLETONS, "undecided", "t test", "p", "significant"), rows)
    yield ""
    yield "Relative frequencies of equal decisions; (+) alike, (-) opposite, more often than chance would have it:"
    yield from _agreements(found.agreements)
    if found.understood:
        yield ""
        told = ", ".join(f"{level}: {_percent(share)}" for level, share in found.understood.items())
        yield f"How much of the speech was understood, from 1 (nothing) to 3 (all): {told}"


def _dimension_row(name: str, found: DimensionStatistics) -> list[str]:
    test, units = found.test, found.units
    shares = ["-", "-"] if units is None else [_percent(units), _percent(1 - units)]
    if test is None:
        return [name, *shares, _percent(found.undecided), "-", "-", "-"]
    told = f"t({test.freedom}) = {test.t:.4f}, {test.tails}-tailed"
    return [name, *shares, _percent(found.undecided), told, _p(test.p), "yes" if test.p < SIGNIFICANT else "no"]


def _agreements(agreements: Iterable[Agreement]) -> Iterator[str]:
    """The upper half of a square table, as NGS's Table 1."""
    cells = {(each.first, each.second): _agreement(each) for each in agreements}
    rows = [[one, *(cells.get((one, other), "") for other in DIMENSIONS[1:])] for one in DIMENSIONS[:-1]]
    yield from _table(("", *DIMENSIONS[1:]), rows)


def _agreement(found: Agreement) -> str:
    sign = ("(+) " if found.alike > 1 / 2 else "(-) ") if found.p < SIGNIFICANT else ""
    return f"{sign}{found.alike:.2f}"


def _table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    widths = [max(len(row[place]) for row in (header, *rows)) for place in range(len(header))]
    yield ""
    for row in (header, ["-" * width for width in widths], *rows):
        yield "| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) + " |"


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %"


def _p(p: float) -> str:
    return f"p < {SMALLEST_P:g}" if p < SMALLEST_P else f"p = {p:.3f}"


def score(answers: Answers) -> RatingStatistics | ChoiceStatistics:
    """The statistics of a study; raises InputError `too_few_answers`."""
    if answers.comparison is Comparison.MODES:
        return rating_statistics(answers.ratings)
    return choice_statistics(answers.verdicts, answers.understood)

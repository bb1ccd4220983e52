"""Formats statistics as the papers' tables, in Markdown (also on the terminal), and as JSON."""

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict

from ..comparison import DIMENSIONS, SINGLETONS, UNITS, Comparison
from .choices import Agreement, ChoiceStatistics, DimensionStatistics, choice_statistics
from .preferences import PreferenceStatistics, preference_statistics
from .ratings import Preference, RatingStatistics, Variance, rating_statistics
from .reading import Answers
from .recognition import ALONE, BESIDE, RecognitionStatistics, recognition_statistics
from .samples import GroupDifference, Normality, TTest

Statistics = RatingStatistics | ChoiceStatistics | PreferenceStatistics | RecognitionStatistics

SIGNIFICANT = 0.05
SMALLEST_P = 0.001


def report_json(statistics: Statistics) -> bytes:
    """All statistics, unrounded, under the field names of the dataclasses."""
    return json.dumps(asdict(statistics), indent=2, allow_nan=False).encode() + b"\n"


def report_markdown(statistics: Statistics) -> str:
    """The tables in Markdown."""
    match statistics:
        case RatingStatistics():
            lines = _ratings(statistics)
        case ChoiceStatistics():
            lines = _choices(statistics)
        case PreferenceStatistics():
            lines = _preferences(statistics)
        case RecognitionStatistics():
            lines = _recognition(statistics)
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
    yield from _samples({name: (found.normality.get(name), found.groups.get(name, ())) for name in found.graded.means})


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
        yield f"One-way ANOVA, {title}: not computed, because no rater varies within any mode"
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
        listed = ", ".join(f"{level}: {_percent(share)}" for level, share in found.understood.items())
        yield f"How much of the speech was understood, from 1 (nothing) to 3 (all): {listed}"
    if found.understanding:
        yield ""
        yield "Shares of U by how much was understood and by dimension, two-factor ANOVA:"
        rows = [
            [each.name, f"F({each.between}, {each.within}) = {each.f:.2f}", *_judged(each.p)]
            for each in found.understanding
        ]
        yield from _table(("factor", "F", "p", "significant"), rows)
    yield from _samples({name: (each.normality, each.groups) for name, each in found.dimensions.items()})


def _preferences(found: PreferenceStatistics) -> Iterator[str]:
    yield f"{found.raters} raters, {found.lines} lines; from -2, the first much better, to 2, the second"
    rows = [
        [
            f"{each.first} versus {each.second}" if each.first != each.second else f"{each.first} twice",
            str(each.answers),
            f"{each.mean:+.2f} ({each.deviation:.2f})",
            _percent(each.neither),
            *_t_test(each.test),
            "-" if each.wilcoxon_p is None else _p(each.wilcoxon_p),
        ]
        for each in found.pairs
    ]
    yield from _table(("pair", "answers", "mean (sd)", "neither", "t test", "p", "significant", "Wilcoxon"), rows)
    yield from _samples({f"{each.first}, {each.second}": (each.normality, each.groups) for each in found.pairs})


def _recognition(found: RecognitionStatistics) -> Iterator[str]:
    yield f"{found.raters} raters, {found.lines} lines, speakers {', '.join(found.speakers)}"
    titles = {ALONE: "1, seen alone", BESIDE: "2, side by side"}
    rows = [
        [
            titles[number],
            str(test.answers),
            _percent(test.right),
            _percent(test.chance),
            *_t_test(test.test),
            _p(test.binomial_p),
        ]
        for number, test in found.tests.items()
    ]
    yield from _table(("test", "answers", "right", "by chance", "t test", "p", "significant", "binomial"), rows)
    for number, test in found.tests.items():
        yield ""
        listed = ", ".join(f"{name} {count}" for name, count in sorted(test.taken.items()))
        yield f"Test {titles[number]}; who was taken for whom: {listed}"
    yield from _samples({f"test {number}": (test.normality, test.groups) for number, test in found.tests.items()})


def _samples(tests: Mapping[str, tuple[Normality | None, Sequence[GroupDifference]]]) -> Iterator[str]:
    """The tables of normality and of group differences; `tests` are by condition, dimension or pair."""
    fitted = [
        [name, f"{each.distance:.3f}", *_judged(each.p, ("no", "yes"))] for name, (each, _) in tests.items() if each
    ]
    if fitted:
        yield ""
        yield "Normality of the raters' values (Kolmogorov-Smirnov, Lilliefors):"
        yield from _table(("of", "D", "p", "normal"), fitted)
    compared = [(name, each) for name, (_, differences) in tests.items() for each in differences]
    if compared:
        yield ""
        yield "Groups of raters (Mann-Whitney):"
        rows = [
            [
                name,
                f"{each.first} ({each.sizes[0]}), {each.second} ({each.sizes[1]})",
                f"U = {each.u:g}",
                *_judged(each.p),
            ]
            for name, each in compared
        ]
        yield from _table(("of", "groups", "U", "p", "significant"), rows)


def _judged(p: float, words: tuple[str, str] = ("yes", "no")) -> list[str]:
    return [_p(p), words[0] if p < SIGNIFICANT else words[1]]


def _t_test(test: TTest | None) -> list[str]:
    if test is None:
        return ["-", "-", "-"]
    return [f"t({test.freedom}) = {test.t:.4f}, {test.tails}-tailed", *_judged(test.p)]


def _dimension_row(name: str, found: DimensionStatistics) -> list[str]:
    units = found.units
    shares = ["-", "-"] if units is None else [_percent(units), _percent(1 - units)]
    return [name, *shares, _percent(found.undecided), *_t_test(found.test)]


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


def score(answers: Answers) -> Statistics:
    """The statistics of a study; raises InputError `too_few_answers`."""
    match answers.comparison:
        case Comparison.MODES:
            return rating_statistics(answers.ratings, answers.groups)
        case Comparison.UNITS:
            return choice_statistics(answers.verdicts, answers.understood, answers.groups)
        case Comparison.SPEAKERS:
            return recognition_statistics(answers.named, answers.groups)
    return preference_statistics(answers.comparison, answers.preferred, answers.groups)

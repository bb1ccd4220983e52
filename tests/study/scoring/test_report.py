"""The tables, and the same as JSON."""

import json

import pytest

from understudy.study.scoring.choices import choice_statistics
from understudy.study.scoring.ratings import rating_statistics
from understudy.study.scoring.reading import Rating, Verdict
from understudy.study.scoring.report import report_json, report_markdown

RATED = [
    Rating(rater, "l", mode, grade)
    for rater, grades in (("r1", (8, 4, 2)), ("r2", (9, 3, 3)), ("r3", (7, 5, 1)))
    for mode, grade in zip(("semantic", "prosody", "random"), grades, strict=True)
]


def _cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip("|").split("|")]


def test_the_tables_of_ratings() -> None:
    """F by hand: means 8, 4, 2 (grand 14/3), each group's sum of squares 2; F = (3 · 168/9 / 2) / (6 / 6) = 28."""
    told = report_markdown(rating_statistics(RATED))
    assert "3 raters, 1 lines, 9 ratings" in told
    assert "| semantic | 8.00 (1.00)" in told
    assert "One-way ANOVA, as rated: F(2, 6) = 28.00, p < 0.001" in told
    assert "semantic - prosody | +4.00" in told


def test_the_table_of_choices_is_that_of_the_paper() -> None:
    verdicts = [
        Verdict(f"r{rater}", f"l{line}", dimension, "S" if dimension == "nervous" or rater > line else "U")
        for rater in range(3)
        for line in range(6)
        for dimension in ("natural", "friendly", "nervous")
    ]
    told = report_markdown(choice_statistics(verdicts))
    rows = {cells[0]: cells[1:] for cells in map(_cells, told.splitlines()) if len(cells) == 7}
    assert rows["natural"][:3] == ["83 %", "17 %", "0 %"]
    assert rows["nervous"] == ["0 %", "100 %", "0 %", "-", "-", "-"]
    assert "(+) 1.00" in told
    assert "(-) 0.17" in told


def test_json_has_every_figure() -> None:
    told = json.loads(report_json(rating_statistics(RATED)))
    assert told["graded"]["anova"]["f"] == pytest.approx(28)
    assert told["normalised"]["means"]["semantic"]["mean"] == 1.0
    assert told["by_choice"] is None

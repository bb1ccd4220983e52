"""The figures of docs/measurements: what is recorded, and that the tables of the pages are those of the JSON."""

import re
from pathlib import Path

import pytest
from pydantic import ValidationError

from benchmarks import figures


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "figures").mkdir()
    monkeypatch.setattr(figures, "PAGES", tmp_path)


@pytest.mark.usefixtures("folder")
def test_a_figure_of_the_same_name_takes_the_place_of_the_earlier() -> None:
    figures.record("speed", "whole performance", 0.0731, "× real time", bar="≤ 0.08", aim="≤ 0.05")
    figures.record("speed", "memory", 257, "MB")
    figures.record("speed", "whole performance", 0.0412345, "× real time", bar="≤ 0.08", aim="≤ 0.05")

    memory, whole = figures.read("speed")

    assert (memory.name, memory.value, memory.bar) == ("memory", 257, None)
    assert (whole.value, whole.falls_short) == (0.04123, False)
    assert whole.command.startswith("python -m")
    assert re.fullmatch(r"[0-9a-f]{8}\+?", whole.commit)


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("value", "bar", "short"),
    [(0.6, "≥ 0.6", False), (0.59, "≥ 0.6", True), (201, "≤ 200", True), (0, "= 0", False), (1, "= 0", True)],
)
def test_a_value_that_misses_its_bar_is_bold(value: float, bar: str, short: bool) -> None:
    figures.record("speed", "lines", value, bar=bar)

    assert (f"| **{value:g}** |" in figures.table(figures.read("speed"))) == short


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("bar", [".6", ">= 0.6", "≥ .6", "at least 1"])
def test_a_bar_is_a_relation_and_a_number(bar: str) -> None:
    with pytest.raises(ValidationError, match="bar"):
        figures.record("speed", "lines", 1, bar=bar)


@pytest.mark.usefixtures("folder")
def test_the_table_stands_between_its_marks() -> None:
    figures.record("speed", "lines", 14.3, "a second")
    page = "before\n<!-- figures: speed -->\nold\n<!-- end of figures -->\nafter\n"

    made = figures.with_tables(page)

    assert made.startswith("before\n<!-- figures: speed -->\n\n| figure |")
    assert made.endswith("|\n\n<!-- end of figures -->\nafter\n")
    assert figures.with_tables(made) == made


@pytest.mark.parametrize("page", figures.pages(), ids=lambda page: page.name)
def test_the_pages_have_the_figures_of_the_json(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    assert text == figures.with_tables(text), "run python -m benchmarks.figures"


def test_every_area_has_its_table() -> None:
    shown = {area for page in figures.pages() for area in re.findall(r"<!-- figures: (\w+) -->", page.read_text())}
    assert shown == set(figures.areas())

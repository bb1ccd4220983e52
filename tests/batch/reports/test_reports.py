"""Reports: the most urgent lines come first, no content of a line breaks them, and pictures are embedded in the
page."""

import csv
import sys
from dataclasses import replace

import pytest
from lxml import html

from understudy.batch.manifest.entries import Entry, State, WrittenFile
from understudy.batch.reports.attention import attention, reasons
from understudy.batch.reports.csv_report import to_csv
from understudy.batch.reports.html_report import to_html
from understudy.batch.reports.index_json import to_index
from understudy.batch.reports.writing import in_order_of_attention
from understudy.batch.work.jobs import Failure, Measures
from understudy.model import Notice

MEASURES = Measures(2.5, 4, "low", {"negation": 1, "emphasis": 2}, 1, 0, 5, 2, 3.5)
FINE = Entry(
    "fine",
    0,
    2,
    "Ann",
    "default",
    "=No & <not> those",
    "",
    "a.wav",
    None,
    None,
    "i",
    "s",
    State.DONE,
    (WrittenFile("bml", "", "fine.bml", 3), WrittenFile("bml", "Ben", "fine.Ben.bml", 3)),
    (),
    MEASURES,
)
FLAT = replace(FINE, id="flat", place=1, measures=replace(MEASURES, pitch_spread_st=0.4))
SUSPECT = replace(FINE, id="suspect", place=2, warnings=(Notice("transcript_suspect", "not just <what> is said"),))
FAILED = replace(
    FINE, id="failed", place=3, state=State.FAILED, outputs=(), measures=None, failure=Failure("text_empty", "no words")
)
ALL = (FINE, FLAT, SUSPECT, FAILED)


def test_what_needs_an_eye_stands_first() -> None:
    assert [entry.id for entry in in_order_of_attention(ALL)] == ["failed", "suspect", "flat", "fine"]
    assert attention(FINE) == 0
    assert [reason for _weight, reason in reasons(FLAT)] == ["flat_take"]


def test_short_lines_are_not_called_flat() -> None:
    assert FLAT.measures is not None
    assert attention(replace(FLAT, measures=replace(FLAT.measures, duration_s=0.5))) == 0


def test_the_table_is_whole_and_no_text_is_a_formula() -> None:
    rows = list(csv.DictReader(to_csv(ALL).decode("utf-8-sig").splitlines()))
    assert [row["id"] for row in rows] == ["fine", "flat", "suspect", "failed"]
    assert rows[0]["text"] == "'=No & <not> those"
    assert rows[0]["functions"] == "negation:1 emphasis:2"
    assert (rows[3]["error_code"], rows[3]["duration_s"]) == ("text_empty", "")


def test_the_page_needs_nothing_else() -> None:
    page = html.fromstring(to_html("a<b>.csv", ALL, {"flat": b"PNG"}).decode())
    assert len(page.findall(".//tbody/tr")) == len(ALL)
    assert page.findtext(".//tbody/tr[1]/td[4]") == "=No & <not> those"
    pictures = page.findall(".//img")
    assert len(pictures) == 2
    assert all(str(picture.attrib["src"]).startswith("data:image/png;base64,") for picture in pictures)
    assert page.find(".//link") is None
    assert page.find(".//script[@src]") is None


def test_without_matplotlib_the_page_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    page = to_html("lines.csv", ALL, {}).decode()
    assert "pip install" in page
    assert "<img" not in page


def test_the_same_rows_give_the_same_bytes() -> None:
    assert to_html("lines.csv", ALL, {}) == to_html("lines.csv", ALL, {})


def test_the_index_has_what_was_performed() -> None:
    told = to_index("lines.csv", ALL).decode()
    assert told.count('"id"') == 3
    assert '"listeners": {\n    "Ben"' in told

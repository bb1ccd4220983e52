"""Reports: the most urgent lines come first, no content of a line breaks them, and pictures are embedded in the
page."""

import csv
import re
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from lxml import html

from understudy import batch
from understudy.batch.manifest.entries import ManifestEntry, State, WrittenFile
from understudy.batch.reports.attention import PLAIN, attention, plain_words, reasons
from understudy.batch.reports.html_report import Heading, Thumbnail, to_html
from understudy.batch.reports.writing import in_order_of_attention, to_csv, to_index
from understudy.batch.work.jobs import Failure, Measures
from understudy.model import Notice

OUT = Path("out")

MEASURES = Measures(2.5, 4, "low", {"negation": 1, "emphasis": 2}, 1, 0, 5, 2, 3.5)
FINE = ManifestEntry(
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


@pytest.fixture
def without_matplotlib(monkeypatch: pytest.MonkeyPatch) -> None:
    """As where it is not installed; histograms take longer than the rest of a page."""
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)


def page_of(
    *entries: ManifestEntry, thumbnails: dict[str, Thumbnail] | None = None, unit: str = "row"
) -> html.HtmlElement:
    return html.fromstring(to_html(Heading("a<b>.csv", unit), entries, thumbnails or {}, OUT).decode())


def test_the_page_needs_nothing_else() -> None:
    page = page_of(*ALL, thumbnails={"flat": Thumbnail("thumbnails/flat 1.png", b"PNG")})
    assert len(page.findall(".//tbody/tr")) == len(ALL)
    assert page.findtext(".//tbody/tr[1]//p[@class='words']") == "=No & <not> those"
    pictures = [picture for picture in page.findall(".//img") if "src" in picture.attrib]
    assert len(pictures) == 2
    assert all(str(picture.attrib["src"]).startswith("data:image/png;base64,") for picture in pictures)
    assert page.xpath("//a[@class='enlarge']/@href") == ["./thumbnails/flat%201.png"]
    assert page.find(".//link") is None
    assert page.find(".//script[@src]") is None


@pytest.mark.usefixtures("without_matplotlib")
def test_each_line_has_its_recording_and_files_relative_to_the_page() -> None:
    named = replace(FINE, audio="takes/Zoë #1.wav", start_s=1.0, end_s=2.5)
    evil = replace(FINE, id="evil", text='"><script>', audio="javascript:alert(1)")
    page = page_of(FINE, named, evil)
    sources = page.xpath("//audio/@src")
    assert sources[0] == "./../a.wav"
    assert sources[1] == "./../takes/Zo%C3%AB%20%231.wav#t=1.000,2.500"
    assert sources[2] == "./../javascript%3Aalert%281%29"
    assert page.xpath("//tr[1]//div[@class='links']/a/@href") == ["./fine.bml", "./fine.Ben.bml"]
    assert page.xpath("//tr[1]//div[@class='links']/a/text()") == ["bml", "Ben: bml"]
    commands = page.xpath("//button[@class='studio']/@data-command")
    assert commands[0] == "understudy studio a.wav --text '=No & <not> those'"
    assert len(commands) == 2
    assert len(page.xpath("//script")) == 1


@pytest.mark.usefixtures("without_matplotlib")
def test_what_is_to_be_looked_at_is_said_in_plain_words_with_what_to_do() -> None:
    page = page_of(SUSPECT, FAILED)
    assert page.xpath("//tr[@class='look']//div[@class='reason']/b/text()") == ["the recording may say other words"]
    assert page.xpath("//tr[@class='look']//div[@class='reason']/span/text()") == [plain_words("transcript_suspect")[1]]
    assert page.xpath("//p[@class='error']/text()") == ["no words"]
    assert "transcript_suspect" not in page.text_content()


def test_every_reason_and_warning_of_a_performance_has_plain_words() -> None:
    codes = set(re.findall(r'Notice\(\s*"([a-z_]+)"', "".join(path.read_text() for path in performing_code())))
    assert {code for code in codes if not code.startswith("edit_")} <= PLAIN.keys()
    assert plain_words("edit_word_gone")[1].startswith("open the line in the studio")
    assert plain_words("of_tomorrow") == ("of tomorrow", "see the message")


def performing_code() -> list[Path]:
    """The files that give notices about a line, other than about BML of others."""
    app = Path(batch.__file__).parents[1]
    folders = ("acoustic", "behavior", "syntax", "realizer")
    return [path for folder in folders for path in (app / folder).rglob("*.py")]


@pytest.mark.usefixtures("without_matplotlib")
@pytest.mark.parametrize("code", ["pronunciation_guessed", "listener_unknown"])
def test_what_needs_no_look_is_told_and_stands_last(code: str) -> None:
    mild = replace(FINE, warnings=(Notice(code, "told"),))
    assert attention(mild) == 0
    page = page_of(mild)
    assert page.xpath("//tbody/tr/@class") == ["fine"]
    assert len(page.xpath("//div[@class='reason mild']")) == 1


@pytest.mark.usefixtures("without_matplotlib")
@pytest.mark.parametrize(("unit", "heading"), [("row", "row"), ("line", "line"), ("cue", "cue")])
def test_rows_are_called_as_in_the_script(unit: str, heading: str) -> None:
    assert page_of(FINE, unit=unit).xpath("//th[1]/button/text()") == [heading]


@pytest.mark.usefixtures("without_matplotlib")
def test_without_matplotlib_the_page_says_so() -> None:
    page = to_html(Heading("lines.csv"), ALL, {}, OUT).decode()
    assert "pip install" in page
    assert '<img class="histograms"' not in page


def test_the_same_rows_give_the_same_bytes() -> None:
    assert to_html(Heading("lines.csv"), ALL, {}, OUT) == to_html(Heading("lines.csv"), ALL, {}, OUT)


def test_the_index_has_what_was_performed() -> None:
    told = to_index("lines.csv", ALL).decode()
    assert told.count('"id"') == 3
    assert '"listeners": {\n    "Ben"' in told

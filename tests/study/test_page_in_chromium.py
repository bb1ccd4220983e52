"""The page of a study in a browser, opened from the disk: two clips are seen, judged, saved, and scored."""

import json
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, ViewportSize

from tests.studio.conftest import PATIENCE_MS, UNSEEN, chromium
from tests.studio.support.waiting import wait_until
from understudy.files import resource_folder
from understudy.models import Understudy
from understudy.options import Options
from understudy.study.comparison import DIMENSIONS, Comparison
from understudy.study.making.lines import StudyRequest, StudySource
from understudy.study.making.whole_study import make_study
from understudy.study.scoring.reading import read_answers, read_key

SMALL: ViewportSize = {"width": 480, "height": 360}
"""Chromium lays out and shows without a graphics card here."""

FASTER = """
  const play = HTMLMediaElement.prototype.play;
  HTMLMediaElement.prototype.play = function () {
    window.playing = this;
    this.playbackRate = window.rate ?? 16;
    return play.call(this);
  };
"""
"""Clips are seen to their end in a fraction of their time, unless the test has set another rate."""


@pytest.fixture(scope="module")
def studies(understudy: Understudy, tmp_path_factory: pytest.TempPathFactory) -> dict[Comparison, Path]:
    """A study of the bundled line of each kind."""
    folder = tmp_path_factory.mktemp("study")
    source = resource_folder("examples")
    (folder / "lines").mkdir()
    for name in ("example.flac", "example.txt"):
        (folder / "lines" / name).write_bytes((source / name).read_bytes())
    for comparison, profile in ((Comparison.MODES, None), (Comparison.UNITS, "sweeping")):
        request = StudyRequest(
            StudySource(folder / "lines", None, folder / comparison), comparison, Options(profile=profile)
        )
        make_study(request, understudy, lambda _told, _notices: None)
    return {comparison: folder / comparison for comparison in Comparison}


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as found:
        yield found


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    faults: list[str] = []
    context = browser.new_context(viewport=SMALL, accept_downloads=True)
    context.add_init_script(FASTER)
    context.add_init_script(UNSEEN)
    made = context.new_page()
    made.set_default_timeout(PATIENCE_MS)
    made.on("pageerror", lambda error: faults.append(str(error)))
    made.on("request", lambda request: faults.extend(_elsewhere(request.url)))
    yield made
    context.close()
    assert faults == []


def test_ratings_are_asked_when_all_clips_are_seen_and_saved_as_they_were_given(
    studies: dict[Comparison, Path], page: Page, tmp_path: Path
) -> None:
    page.goto(_address(studies[Comparison.MODES], rater=1))
    page.get_by_role("button", name="Begin").click()
    questions = page.locator("input[name=grade-0]").first
    assert questions.is_disabled()
    page.evaluate("window.rate = 2")  # not changed while it plays: now and then Chromium would wait for sound for ever
    for letter in "ABC":
        page.evaluate("window.playing = undefined")
        page.get_by_role("button", name=f"Play {letter}").click()
        wait_until(page, "window.playing?.currentTime > 0")
        assert questions.is_disabled()
        _see_to_the_end(page)
    assert questions.is_enabled()
    for place, grade in enumerate((3, 9, 5)):
        page.locator(f"input[name=grade-{place}][value='{grade}']").check()
    page.locator("input[name=best][value='1']").check()
    page.locator("input[name=worst][value='1']").check()
    page.get_by_role("button", name="Next").click()
    assert page.get_by_role("heading", name="Round 1 of 1").is_visible(), "the best cannot be the worst as well"
    page.locator("input[name=worst][value='0']").check()
    page.get_by_role("button", name="Next").click()
    answers = read_answers([_saved(page, tmp_path)], studies[Comparison.MODES] / "key.csv").ratings
    assert [(each.rater, each.line, each.grade, each.choice) for each in answers] == [
        ("1", "example", 3, "worst"),
        ("1", "example", 9, "best"),
        ("1", "example", 5, ""),
    ]
    assert sorted(each.condition for each in answers) == ["prosody", "random", "semantic"]


def test_versions_are_compared_with_the_face_hidden_and_what_was_answered_is_kept(
    studies: dict[Comparison, Path], page: Page, tmp_path: Path
) -> None:
    page.goto(_address(studies[Comparison.UNITS], rater=2))
    page.evaluate("window.isSeen = true")  # here bodies are drawn too
    page.get_by_role("button", name="Begin").click()
    for letter in "AB":
        page.get_by_role("button", name=f"Play {letter}").click()
        _see_to_the_end(page)
    for name in DIMENSIONS:
        page.locator(f"input[name={name}][value='{'undecided' if name == 'competent' else 'A'}']").check()
    page.locator("input[name=understood][value='3']").check()
    page.get_by_role("button", name="Next").click()
    page.reload()
    assert page.get_by_text("has answered 1 of 1 rounds").is_visible()
    page.get_by_role("button", name="Begin").click()
    found = read_answers([_saved(page, tmp_path)], studies[Comparison.UNITS] / "key.csv")
    assert len({each.chosen for each in found.verdicts if each.chosen is not None}) == 1
    assert [each.dimension for each in found.verdicts if each.chosen is None] == ["competent"]
    assert [each.level for each in found.understood] == [3]


def test_pairs_are_preferred_and_speakers_named(studies: dict[Comparison, Path], page: Page, tmp_path: Path) -> None:
    """The pages of these comparisons, made from the clips of the other study."""
    pairs = _with_plan(studies[Comparison.UNITS], tmp_path / "ways", {"comparison": "ways"})
    page.goto(_address(pairs, rater=1))
    page.get_by_role("button", name="Begin").click()
    for letter in "AB":
        page.get_by_role("button", name=f"Play {letter}").click()
        _see_to_the_end(page)
    page.get_by_label("B much better").check()
    page.get_by_role("button", name="Next").click()
    rows = _saved(page, tmp_path).read_text().splitlines()
    assert rows[0] == "rater,trial,a,b,preference"
    assert rows[1].endswith(",2")
    (shown,) = _plan(studies[Comparison.UNITS])["lines"]
    training = [{**shown, "speaker": name, "clips": [clip]} for name, clip in zip("XY", shown["clips"], strict=True)]
    speakers = _with_plan(
        studies[Comparison.UNITS],
        tmp_path / "speakers",
        {"name": "speakers", "comparison": "speakers", "training": training},
    )
    page.goto(_address(speakers, rater=1))
    page.get_by_role("button", name="Begin").click()
    for played in (["X", "Y"], ["A"], ["A", "B"]):
        for name in played:
            page.get_by_role("button", name=f"Play {name}").click()
            _see_to_the_end(page)
        if played[0] == "A":
            page.get_by_label("Y", exact=True).check()
        page.get_by_role("button", name="Next").click()
    rows = _saved(page, tmp_path).read_text().splitlines()
    first, second = (row.split(",") for row in rows[1:])
    assert rows[0] == "rater,trial,clip,beside,answer"
    assert (first[3], first[4], second[4]) == ("", "Y", "Y")
    assert {second[2], second[3]} == set(shown["clips"])


def test_nothing_on_the_page_tells_what_is_what(studies: dict[Comparison, Path]) -> None:
    """Neither names nor texts; the modules speak of modes and units, but of no clip."""
    folder = studies[Comparison.MODES] / "page"
    key = read_key(studies[Comparison.MODES] / "key.csv")
    files = {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    assert {f"clips/{clip}.js" for clip in key} <= files.keys()
    for name, content in files.items():
        told = (name + content.decode("latin-1")).casefold()
        assert not any(word in told for word in ("semantic", "prosody", "drawn by chance", "gesture1", "example"))


_PLAN = re.compile(r'(<script type="application/json" id="plan">)(.*?)(</script>)')


def _plan(study: Path) -> Any:  # noqa: ANN401
    found = _PLAN.search((study / "page" / "index.html").read_text(encoding="utf-8"))
    assert found
    return json.loads(found[2])


def _with_plan(study: Path, folder: Path, changes: dict[str, object]) -> Path:
    """A study of the same clips whose plan differs by these changes."""
    shutil.copytree(study, folder)
    text = (study / "page" / "index.html").read_text(encoding="utf-8")
    plan = json.dumps(_plan(study) | changes)
    page = _PLAN.sub(lambda found: f"{found[1]}{plan}{found[3]}", text)
    (folder / "page" / "index.html").write_text(page, encoding="utf-8")
    return folder


def _see_to_the_end(page: Page) -> None:
    """Waits until the clip that plays is over, with its tail.

    Playwright's own wait looks once a drawn frame, and frames are rare where processors are busy.
    """
    wait_until(page, "!document.querySelector('[aria-busy=true]')")


def _saved(page: Page, folder: Path) -> Path:
    page.get_by_role("heading", name="Done").wait_for()
    with page.expect_download() as download:
        page.get_by_role("button", name="Save my answers").click()
    path = folder / download.value.suggested_filename
    download.value.save_as(path)
    return path


def _address(study: Path, *, rater: int) -> str:
    return f"{(study / 'page' / 'index.html').as_uri()}?rater={rater}"


def _elsewhere(url: str) -> list[str]:
    return [] if url.startswith(("file:", "data:", "blob:")) else [f"asked for {url}"]

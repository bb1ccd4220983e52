"""A scene is read from the folder of a batch: who speaks, who is seen, and what is told of a folder that will not
do."""

import time
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.studio.conftest import a_visit
from tests.studio.support.accessibility import serious_findings
from tests.studio.support.waiting import PATIENCE_S, wait_until

LINE_S, PAUSE_S = 7.18, 0.4
"""Both lines are the bundled one."""
LOOKED_MS = 60
"""How often hands are looked at while they move: looking without a pause takes a processor for itself."""


@pytest.fixture
def room(page: Page) -> Page:
    return _entered(page)


@pytest.fixture(scope="module")
def empty_room(long_visited: Page, service_url: str) -> Iterator[Page]:
    """One visit for all that opens no scene, and the last that does."""
    with a_visit(long_visited, service_url):
        yield _entered(long_visited)


def _entered(page: Page) -> Page:
    page.goto("/")
    page.get_by_role("button", name="Table read").click()
    return page


def test_two_characters_speak_in_turn_on_their_marks(room: Page, scene: Path) -> None:
    room.set_input_files("#scene-folder", scene)
    room.wait_for_selector("#table-read-canvas[data-wrists]")
    before = _wrists(room)
    assert len(before) == 6, "the right hands of two"
    assert before[0] < 0 < before[3], "ELIZA stands on the left, HENRY on the right"
    assert room.get_attribute("#table-read-canvas", "data-shot") == "wide ELIZA"
    room.click(".said:has-text('HENRY')")
    wait_until(room, "document.querySelector('#scene-time').value.startsWith('7.6')")
    assert room.get_attribute("[aria-current=true]", "aria-current")
    assert room.get_attribute("#table-read-canvas", "data-shot") == "close HENRY"
    room.click("[aria-label='Play from two on']")
    furthest_m, end_s = 0.0, time.monotonic() + PATIENCE_S
    while _time_s(room) < LINE_S + PAUSE_S + 3:
        assert time.monotonic() < end_s, "the scene stands still"
        room.wait_for_timeout(LOOKED_MS)
        furthest_m = max(furthest_m, *(abs(one - other) for one, other in zip(before, _wrists(room), strict=True)))
    room.click("#scene-play")
    assert furthest_m > 0.05


def test_a_zip_of_the_folder_will_do(room: Page, scene: Path, tmp_path: Path) -> None:
    packed = tmp_path / "scene.zip"
    with zipfile.ZipFile(packed, "w") as file:
        for path in scene.iterdir():
            file.write(path, f"out/{path.name}")
    room.set_input_files("#scene-zip", packed)
    room.wait_for_selector("#table-read-canvas[data-wrists]")
    assert room.get_by_role("list", name="Lines").get_by_role("listitem").count() == 2
    assert room.get_by_role("list", name="Cast").inner_text().split() == ["ELIZA", "HENRY"]
    assert room.is_hidden("#table_read .chooser")


def test_a_line_of_the_scene_is_noted_on_and_opened_in_the_studio(room: Page, scene: Path) -> None:
    room.set_input_files("#scene-folder", scene)
    room.fill("[aria-label='Note on two']", "slower")
    room.press("[aria-label='Note on two']", "Tab")
    with room.expect_download() as download:
        room.click("#scene-notes")
    assert Path(download.value.path()).read_text(encoding="utf-8") == "two\tHENRY\tslower\n"
    room.click("[aria-label='Open in Line: two']")
    room.wait_for_selector("#stage-canvas[data-roles='speaker']")
    assert "really sure" in room.input_value("#text")


def test_a_folder_that_is_no_batch_says_so(empty_room: Page, tmp_path: Path) -> None:
    (tmp_path / "some").mkdir()
    (tmp_path / "some" / "notes.txt").write_text("nothing")
    empty_room.set_input_files("#scene-folder", tmp_path / "some")
    empty_room.wait_for_selector("#problem:has-text('there is no index.json')")


def test_what_a_batch_lacks_is_told(empty_room: Page, scene: Path, tmp_path: Path) -> None:
    (tmp_path / "index.json").write_bytes((scene / "index.json").read_bytes())
    empty_room.set_input_files("#scene-folder", tmp_path)
    empty_room.wait_for_selector(
        "#problem:has-text('of one, two; perform the batch with --format clip.json --format wav')"
    )


def test_nobody_stumbles_over_a_table_read_and_a_camera_may_be_chosen(empty_room: Page, scene: Path) -> None:
    assert serious_findings(empty_room) == []
    empty_room.set_input_files("#scene-folder", scene)
    empty_room.wait_for_selector("#table-read-canvas[data-wrists]")
    assert serious_findings(empty_room) == []
    empty_room.get_by_label("Camera").last.select_option("over_shoulder")
    empty_room.wait_for_selector("#table-read-canvas[data-shot='over_shoulder ELIZA']")


def _time_s(room: Page) -> float:
    """Where the scene is."""
    return float(room.evaluate("parseFloat(document.querySelector('#scene-time').value)"))


def _wrists(page: Page) -> list[float]:
    return [float(metres) for metres in (page.get_attribute("#table-read-canvas", "data-wrists") or "").split()]

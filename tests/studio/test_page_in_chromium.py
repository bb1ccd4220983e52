"""The page as a whole: what it says of mistakes, keys, and to those who do not see it."""

from pathlib import Path

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page

SERIOUS = {"serious", "critical"}


def test_a_wrong_file_shows_the_services_own_words(page: Page, tmp_path: Path) -> None:
    wrong = tmp_path / "song.wav"
    wrong.write_bytes(b"This is a letter.")
    page.goto("/")
    page.set_input_files("#files", str(wrong))
    page.fill("#text", "No, never.")
    page.press("#text", "Tab")
    told = page.wait_for_selector("#problem code")
    assert told
    assert told.inner_text() == "audio_format_unsupported"
    assert "wav" in page.inner_text("#problem").lower()


def test_a_body_that_is_none_is_told(opened: Page, tmp_path: Path) -> None:
    wrong = tmp_path / "body.glb"
    wrong.write_bytes(b"no body")
    opened.set_input_files("#files", str(wrong))
    opened.wait_for_selector("#problem:has-text('body.glb is not a body in GLB or VRM')")


def test_a_zip_that_is_no_project_is_told(page: Page, tmp_path: Path) -> None:
    wrong = tmp_path / "other.zip"
    wrong.write_bytes(b"PK")
    page.goto("/")
    page.set_input_files("#files", str(wrong))
    page.wait_for_selector("#problem:has-text('other.zip is not a zip that can be opened')")


def test_gestures_are_those_of_a_profile_and_another_name_is_told(opened: Page) -> None:
    opened.fill("#profile", "sweepng")
    opened.press("#profile", "Tab")
    opened.wait_for_selector("#problem:has-text('sweeping')")
    opened.fill("#profile", "sweeping")
    with opened.expect_response("**/perform") as answered:
        opened.press("#profile", "Tab")
    assert answered.value.ok
    opened.wait_for_selector("#problem", state="hidden")


def test_the_views_are_changed_by_keyboard(opened: Page) -> None:
    opened.focus("#views button:has-text('Rules')")
    opened.keyboard.press("Enter")
    assert opened.is_visible("main#rules") or opened.get_attribute("main#rules", "hidden") is None
    assert not opened.is_visible("main#line")


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_nothing_serious_is_in_the_way_of_anybody(opened: Page, theme: str) -> None:
    opened.select_option("#preferences select", theme)
    opened.click("#items li:has-text('gesture NEGATION')")
    found = Axe().run(opened).response["violations"]
    told = [(each["id"], [node["target"] for node in each["nodes"]]) for each in found if each["impact"] in SERIOUS]
    assert told == []

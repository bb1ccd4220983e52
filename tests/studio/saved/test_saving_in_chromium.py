"""What is changed is there again: after the page is loaded anew, as an earlier version, and on the start page."""

import re
from pathlib import Path

from playwright.sync_api import Page, expect

from tests.studio.support.changing import performed, select


def test_a_change_outlives_a_reload_and_is_found_on_the_start_page(opened: Page) -> None:
    select(opened, "gesture NEGATION")
    opened.click("#delete")
    expect(opened.locator("#saved")).to_have_text("Saved")
    opened.fill("#seed", "7")
    opened.press("#seed", "Tab")
    performed(opened)
    expect(opened.locator("#saved")).to_have_text("Saved")
    opened.reload()
    expect(opened.locator("#seed")).to_have_value("7")
    expect(opened.locator("#items li.dropped", has_text="deleted by the author")).to_have_count(1)
    opened.click("#saved")
    opened.click("#versions button:has-text('Restore') >> nth=-1")
    expect(opened.locator("#seed")).to_have_value("0")
    expect(opened.locator("#undo")).to_have_attribute("title", re.compile("^Undo: Restore"))


def test_a_written_line_outlives_a_reload_before_anything_is_changed(page: Page) -> None:
    page.goto("/")
    expect(page.locator("#saved")).to_be_disabled()
    page.fill("#written", "No, never.")
    page.click("#perform-written")
    expect(page.locator("#saved")).to_have_text("Saved")
    page.reload()
    expect(page.locator("#text")).to_have_value("No, never.")


def test_lines_that_were_worked_on_are_opened_from_the_start_page(opened: Page) -> None:
    """As they were left: what was undone is not there again."""
    opened.fill("#seed", "7")
    opened.press("#seed", "Tab")
    expect(opened.locator("#saved")).to_have_text("Saved")
    opened.click("#undo")
    opened.wait_for_timeout(400)  # the quiet after which a change is kept
    expect(opened.locator("#saved")).to_have_text("Saved")
    opened.reload()
    expect(opened.locator("#text")).not_to_be_empty()
    expect(opened.locator("#seed")).to_have_value("0")
    opened.fill("#seed", "5")
    opened.press("#seed", "Tab")
    expect(opened.locator("#saved")).to_have_text("Saved")
    opened.goto("/")
    opened.click("#recent button.open:has-text('example.flac')")
    expect(opened.locator("#seed")).to_have_value("5")
    opened.click("#open-another")
    opened.click("[aria-label='Forget example.flac']")
    expect(opened.locator("#recent")).to_be_hidden()
    opened.click("#back-to-line")
    expect(opened.locator("#stage-canvas")).to_be_visible()


CHANGED_AND_LEFT = """
() => {
  const [seed, written] = [document.querySelector("#seed"), document.querySelector("#written")];
  seed.value = "8";
  seed.dispatchEvent(new Event("change"));
  written.value = "No!";
  written.dispatchEvent(new Event("input"));
  document.querySelector("#perform-written").click();
}
"""


def test_a_change_is_kept_where_another_line_is_opened_at_once(opened: Page) -> None:
    opened.evaluate(CHANGED_AND_LEFT)
    expect(opened.locator("#text")).to_have_value("No!")
    expect(opened.locator("#saved")).to_have_text("Saved")
    opened.goto("/")
    opened.click("#recent button.open:has-text('example.flac')")
    expect(opened.locator("#seed")).to_have_value("8")


def test_a_file_that_no_line_has_a_use_for_is_told_where_it_belongs(page: Page, tmp_path: Path) -> None:
    page.goto("/")
    wrong = tmp_path / "words.yaml"
    wrong.write_text("words: []")
    page.set_input_files("#files", wrong)
    expect(page.locator("#problem")).to_contain_text("words.yaml: rules and word lists are edited under Rules")
    page.click("#views >> text=Rules")
    expect(page.locator("#problem")).to_be_hidden()

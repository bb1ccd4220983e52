"""Everything is reached, seen to have the focus, named and worked by the keyboard alone."""

import json
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.studio.support.changing import performed
from tests.studio.support.waiting import wait_until
from understudy.files import resource_folder

SPARE_TABS = 25
"""The parts of file fields, and the browser's own."""

CONTROLS = """
() => [...document.querySelectorAll("button, input, select, textarea, summary, canvas[tabindex], [tabindex='0']")]
  .filter((each) => each.checkVisibility() && !each.disabled)
  .map((each) => (each.dataset.asked = "yes")).length
"""
FOCUSED = """
() => {
  const now = document.activeElement;
  const { outlineStyle, outlineWidth } = getComputedStyle(now);
  const said = now.getAttribute("aria-label") ?? now.getAttribute("aria-labelledby") ?? now.labels?.[0]?.textContent;
  const name = (said || now.textContent).trim();
  now.dataset.asked = "no";
  return now === document.body ? null : { outline: `${outlineWidth} ${outlineStyle}`, name };
}
"""
UNREACHED = "[...document.querySelectorAll('[data-asked=yes]')].map((each) => each.outerHTML.slice(0, 120))"
STROKE = "#selected input[data-mark=stroke]"


@pytest.mark.parametrize("view", ["Line", "Gesture editor", "Rules", "Table read"])
def test_tab_leads_to_every_control_of_a_view(looked_at: Page, view: str) -> None:
    looked_at.click("#views >> text='Line'")
    looked_at.click("#items li[title*='gesture NEGATION']")
    looked_at.click(f"#views >> text='{view}'")
    if view == "Gesture editor":
        looked_at.wait_for_selector("#gesture-canvas[data-pose*='.']")
    elif view == "Rules":
        looked_at.fill("#rule-filter", "affirmation")
        looked_at.wait_for_selector("#rule-list li")
    for _press in range(looked_at.evaluate(CONTROLS) + SPARE_TABS):
        looked_at.keyboard.press("Tab")
        if focused := looked_at.evaluate(FOCUSED):
            assert focused["name"], "it has no name"
            assert focused["outline"] == "2px solid"
    assert looked_at.evaluate(UNREACHED) == []


def test_marks_and_edges_of_words_are_moved_by_arrows_and_keep_the_focus(opened: Page) -> None:
    """Quick presses add up, though the service has not answered the first when the last comes. The first of a field
    goes to whole hundredths."""
    opened.click("#items li[title*='gesture NEGATION']")
    before_s = float(opened.input_value(STROKE))
    opened.focus(STROKE)
    for _press in range(5):
        opened.keyboard.press("ArrowUp")
    wait_until(opened, f"document.querySelector('{STROKE}').value > {before_s + 0.038}")
    performed(opened)
    assert float(opened.input_value(STROKE)) == pytest.approx(before_s + 0.045, abs=0.006)
    assert opened.evaluate("document.activeElement.dataset.mark") == "stroke"
    opened.click("#items li[title*='word lights']")
    end_s, start_s = (float(opened.input_value(f"#word-{edge}")) for edge in ("end", "start"))
    opened.focus("#word-end")
    opened.keyboard.press("ArrowDown")
    opened.keyboard.press("ArrowDown")
    wait_until(opened, f"document.querySelector('#word-end').value < {end_s - 0.009}")
    performed(opened)
    end_s = float(opened.input_value("#word-end"))
    assert opened.evaluate("document.activeElement.id") == "word-end"
    opened.focus("#items")
    opened.keyboard.press("Alt+ArrowLeft")
    opened.keyboard.press("Alt+ArrowLeft")
    moved = f"{start_s - 0.04:.2f}–{end_s - 0.04:.2f}"
    expect(opened.locator("#items li[title*='word lights']")).to_contain_text(moved)


def test_the_line_is_played_and_looped_where_the_list_has_the_focus(opened: Page) -> None:
    opened.focus("#stage-canvas")
    opened.keyboard.press("Shift+ArrowRight")
    opened.keyboard.press("[")
    opened.keyboard.press("Shift+ArrowRight")
    opened.keyboard.press("]")
    expect(opened.locator("#loop")).to_have_attribute("aria-pressed", "true")
    opened.keyboard.press("End")
    assert opened.inner_text("#time") == "7.18 s"
    opened.focus("#items")
    opened.keyboard.press(" ")
    expect(opened.locator("#play")).to_have_text("Pause")
    wait_until(opened, "document.querySelector('audio').currentTime > 0.6")
    assert 0.5 <= float(opened.inner_text("#time").removesuffix(" s")) < 1.2
    opened.click("#views >> text=Rules")
    assert opened.evaluate("document.querySelector('audio').paused"), "it sounds where nobody sees it"


def test_a_line_of_ones_own_is_performed_changed_and_taken_away_by_keys_alone(page: Page) -> None:
    page.goto("/")
    with page.expect_file_chooser() as asked:
        # Asked for early: the browser is told so without waiting, and a quick Enter would overtake it.
        _tab_to(page, "#files")
        page.keyboard.press("Enter")
    example = resource_folder("examples")
    asked.value.set_files([example / "example.flac", example / "example.txt"])
    page.wait_for_selector("#stage-canvas[data-roles='speaker']")
    _tab_to(page, "#items")
    page.keyboard.press("Home")
    while not page.locator("#items li[aria-selected=true][title*='gesture NEGATION']").count():
        page.keyboard.press("ArrowDown")
    before_s = float(page.input_value(STROKE))
    page.keyboard.press("Alt+Shift+ArrowRight")
    performed(page)
    assert float(page.input_value(STROKE)) == pytest.approx(before_s + 0.1, abs=0.011)
    _tab_to(page, "#play")
    page.keyboard.press("Enter")
    expect(page.locator("#play")).to_have_text("Pause")
    page.keyboard.press("Enter")
    _tab_to(page, "#tab-exports")
    page.keyboard.press("Enter")
    _tab_to(page, "#export")
    with page.expect_download() as saved:
        page.keyboard.press("Enter")
    assert "NEGATION" in Path(saved.value.path()).read_text(encoding="utf-8")


def _tab_to(page: Page, selector: str) -> None:
    """Presses Tab until what a selector finds has the focus."""
    for _press in range(page.evaluate(CONTROLS) + SPARE_TABS):
        page.keyboard.press("Tab")
        if page.evaluate("(selector) => document.activeElement.matches(selector)", selector):
            return
    raise AssertionError(f"Tab never leads to {selector}")


def test_the_camera_orbits_by_keyboard(looked_at: Page) -> None:
    looked_at.click("#views >> text='Line'")
    picture = "document.querySelector('#stage-canvas').toDataURL()"
    before = looked_at.evaluate(picture)
    looked_at.evaluate("window.isSeen = true")
    looked_at.focus("#stage-canvas")
    for key in ("a", "d", "w", "+"):  # by the first it is drawn at all
        looked_at.keyboard.press(key)
        wait_until(looked_at, f"{picture} !== {json.dumps(before)}")
        before = looked_at.evaluate(picture)

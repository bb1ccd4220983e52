"""The timeline shows what is heard, meant and done, and says of all of it why; by mouse and by keyboard."""

import pytest
from playwright.sync_api import Page, expect

from tests.studio.support.changing import performed, place_of, select, whole_s
from tests.studio.support.waiting import wait_until


def _reasons(page: Page) -> str:
    """What the inspector says: the sentence, the rules and the numbers."""
    page.evaluate("document.querySelector('#numbers').open = true")
    return page.inner_text("#inspected")


def test_the_list_leads_to_reasons_rules_terms_and_losers(looked_at: Page) -> None:
    looked_at.click("#items li[title*='gesture NEGATION']")
    told = _reasons(looked_at)
    for part in (
        "have never seen",
        "show_negation",
        "agreement.rules:",
        "reading in context: negation",
        "scores higher",
    ):
        assert part in told
    looked_at.click("#reasons button:has-text('negation “never”')")
    assert "negation_word" in _reasons(looked_at)
    assert "the word “never”" in _reasons(looked_at)


def test_what_was_dropped_says_to_what_it_gave_way(looked_at: Page) -> None:
    looked_at.click("#alternatives")
    looked_at.locator("#items li.dropped[title*='head NOD']").first.click()
    assert "TILT_LEFT takes its place" in _reasons(looked_at)


def test_arrows_move_the_selection(looked_at: Page) -> None:
    looked_at.focus("#items")
    looked_at.keyboard.press("Home")
    looked_at.keyboard.press("ArrowDown")
    assert looked_at.get_attribute("#items li:nth-child(2)", "aria-selected") == "true"
    assert looked_at.get_attribute("#items", "aria-activedescendant") == "item-1"


def test_a_click_on_the_canvas_selects_and_the_ruler_moves_the_playhead(looked_at: Page) -> None:
    looked_at.click("#items li[title*='gesture NEGATION']")
    looked_at.keyboard.press("Home")
    looked_at.mouse.click(*place_of(looked_at, 4.0))
    wait_until(looked_at, "Math.abs(parseFloat(document.querySelector('#time').value) - 4) < 0.1")
    looked_at.mouse.click(*place_of(looked_at, 0.9, top_px=68))
    assert "never" in _reasons(looked_at)


def test_zooming_is_undone_by_the_whole_line(looked_at: Page) -> None:
    """Around the playhead, which is at the beginning. Times on the canvas are in whole milliseconds, so a quotient of
    two is off by one at most."""
    looked_at.focus("#stage-canvas")
    looked_at.keyboard.press("Home")
    whole = looked_at.get_attribute("#timeline-canvas", "data-stretch") or ""
    assert whole.endswith(" 0.000")
    assert float(whole.split()[0]) == pytest.approx(whole_s(looked_at), abs=0.005)
    looked_at.click("[aria-label='Zoom in']")
    looked_at.click("[aria-label='Zoom in']")
    seen_s, from_s = map(float, (looked_at.get_attribute("#timeline-canvas", "data-stretch") or "").split())
    assert seen_s == pytest.approx(float(whole.split()[0]) / 1.4**2, abs=0.001)
    assert from_s == 0.0
    looked_at.click("[aria-label='Whole line']")
    assert looked_at.get_attribute("#timeline-canvas", "data-stretch") == whole


def test_rows_unfold_and_grow_and_stay_so(opened: Page) -> None:
    before = opened.locator("#timeline-canvas").bounding_box()
    opened.click(".gutter button:has-text('Sounds')")
    opened.focus(".gutter button:has-text('Voice')")
    opened.keyboard.press("+")
    expect(opened.locator(".gutter button[data-row=phones]")).to_have_attribute("aria-expanded", "true")
    opened.reload()
    expect(opened.locator(".gutter button[data-row=phones]")).to_have_attribute("aria-expanded", "true")
    after = opened.locator("#timeline-canvas").bounding_box()
    assert before
    assert after
    assert after["height"] == pytest.approx(before["height"] + 8 + 10, abs=1)


def test_a_movement_is_copied_to_the_playhead_and_undone(opened: Page) -> None:
    shakes = opened.locator("#items li:not(.dropped)[title*='head SHAKE']")
    before = shakes.count()
    select(opened, "head SHAKE")
    opened.focus("#items")
    opened.keyboard.press("Control+c")
    stroke_s = 4.0
    opened.mouse.click(*place_of(opened, stroke_s))
    opened.keyboard.press("Control+v")
    performed(opened)
    expect(shakes).to_have_count(before + 1)
    opened.click("#undo")
    performed(opened)
    expect(shakes).to_have_count(before)


def test_j_k_and_l_play_as_in_other_timelines(looked_at: Page) -> None:
    looked_at.focus("#stage-canvas")
    looked_at.keyboard.press("End")
    looked_at.keyboard.press("j")
    wait_until(looked_at, "parseFloat(document.querySelector('#time').value) < 7")
    looked_at.keyboard.press("k")
    expect(looked_at.locator("#play")).to_have_text("Play")
    looked_at.keyboard.press("i")
    expect(looked_at.locator("#loop")).to_have_attribute("aria-pressed", "true")

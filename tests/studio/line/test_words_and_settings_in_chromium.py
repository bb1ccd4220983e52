"""When words are spoken, what hands do at them, whose hand moves, and the settings of the line: each change is
performed, undone and done again."""

from typing import Any

import pytest
from playwright.sync_api import Page, Response, expect

from tests.studio.support.changing import performed, place_of, select
from tests.studio.support.waiting import wait_until

SETTINGS = {"agitation": "high", "mode": "random", "seed": 5, "stillness": 1}
FIELDS = {"agitation": "Agitation", "mode": "Gestures from"}
WORDS_PX = 68
"""The middle of the lane of words on the timeline, at the lower edge of the wave."""
POSES = "document.querySelector('#stage-canvas').dataset.pose.split(' ')"
"""Wrists of the line's own, then those of the other version, each counted from where it stands."""


def _answer(response: Response) -> dict[str, Any]:
    performance: dict[str, Any] = response.json()["performance"]
    return performance


def _kept(performance: dict[str, Any]) -> list[tuple[str, str, float]]:
    behaviors = [each for each in performance["behaviors"] if each["kept"]]
    return [(each["kind"], each["lexeme"], each["sync"]["start"]) for each in behaviors]


def _set(page: Page, name: str, value: object) -> None:
    if name in FIELDS:
        page.select_option(f"#project label:has-text('{FIELDS[name]}') select", str(value))
    else:
        page.fill(f"#{name}", str(value))
        page.press(f"#{name}", "Tab")


def test_an_edge_of_a_word_is_dragged_and_the_performance_follows(opened: Page) -> None:
    """The end of "lights" is put earlier: that of the word, of its last phone, and of what is meant by it."""
    select(opened, "word lights")
    end_s = float(opened.input_value("#word-end"))
    x, y = place_of(opened, end_s, WORDS_PX)
    earlier, _y = place_of(opened, end_s - 0.15, WORDS_PX)
    answers: list[dict[str, Any]] = []
    opened.on("response", lambda each: answers.append(each.json()) if each.url.endswith("/perform") else None)
    opened.mouse.move(x - 1, y)
    opened.mouse.down()
    opened.mouse.move((x + earlier) / 2 - 1, y, steps=3)
    opened.mouse.move(earlier - 1, y, steps=3)
    opened.mouse.up()
    wait_until(opened, f"document.querySelector('#word-end').value < {end_s - 0.12}")
    performed(opened)
    opened.wait_for_timeout(100)
    now = answers[-1]["performance"]
    word = next(each for each in now["words"] if each["text"] == "lights")
    assert word["end_s"] == pytest.approx(end_s - 0.15, abs=0.012)
    assert [phone["end_s"] for phone in word["phones"]][-1] == pytest.approx(word["end_s"], abs=0.012)
    meant_until_s = {each["end_s"] for each in now["functions"]}
    assert word["end_s"] in meant_until_s
    assert end_s not in meant_until_s
    opened.click("#undo")
    wait_until(opened, f"document.querySelector('#word-end').value == {end_s}")


def test_a_gesture_has_another_hand_is_muted_and_a_word_is_still(opened: Page) -> None:
    """The first sentence denies and points, the second asks and gathers all. A still word has no gesture. Undone
    to the beginning and done again it is the same."""
    made = opened.locator("#items li:not(.dropped)[title*='gesture']")
    left = opened.locator("#items li:not(.dropped)[title='gesture NEGATION (left)']")
    right = opened.locator("#items li:not(.dropped)[title='gesture NEGATION (right)']")
    question = opened.locator("#items li:not(.dropped)[title*='gesture QUESTION']")
    muted = opened.locator("#items li.dropped[title*='gesture QUESTION']")
    expect(made).to_have_count(4)
    select(opened, "gesture NEGATION")
    opened.select_option("#selected label:has-text('Hand') select", "left")
    expect(left).to_have_count(1)
    select(opened, "gesture QUESTION")
    opened.click("#mute")
    expect(muted).to_contain_text("muted by the author")
    expect(opened.locator("#mute")).to_have_attribute("aria-pressed", "true")
    expect(made).to_have_count(3)
    select(opened, "word never")
    opened.select_option("#word-mark", "still")
    expect(left).to_have_count(0)
    expect(right).to_have_count(0)
    expect(made).to_have_count(2)
    expect(muted).to_contain_text("muted by the author")
    select(opened, "gesture QUESTION (right), dropped")
    opened.click("#mute")
    expect(question).to_have_count(1)
    expect(made).to_have_count(3)
    for _change in range(4):
        opened.click("#undo")
    expect(opened.locator("#undo")).to_be_disabled()
    expect(right).to_have_count(1)
    expect(made).to_have_count(4)
    for _change in range(3):
        opened.click("#redo")
    expect(right).to_have_count(0)
    expect(made).to_have_count(2)
    expect(muted).to_contain_text("muted by the author")
    opened.click("#redo")
    expect(opened.locator("#redo")).to_be_disabled()
    expect(question).to_have_count(1)
    expect(made).to_have_count(3)


def test_each_setting_of_the_line_is_performed_and_undone(page: Page) -> None:
    with page.expect_response("**/perform") as first:
        page.goto("/?line=example")
    usual = _answer(first.value)
    for name, value in SETTINGS.items():
        with page.expect_response("**/perform") as changed:
            _set(page, name, value)
        performance = _answer(changed.value)
        assert performance.get(name, value) == value
        if name != "stillness":
            assert _kept(performance) != _kept(usual), name
        performed(page)
        with page.expect_response("**/perform") as undone:
            page.click("#undo")
        assert _kept(_answer(undone.value)) == _kept(usual)
        performed(page)


def test_versions_stand_in_time_with_each_other(opened: Page) -> None:
    """One that was kept, and each of the modes: both bodies are at the time of the playhead."""
    opened.click("#tab-taken")
    opened.click("#keep-version")
    expect(opened.locator("#compared")).to_contain_text("0 only here, 0 only there")
    select(opened, "gesture NEGATION")
    opened.click("#delete")
    expect(opened.locator("#compared")).to_contain_text("0 only here, 1 only there")
    opened.focus("#stage-canvas")
    for _step in range(3):
        opened.keyboard.press("Shift+ArrowRight")
    wait_until(opened, f"String({POSES}.slice(0, 6)) !== String({POSES}.slice(6))")
    opened.click("#undo")
    wait_until(opened, "document.querySelector('#compared').textContent.includes('0 only there')")
    wait_until(opened, f"String({POSES}.slice(0, 6)) === String({POSES}.slice(6))")
    opened.click("#tab-taken")
    for mode in ("semantic", "prosody", "random"):
        opened.select_option("#compare-with", mode)
        expect(opened.locator("#compared")).to_contain_text("movements are the same")
        same = "0 only here, 0 only there" in opened.inner_text("#compared")
        assert same == (mode == "semantic")

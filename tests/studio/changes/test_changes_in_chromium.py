"""A line changed in the page: by mouse and by keyboard, undone, saved as the command line reads it, and compared."""

import json
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.studio.support.changing import performed, place_of, select
from tests.studio.support.waiting import wait_until
from understudy.cli.main import main

EXAMPLES = Path(__file__).parents[3] / "examples"
STAGE_S = "Number(document.querySelector('#stage-canvas').dataset.time)"
STROKE = "document.querySelector('#selected input[data-mark=stroke]')"
LINE = (str(EXAMPLES / "example.flac"), "--text-file", str(EXAMPLES / "example.txt"))


def _mark_s(page: Page, mark: str) -> float:
    return float(page.locator(f"#selected input[data-mark={mark}]").input_value())


def _pose(page: Page) -> str:
    return page.get_attribute("#stage-canvas", "data-pose") or ""


def _saved(page: Page, folder: Path) -> Path:
    page.click("#tab-exports")
    with page.expect_download() as download:
        page.click("#save-edits")
    path = folder / download.value.suggested_filename
    download.value.save_as(path)
    return path


def test_a_mark_is_moved_by_mouse_the_motion_changes_and_is_undone(looked_at: Page) -> None:
    select(looked_at, "gesture NEGATION")
    before_s = _mark_s(looked_at, "stroke")
    y = _row_of_gestures(looked_at)
    wait_until(looked_at, f"Math.abs({STAGE_S} - {before_s}) < 0.002")
    pose = _pose(looked_at)
    x, _ruler = place_of(looked_at, before_s)
    further, _ruler = place_of(looked_at, before_s + 0.6)
    looked_at.mouse.move(x, y)
    looked_at.mouse.down()
    looked_at.mouse.move((x + further) / 2, y, steps=3)
    looked_at.mouse.move(further, y, steps=3)
    looked_at.mouse.up()
    expect(looked_at.locator("#undo")).to_be_enabled()
    wait_until(looked_at, f"Math.abs({STROKE}.value - {before_s}) > 0.5")
    assert _mark_s(looked_at, "stroke") == pytest.approx(before_s + 0.6, abs=0.05)
    expect(looked_at.locator("#stage-canvas")).not_to_have_attribute("data-pose", pose)
    while looked_at.locator("#undo").is_enabled():
        looked_at.click("#undo")
    wait_until(looked_at, f"Math.abs({STROKE}.value - {before_s}) < 0.002")
    select(looked_at, "gesture NEGATION")
    expect(looked_at.locator("#stage-canvas")).to_have_attribute("data-pose", pose)


def _row_of_gestures(page: Page) -> float:
    """The height at which gestures lie: found by clicking down the timeline until one is selected."""
    stroke_s = _mark_s(page, "stroke")
    for top_px in range(30, 400, 6):  # below the ruler
        x, y = place_of(page, stroke_s - 0.1, top_px)
        page.mouse.click(x, y)
        if page.locator("#selected h3[title^='gesture NEGATION']").count():
            return y
    raise AssertionError("no gesture is on the timeline")


def test_what_is_saved_makes_the_same_on_the_command_line(opened: Page, tmp_path: Path) -> None:
    """By keyboard alone: a gesture is moved and made larger, another movement is deleted, a word is marked."""
    select(opened, "gesture NEGATION")
    stroke_s = _mark_s(opened, "stroke")
    opened.keyboard.press("Alt+Shift+ArrowRight")
    wait_until(opened, f"{STROKE}.value > {stroke_s} + 0.05")
    opened.locator("#size").fill("0.9")
    performed(opened)
    select(opened, "head SHAKE")
    opened.locator("#items").focus()
    opened.keyboard.press("Delete")
    expect(opened.locator("#items li", has_text="deleted by the author")).to_have_count(1)
    select(opened, "word lights")
    opened.locator("#word-mark").select_option("important")
    performed(opened)
    edits = _saved(opened, tmp_path)
    told = json.loads(edits.read_text(encoding="utf-8"))
    assert [sorted(edit) for edit in told["behaviors"]] == [["amount", "hand", "lexeme", "marks", "of"], ["of", "omit"]]
    out = tmp_path / "line.bml"
    assert main(["perform", *LINE, "--edits", str(edits), "-o", str(out)]) == 0
    assert _bml(opened) == out.read_bytes()


def test_quick_changes_are_all_made_and_meet_no_full_service(opened: Page) -> None:
    select(opened, "gesture NEGATION")
    stroke_s = _mark_s(opened, "stroke")
    for _press in range(6):
        opened.keyboard.press("Alt+Shift+ArrowRight")
    performed(opened)
    wait_until(opened, f"Math.abs({STROKE}.value - {stroke_s} - 0.6) < 0.02")
    expect(opened.locator("#problem")).to_be_hidden()


def _bml(page: Page) -> bytes:
    """The BML of the page's own last answer."""
    with page.expect_response("**/perform") as answered:
        page.evaluate("document.querySelector('#seed').dispatchEvent(new Event('change'))")
    return str(answered.value.json()["bml"]).encode()


def test_a_gesture_that_was_replaced_stays_with_its_hand_and_its_stroke(opened: Page) -> None:
    select(opened, "gesture NEGATION")
    opened.click("#replace")
    expect(opened.locator("#gesture-family")).to_have_value("negation")
    opened.locator("#gesture-family").select_option("point_there")
    wait_until(opened, "document.querySelectorAll('#gesture-browser canvas[data-played]').length > 0")
    opened.click("#gesture-browser button[data-lexeme=POINT_FRONT]")
    expect(opened.locator("#selected h3")).to_have_text("Point ahead")
    expect(opened.locator("#lock")).to_have_attribute("aria-pressed", "true")
    expect(opened.locator("#why")).to_contain_text("You chose “Point ahead” here")
    performed(opened)
    stroke_s = _mark_s(opened, "stroke")
    about = opened.locator("#selected .about").inner_text()
    opened.select_option("#feeling", "angry")
    opened.select_option("#agitation", "high")
    opened.locator("#seed").fill("9")
    opened.keyboard.press("Tab")
    performed(opened)
    select(opened, "gesture POINT_FRONT")
    expect(opened.locator("#items li[title*='gesture POINT_FRONT']")).to_have_count(1)
    expect(opened.locator("#selected .about")).to_have_text(about)
    assert _mark_s(opened, "stroke") == pytest.approx(stroke_s, abs=0.002)


def test_a_gesture_is_added_on_a_word_and_taken_back(looked_at: Page) -> None:
    select(looked_at, "word best")
    looked_at.click("#add-gesture")
    looked_at.locator("#gesture-family").select_option("")
    looked_at.locator("#gesture-name").fill("precision")
    looked_at.click("#gesture-browser button[data-lexeme=PRECISION]")
    added = looked_at.locator("#items li:not(.dropped)[title*='gesture PRECISION']")
    added.first.click()
    looked_at.click("#take-back")
    expect(added).to_have_count(0)


def test_conflicts_are_shown_and_left_out(looked_at: Page, tmp_path: Path) -> None:
    edits = tmp_path / "other.edits.json"
    gone = {"of": {"channel": "gesture", "at": {"word": 0, "text": "Yes"}, "lexeme": "NOD"}, "omit": "muted"}
    edits.write_text(json.dumps({"version": 1, "behaviors": [gone]}), encoding="utf-8")
    looked_at.set_input_files("#edits-file", edits)
    conflict = looked_at.locator("#conflicts li[data-code=edit_word_gone]")
    expect(conflict).to_contain_text("the word 'Yes' is no longer in the line")
    conflict.locator("button").click()
    expect(conflict).to_have_count(0)


def test_a_wrong_file_of_edits_shows_its_mistakes(looked_at: Page, tmp_path: Path) -> None:
    for content, said in (
        ("{", "is no file of edits"),
        ('{"behaviors": [{}]}', "give either `of`, or both `add` and `on`"),
    ):
        path = tmp_path / "wrong.json"
        path.write_text(content)
        looked_at.set_input_files("#edits-file", path)
        expect(looked_at.locator("#problem")).to_contain_text(said)


def _has_names_in_a_row_on_the_stage(page: Page) -> None:
    expect(page.locator(".name-tag")).to_have_count(2)
    boxes = [each.bounding_box() for each in page.locator(".name-tag").all()]
    stage = page.locator("#stage-canvas").bounding_box()
    assert stage
    assert boxes[0]
    assert boxes[1]
    assert boxes[0]["y"] == pytest.approx(boxes[1]["y"], abs=1)
    assert boxes[0]["y"] < stage["y"] + stage["height"] / 3
    for box in boxes:
        assert box
        assert stage["x"] <= box["x"]
        assert box["x"] + box["width"] <= stage["x"] + stage["width"]


def test_another_version_stands_beside_this_one(opened: Page) -> None:
    opened.click("#tab-taken")
    opened.locator("#compare-with").select_option("prosody")
    expect(opened.locator("#stage-canvas")).to_have_attribute("data-roles", "speaker compared")
    expect(opened.locator("#compared")).to_contain_text("movements are the same")
    _has_names_in_a_row_on_the_stage(opened)
    other = opened.locator(".differences li", has_text="Gestures from the stress:").first
    stage_s = float(opened.get_attribute("#stage-canvas", "data-time") or 0)
    other.get_by_role("button").click()
    wait_until(opened, f"{STAGE_S} !== {stage_s}")
    opened.locator("#shot").select_option("over_shoulder")
    expect(opened.locator("#stage-canvas")).to_have_attribute("data-roles", "speaker")
    opened.locator("#shot").select_option("medium")
    expect(opened.locator("#stage-canvas")).to_have_attribute("data-roles", "speaker compared")
    opened.locator("#compare-with").select_option("none")
    expect(opened.locator("#stage-canvas")).to_have_attribute("data-roles", "speaker")

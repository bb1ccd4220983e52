"""The gesture editor by mouse and keyboard: what is composed is the text that it would be written as, nonsense cannot
be chosen, and a text that is wrong says where."""

from base64 import b64decode
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.studio.support.accessibility import serious_findings
from tests.studio.support.waiting import wait_until
from understudy.authoring.gesture_texts import one_gesture
from understudy.realizer.gestures.gesture import Definition
from understudy.realizer.gestures.writing import write_gesture

STOP = """\
GESTURECLASS emblem
GESTUREINSTANCE stop_there
DURATION 1.5
TRACK held chest 0 15 0
TRACK circling LowerArm 0 10 0 2 90
STARTFRAME 0.25
  FRAMETYPE stroke_start
  ARM XC YCC ZMiddle
ENDFRAME
STARTFRAME 0.425
  FRAMETYPE stroke
  ARM XC YUpperC ZFar
  HAND form_flat_out
  FINGER little bend_hooked
  WRIST FBUp PalmAway
  TENSION 0.5
  ADDNOISE
ENDFRAME
STARTFRAME 0.6
  FRAMETYPE stroke_end
  ARM XC YUpperC ZMiddle
ENDFRAME
"""


@pytest.fixture
def editor(page: Page) -> Page:
    page.goto("/")
    page.click("#views >> text=Gesture editor")
    page.wait_for_selector("#gesture-canvas[data-pose*='.']")
    return page


def _text(page: Page) -> str:
    return page.input_value("#gesture-text")


def _track(page: Page, number: int, values: dict[str, str]) -> None:
    """Adds an offset track, and makes it so."""
    page.click("#track-add")
    for name, value in values.items():
        field = page.get_by_label(f"Track {number}, {name}", exact=True)
        if name in {"form", "joint"}:
            field.select_option(value)
        else:
            field.fill(value)
            field.press("Tab")


def _direction(half: str, name: str) -> str:
    return f"#wrist [aria-label='{half}'] [data-direction='{name}']"


def _right_wrist(page: Page) -> list[float]:
    return [float(metres) for metres in (page.get_attribute("#gesture-canvas", "data-pose") or "").split()[3:]]


def test_a_gesture_that_is_composed_by_clicks_is_its_text(editor: Page) -> None:
    for field, value in (("name", "stop_there"), ("class", "emblem"), ("categories", "stop_there")):
        editor.fill(f"#gesture-{field}", value)
        editor.press(f"#gesture-{field}", "Tab")
    editor.focus(".key-time >> nth=0")
    editor.click("#frame-add")
    editor.click("[data-sector='XC YUpperC']")
    editor.click("[data-distance='ZFar']")
    editor.select_option("#hand-form", "form_flat")
    editor.select_option("#hand-thumb", "out")
    editor.select_option("[data-finger='little']", "bend_hooked")
    editor.click(_direction("Fingers point", "Up"))
    editor.click(_direction("Palm faces", "Away"))
    editor.fill("#curve-tension", "0.5")
    editor.check("#noise")
    _track(editor, 1, {"y, °": "15"})
    _track(editor, 2, {"form": "circling", "joint": "LowerArm", "turns": "2", "from, °": "90"})
    expected = one_gesture(STOP, None)
    wait_until(editor, "/ADDNOISE/.test(document.querySelector('#gesture-text').value)")
    wait_until(editor, "/LowerArm .* 90/.test(document.querySelector('#gesture-text').value)")
    assert one_gesture(_text(editor), None) == expected
    assert _text(editor) == write_gesture(expected)


def test_it_is_saved_and_opened_as_the_same_file(editor: Page, tmp_path: Path) -> None:
    file = tmp_path / "stop.gesture"
    file.write_text(STOP, encoding="utf-8")
    editor.set_input_files("#gesture-file", file)
    wait_until(editor, "document.querySelector('#gesture-name').value === 'stop_there'")
    with editor.expect_download() as download:
        editor.click("#gesture-save")
    assert download.value.suggested_filename == "stop_there.gesture"
    assert Path(download.value.path()).read_text(encoding="utf-8") == STOP
    written = STOP + "# Written last.\n"
    editor.fill("#gesture-text", written)
    with editor.expect_download() as download:
        editor.click("#gesture-save")
    assert Path(download.value.path()).read_text(encoding="utf-8") == written, "before anybody has checked it"


def test_what_makes_no_sense_cannot_be_chosen(editor: Page) -> None:
    """Palm up leaves the fingers away, inwards, outwards, towards and their sums (Gesture Engine §4.3)."""
    editor.click(_direction("Palm faces", "Up"))
    editor.wait_for_selector(_direction("Fingers point", "Down") + ":disabled")
    fingers = editor.locator("#wrist [aria-label='Fingers point'] .direction:not(:disabled)")
    possible = {fingers.nth(k).get_attribute("data-direction") or "" for k in range(fingers.count())}
    assert {"Away", "Inwards", "Outwards", "Towards"} <= possible
    assert not any("Up" in name or "Down" in name for name in possible)
    editor.select_option("#hand-form", label="Pinch, other fingers closed")
    expect(editor.locator("#hand-form")).to_have_attribute("title", "symbol_pinch in the gesture’s text")
    editor.wait_for_selector("#hand-thumb:disabled")
    editor.focus(".key-time >> nth=0")
    assert "hold" not in editor.inner_text("#frame-type")
    assert editor.is_disabled("#frame-remove")
    assert editor.is_disabled("#place-open")


def test_the_body_takes_the_pose_of_the_frame_at_once(editor: Page) -> None:
    editor.focus(".key-time >> nth=0")
    before = _right_wrist(editor)
    editor.click("[data-sector='XC YUpperP']")
    wait_until(editor, f"document.querySelector('#gesture-canvas').dataset.pose.split(' ')[4] > {before[1] + 0.15}")


def test_times_are_moved_by_the_keyboard_and_stay_between_their_neighbours(editor: Page) -> None:
    handle = editor.locator(".key-time >> nth=1")
    handle.focus()
    for _ in range(3):
        editor.keyboard.press("ArrowRight")
    assert editor.locator(".key-time >> nth=1").get_attribute("aria-valuenow") == "0.63"
    wait_until(editor, "document.querySelector('#gesture-text').value.includes('STARTFRAME 0.63')")
    editor.locator(".key-time >> nth=0").focus()
    for _ in range(40):
        editor.keyboard.press("ArrowRight")
    assert editor.locator(".key-time >> nth=0").get_attribute("aria-valuenow") == "0.62"
    editor.click("#undo")
    assert float(editor.locator(".key-time >> nth=0").get_attribute("aria-valuenow") or 1) < 0.62


def test_a_mistake_in_the_text_is_told_with_its_place_and_what_was_stays(editor: Page) -> None:
    editor.fill("#gesture-text", _text(editor).replace("ZMiddle", "ZMidle", 1))
    editor.wait_for_selector("#gesture-mistakes .wrong")
    lines = _text(editor).splitlines()
    line = next(number for number, text in enumerate(lines, start=1) if "ZMidle" in text)
    mistake = editor.locator("#gesture-mistakes .wrong", has_text="did you mean ZMiddle?")
    assert mistake.inner_text().startswith(f"{line}:{lines[line - 1].index('ZMidle') + 1} ")
    mistake.locator("button").click()
    start = sum(len(text) + 1 for text in lines[: line - 1]) + lines[line - 1].index("ZMidle")
    assert editor.evaluate("document.querySelector('#gesture-text').selectionStart") == start
    assert editor.locator("[data-distance='ZMiddle']").get_attribute("aria-pressed") == "true"


def test_it_is_played_at_three_agitations(editor: Page) -> None:
    """The more agitated, the larger: where the stroke ends, the wrist is higher above the middle of gesture space.

    Where it begins depends on how far it is wound up.
    """
    editor.focus(".key-time >> nth=1")
    heights = []
    for level in ("low", "medium", "high"):
        editor.select_option("#gesture-level", level)
        editor.wait_for_selector(f"#gesture-canvas[data-level='{level}']")
        heights.append(_right_wrist(editor)[1])
    assert heights == sorted(heights)
    assert heights[2] > heights[0] + 0.02
    editor.click("#gesture-play")
    pose = editor.get_attribute("#gesture-canvas", "data-pose")
    wait_until(editor, f"document.querySelector('#gesture-canvas').dataset.pose !== '{pose}'")


def test_a_pose_of_a_body_is_set_by_angles(editor: Page, tmp_path: Path) -> None:
    with editor.expect_response("**/gestures/motion"):
        editor.click("[data-sector='XP YUpperP']")
    body = editor.evaluate(
        """async () => {
            const text = document.querySelector("#gesture-text").value;
            const headers = { "content-type": "application/json", accept: "model/gltf-binary" };
            const body = JSON.stringify({ text, fps: 30 });
            const answer = await fetch("gestures/motion", { method: "POST", headers, body });
            const bytes = new Uint8Array(await answer.arrayBuffer());
            return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
        }"""
    )
    file = tmp_path / "posed.glb"
    file.write_bytes(b64decode(body))
    editor.fill("#pose-time", "1.2")
    editor.set_input_files("#pose-file", file)
    wait_until(editor, "document.querySelector('#pose-told').textContent.includes('UpperArm')")
    wait_until(editor, "document.querySelector('#gesture-text').value.includes('JOINT UpperArm')")
    definition: Definition = one_gesture(_text(editor), None)
    assert "LowerArm" in dict(definition.frames[0].leading.joints)


def test_a_gesture_of_the_library_is_opened(editor: Page) -> None:
    editor.fill("#gesture-library", "greeting_raised_hand")
    editor.press("#gesture-library", "Tab")
    wait_until(editor, "document.querySelector('#gesture-name').value === 'greeting_raised_hand'")
    assert "GESTUREINSTANCE greeting_raised_hand" in _text(editor)


def test_nobody_stumbles_over_the_editor(editor: Page) -> None:
    """With everything unfolded, one frame open and the other set; then with mistakes."""
    for folded in editor.locator("#gesture_editor details:not([open]) > summary").all():
        folded.click()
    editor.click(_direction("Palm faces", "Up"))
    editor.wait_for_selector(_direction("Fingers point", "Down") + ":disabled")
    assert serious_findings(editor) == []
    editor.fill("#gesture-text", _text(editor).replace("ZMiddle", "ZMidle", 1))
    editor.wait_for_selector("#gesture-mistakes .wrong")
    assert serious_findings(editor) == []

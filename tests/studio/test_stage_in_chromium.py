"""The line is performed when the page is opened with it, and played in time with its recording."""

from itertools import pairwise

from playwright.sync_api import Page

from tests.studio.waiting import wait_until

EXAMPLE_S = 7.18
FRAME_S = 1 / 60
SAMPLED = """
() => new Promise((resolve) => {
  const [canvas, audio] = [document.querySelector("#stage-canvas"), document.querySelector("audio")];
  const found = [];
  const look = () => {
    found.push([Number(canvas.dataset.time), audio.currentTime]);
    if (found.length < 30) requestAnimationFrame(look); else resolve(found);
  };
  requestAnimationFrame(look);
})
"""


def _pose(page: Page) -> list[float]:
    """Where the wrists are, metres."""
    return [float(metres) for metres in (page.get_attribute("#stage-canvas", "data-pose") or "").split()]


def _seconds(page: Page) -> float:
    return float(page.inner_text("#time").removesuffix(" s"))


def _roles(page: Page, roles: str) -> None:
    page.wait_for_selector(f"#stage-canvas[data-roles='{roles}']")


def test_the_example_is_performed_and_moves_when_it_is_played(opened: Page) -> None:
    assert "7.18 s" in opened.inner_text("#state")
    opened.click("#play")
    poses = [_pose(opened)]
    while _seconds(opened) < 1.5:
        poses.append(_pose(opened))
    opened.click("#play")
    assert {len(pose) for pose in poses} == {6}
    assert max(max(axis) - min(axis) for axis in zip(*poses, strict=True)) > 0.1
    assert _seconds(opened) < EXAMPLE_S


def test_what_is_shown_is_what_is_heard_to_the_frame(opened: Page) -> None:
    opened.click("#play")
    wait_until(opened, "document.querySelector('audio').currentTime > 0.2")
    samples = opened.evaluate(SAMPLED)  # how late includes the drawing, which takes SwiftShader more than a frame
    assert max(heard for _shown, heard in samples) > min(heard for _shown, heard in samples)
    late_s = [heard - shown for shown, heard in samples]
    assert -1e-6 <= min(late_s) <= FRAME_S
    assert max(late_s[-5:]) < max(late_s[:5]) + 5 * FRAME_S


def test_frames_are_stepped_by_button_and_key(opened: Page) -> None:
    for _ in range(3):
        opened.click("[aria-label='One frame on']")
    wait_until(opened, f"Math.abs(document.querySelector('#stage-canvas').dataset.time - {3 * FRAME_S}) < 1e-6")
    opened.click("#stage-canvas")
    opened.evaluate("document.activeElement.blur()")
    opened.keyboard.press("ArrowLeft")
    wait_until(opened, f"Math.abs(document.querySelector('#stage-canvas').dataset.time - {2 * FRAME_S}) < 1e-6")


def test_a_chosen_stretch_is_played_again_and_again(opened: Page) -> None:
    box = opened.locator("#timeline-canvas").bounding_box()
    assert box
    opened.mouse.move(box["x"] + 200, box["y"] + 40)
    opened.mouse.down()
    opened.mouse.move(box["x"] + 260, box["y"] + 40, steps=3)
    opened.mouse.up()
    assert opened.get_attribute("#loop", "aria-pressed") == "true"
    opened.click("#play")
    wait_until(opened, "document.querySelector('audio').currentTime > 0.5")
    times = [shown for _ in range(3) for shown, _heard in opened.evaluate(SAMPLED)]
    assert any(after < before for before, after in pairwise(times))
    assert max(times) < 2.5


def test_a_listener_stands_beside_or_instead(opened: Page) -> None:
    opened.select_option("#listening", "beside")
    _roles(opened, "speaker reserved")
    opened.select_option("#shot", "over_shoulder")
    opened.select_option("#listening", "instead")
    _roles(opened, "reserved")
    opened.click("#undo")
    opened.select_option("#listening", "none")
    _roles(opened, "speaker")


def test_another_character_has_another_body_and_can_be_undone(opened: Page) -> None:
    before = _pose(opened)
    opened.select_option("#project label:has-text('Character') select", "expansive")
    wait_until(opened, f"document.querySelector('#stage-canvas').dataset.pose.split(' ')[1] != {before[1]:.4f}")
    opened.click("#undo")
    wait_until(opened, f"document.querySelector('#stage-canvas').dataset.pose.split(' ')[1] == {before[1]:.4f}")

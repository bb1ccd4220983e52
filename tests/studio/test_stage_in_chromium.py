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
    found.push([Number(canvas.dataset.time), window.heard_s]);
    if (found.length < 30 && !audio.ended) requestAnimationFrame(look); else resolve(found);
  };
  requestAnimationFrame(look);
})
"""

HEARD = """
() => {
  const { get, set } = Object.getOwnPropertyDescriptor(HTMLMediaElement.prototype, "currentTime");
  const told = { get() { return (window.heard_s = get.call(this)); }, set(time_s) { set.call(this, time_s); } };
  Object.defineProperty(document.querySelector("audio"), "currentTime", told);
}
"""
"""Keeps what the recording says when it is asked where it is."""


def _pose(page: Page) -> list[float]:
    """Where the wrists are, metres."""
    return [float(metres) for metres in (page.get_attribute("#stage-canvas", "data-pose") or "").split()]


def _seconds(page: Page) -> float:
    return float(page.inner_text("#time").removesuffix(" s"))


def _roles(page: Page, roles: str) -> None:
    page.wait_for_selector(f"#stage-canvas[data-roles='{roles}']")


def test_the_example_is_performed_and_moves_when_it_is_played(opened: Page) -> None:
    assert "7.18 s" in opened.inner_text("#state")
    before = _pose(opened)
    assert len(before) == 6
    opened.click("#play")
    wrist = "document.querySelector('#stage-canvas').dataset.pose.split(' ')"
    wait_until(opened, f"{wrist}.some((metres, axis) => Math.abs(metres - {before}[axis]) > 0.1)")
    assert 0 < _seconds(opened) <= EXAMPLE_S


def test_each_frame_shows_what_was_heard_when_it_began(opened: Page) -> None:
    opened.evaluate(HEARD)
    opened.click("#play")
    wait_until(opened, "window.heard_s > 0.2")
    samples = [sample for sample in opened.evaluate(SAMPLED) if sample[0] < EXAMPLE_S - FRAME_S]
    assert len({heard for _shown, heard in samples}) > 1
    assert max(abs(shown - heard) for shown, heard in samples) < 1e-6


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
    times: list[float] = []
    while not any(after < before for before, after in pairwise(times)) and len(times) < 90:
        times += (shown for shown, _heard in opened.evaluate(SAMPLED))
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

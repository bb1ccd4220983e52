"""The line is performed when the page is opened with it, and played in time with its recording."""

from itertools import pairwise

import pytest
from playwright.sync_api import Page

from tests.studio.support.waiting import wait_until

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

COUNTED = """
() => {
  window.drawn = 0;
  for (const of of [WebGL2RenderingContext.prototype, CanvasRenderingContext2D.prototype]) {
    for (const name of ["drawElements", "drawArrays", "clear", "clearRect", "fillRect", "stroke", "fillText"]) {
      const own = of[name];
      if (own) of[name] = function (...given) { window.drawn += 1; return own.apply(this, given); };
    }
  }
}
"""
"""Counts what is drawn on canvases from now on."""


def _pose(page: Page) -> list[float]:
    """Where the wrists are, metres."""
    return [float(metres) for metres in (page.get_attribute("#stage-canvas", "data-pose") or "").split()]


def _seconds(page: Page) -> float:
    return float(page.inner_text("#time").removesuffix(" s"))


def _roles(page: Page, roles: str) -> None:
    page.wait_for_selector(f"#stage-canvas[data-roles='{roles}']")


@pytest.fixture
def rewound(looked_at: Page) -> Page:
    """Paused at the beginning, with nothing that is repeated."""
    looked_at.focus("#stage-canvas")
    looked_at.keyboard.press("k")
    if looked_at.get_attribute("#loop", "aria-pressed") == "true":
        looked_at.click("#loop")
    looked_at.focus("#stage-canvas")
    looked_at.keyboard.press("Home")
    wait_until(looked_at, "Number(document.querySelector('#stage-canvas').dataset.time) === 0")
    return looked_at


def test_the_example_is_performed_and_moves_when_it_is_played(rewound: Page) -> None:
    assert "7.18 s" in rewound.inner_text("#state")
    before = _pose(rewound)
    assert len(before) == 6
    rewound.click("#play")
    wrist = "document.querySelector('#stage-canvas').dataset.pose.split(' ')"
    wait_until(rewound, f"{wrist}.some((metres, axis) => Math.abs(metres - {before}[axis]) > 0.1)")
    assert 0 < _seconds(rewound) <= EXAMPLE_S


def test_each_frame_shows_what_was_heard_when_it_began(rewound: Page) -> None:
    rewound.evaluate(HEARD)
    rewound.click("#play")
    wait_until(rewound, "window.heard_s > 0.2")
    samples = [sample for sample in rewound.evaluate(SAMPLED) if sample[0] < EXAMPLE_S - FRAME_S]
    assert len({heard for _shown, heard in samples}) > 1
    assert max(abs(shown - heard) for shown, heard in samples) < 1e-6


def test_nothing_is_drawn_while_nothing_changes(rewound: Page) -> None:
    rewound.evaluate(COUNTED)
    rewound.wait_for_timeout(300)
    before = rewound.evaluate("window.drawn")
    rewound.wait_for_timeout(500)
    assert rewound.evaluate("window.drawn") == before
    rewound.keyboard.press("ArrowRight")
    wait_until(rewound, f"window.drawn > {before}")


def test_frames_are_stepped_by_button_and_key(rewound: Page) -> None:
    for _ in range(3):
        rewound.click("[aria-label='One frame on']")
    wait_until(rewound, f"Math.abs(document.querySelector('#stage-canvas').dataset.time - {3 * FRAME_S}) < 1e-6")
    rewound.click("#stage-canvas")
    rewound.evaluate("document.activeElement.blur()")
    rewound.keyboard.press("ArrowLeft")
    wait_until(rewound, f"Math.abs(document.querySelector('#stage-canvas').dataset.time - {2 * FRAME_S}) < 1e-6")


def test_a_chosen_stretch_is_played_again_and_again(rewound: Page) -> None:
    box = rewound.locator("#timeline-canvas").bounding_box()
    assert box
    rewound.mouse.move(box["x"] + 200, box["y"] + 40)
    rewound.mouse.down()
    rewound.mouse.move(box["x"] + 260, box["y"] + 40, steps=3)
    rewound.mouse.up()
    assert rewound.get_attribute("#loop", "aria-pressed") == "true"
    rewound.click("#play")
    wait_until(rewound, "document.querySelector('audio').currentTime > 0.5")
    times: list[float] = []
    while not any(after < before for before, after in pairwise(times)) and len(times) < 90:
        times += (shown for shown, _heard in rewound.evaluate(SAMPLED))
    assert any(after < before for before, after in pairwise(times))
    assert max(times) < 2.5


def test_a_listener_stands_beside_or_instead(rewound: Page) -> None:
    rewound.select_option("#listening", "beside")
    _roles(rewound, "speaker reserved")
    rewound.select_option("#shot", "over_shoulder")
    rewound.select_option("#listening", "instead")
    _roles(rewound, "reserved")
    rewound.click("#undo")
    rewound.select_option("#listening", "none")
    _roles(rewound, "speaker")


def test_another_character_has_another_body_and_can_be_undone(rewound: Page) -> None:
    before = _pose(rewound)
    rewound.select_option("#project label:has-text('Character') select", "expansive")
    wait_until(rewound, f"document.querySelector('#stage-canvas').dataset.pose.split(' ')[1] != {before[1]:.4f}")
    rewound.click("#undo")
    wait_until(rewound, f"document.querySelector('#stage-canvas').dataset.pose.split(' ')[1] == {before[1]:.4f}")


def test_without_a_graphics_card_what_moves_is_coarse_unless_it_is_wanted_otherwise(rewound: Page) -> None:
    page = rewound

    def want(quality: str) -> None:
        page.click("#stage .menu summary")
        page.select_option("#quality", quality)
        page.click("#stage-canvas")

    want("automatic")
    page.click("#play")
    page.wait_for_selector("#stage-canvas[data-detail='coarse']")
    page.click("#play")
    page.wait_for_selector("#stage-canvas[data-detail='fine']")
    want("high")
    page.click("#play")
    wait_until(page, "Number(document.querySelector('#stage-canvas').dataset.time) > 1")
    assert page.get_attribute("#stage-canvas", "data-detail") == "fine"
    page.click("#play")
    want("low")
    page.wait_for_selector("#stage-canvas[data-detail='coarse']")
    assert page.evaluate("localStorage.getItem('understudy-quality')") == "low"

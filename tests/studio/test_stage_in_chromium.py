"""The line is performed when the page is opened with it, and played in time with its recording."""

from playwright.sync_api import Page

EXAMPLE_S = 7.18


def _pose(page: Page) -> list[float]:
    """Where the wrists are, metres."""
    return [float(metres) for metres in (page.get_attribute("#stage-canvas", "data-pose") or "").split()]


def _seconds(page: Page) -> float:
    return float(page.inner_text("#time").removesuffix(" s"))


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

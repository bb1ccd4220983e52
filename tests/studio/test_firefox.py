"""The main task in Firefox: a line of one's own is performed, played in time with its sound, and changed."""

from pathlib import Path

import pytest

from tests.studio.support.firefox import FIREFOX, firefox_tab
from understudy.files import resource_folder

PLAYED_S = "Number(document.querySelector('#stage-canvas').dataset.time)"
STANDING = "document.querySelector('#stage-canvas[data-roles=speaker]')"


@pytest.mark.skipif(FIREFOX is None, reason="Firefox is not installed")
def test_a_line_of_ones_own_is_performed_played_and_changed(service_url: str, tmp_path: Path) -> None:
    example = resource_folder("examples")
    with firefox_tab(tmp_path) as tab:
        tab.go(service_url, width=1280, height=720)
        tab.set_files("#files", [example / "example.flac", example / "example.txt"])
        tab.wait_until(STANDING)
        assert tab.value("document.querySelector('#project .title h2').textContent") == "example.flac"
        tab.click("#play")
        tab.wait_until(f"{PLAYED_S} > 0.5")
        tab.wait_until("document.querySelector('audio').currentTime > 0.5")
        tab.click("#play")
        tab.click("#items li[title*='gesture NEGATION']")
        tab.click("#delete")
        tab.wait_until("document.querySelector('#undo:not(:disabled)')")
        tab.wait_until("document.querySelector('#items li.dropped')")
        assert tab.value("document.querySelector('#problem').hidden")

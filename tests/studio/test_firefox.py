"""The main task in Firefox: a line of one's own is performed, played in time with its sound, and changed. It encodes
films, too."""

from pathlib import Path

import pytest

from tests.studio.support.firefox import FIREFOX, firefox_tab
from understudy.files import resource_folder

PLAYED_S = "Number(document.querySelector('#stage-canvas').dataset.time)"
STANDING = "document.querySelector('#stage-canvas[data-roles=speaker]')"

FILMED_S = """
(async () => {
  const { canEncode, encodedFilm } = await import("./studio/exports/encoding.js");
  const canvas = new OffscreenCanvas(640, 360);
  const pen = canvas.getContext("2d");
  const context = new OfflineAudioContext(1, 24000, 48000);
  const tone = context.createOscillator();
  tone.connect(context.destination);
  tone.start();
  const sound = await context.startRendering();
  const draw = (time_s) => pen.fillRect(time_s * 100, 0, 50, 50);
  const film = (await canEncode(canvas, sound))
    ? await encodedFilm({ canvas, draw, length_s: 0.5, sound, heard_s: 0 }, () => undefined)
    : new Blob();
  const video = document.createElement("video");
  video.src = URL.createObjectURL(film);
  await new Promise((resolve, reject) => Object.assign(video, { onloadeddata: resolve, onerror: reject }));
  return video.duration;
})()
"""
"""The length of a film that is half a second long."""


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
        assert tab.value(FILMED_S) == 0.5

"""Costs of the studio page: first paint, frames a second, the script's share of one, its size, from change to motion.

    python -m benchmarks.studio [--url http://127.0.0.1:8000]

Chromium draws with SwiftShader, on the processor, so a whole frame takes long: frames a second are the stage's and the
timeline's while the line is played. The script's share is what a CPU profile
finds in JavaScript while the line is played, without the time inside of WebGL's own calls, which wait for SwiftShader.
Times are of the wall clock, medians of several: run it with nobody else on the machine.
"""

import argparse
import re
import shutil
import statistics
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from playwright.sync_api import Browser, Page, ViewportSize, sync_playwright

from benchmarks.figures import add_record_option, record
from understudy.studio.pages import FOLDER

FLAGS = ("--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
PLAYING = "--autoplay-policy=no-user-gesture-required"
LOADS = 5
CHANGES = 9
PLAYED_S = 3.0
PATIENCE_MS = 60_000

FIRST_PAINT = "() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? 0"
CHANGED = """
(seed) => new Promise((resolve) => {
  const canvas = document.querySelector("#stage-canvas");
  const before = canvas.dataset.casts;
  const started = performance.now();
  const field = document.querySelector("#seed");
  new MutationObserver((_, watching) => {
    if (canvas.dataset.casts !== before) {
      watching.disconnect();
      resolve(performance.now() - started);
    }
  }).observe(canvas, { attributes: true });
  field.value = String(seed);
  field.dispatchEvent(new Event("change"));
})
"""
FRAMES = """
(seconds) => new Promise((resolve) => {
  const canvas = document.querySelector("#stage-canvas");
  const shown = new Set();
  const end_ms = performance.now() + 1000 * seconds;
  const each = (now_ms) => {
    shown.add(canvas.dataset.time);
    if (now_ms < end_ms) {
      requestAnimationFrame(each);
    } else {
      resolve(shown.size);
    }
  };
  requestAnimationFrame(each);
})
"""
"""How many different moments of the line the stage shows."""


@contextmanager
def _served(url: str | None) -> Iterator[str]:
    """The address of a service: the given one, or one that is started for this."""
    if url:
        yield url
        return
    with TemporaryDirectory() as folder:
        log = Path(folder) / "log"
        with log.open("wb") as out:
            process = subprocess.Popen([sys.executable, "-m", "understudy.cli", "serve", "--port", "0"], stderr=out)
        try:
            while not (found := re.search(r"listening on (http://\S+)", log.read_text())):
                time.sleep(0.1)
            yield found[1]
        finally:
            process.terminate()
            process.wait()


def _opened(browser: Browser, url: str, query: str = "") -> Page:
    """The page in a browser that has none of its files yet."""
    page = browser.new_context(viewport=ViewportSize(width=1280, height=720), base_url=url).new_page()
    page.set_default_timeout(PATIENCE_MS)
    page.goto(f"/{query}")
    return page


def _first_paint_ms(browser: Browser, url: str) -> float:
    page = _opened(browser, url)
    page.wait_for_timeout(200)
    painted: float = page.evaluate(FIRST_PAINT)
    page.context.close()
    return painted


def _frames_a_second(page: Page) -> float:
    """Of stage and timeline while the line is played."""
    page.click("#play")
    page.wait_for_timeout(500)
    frames: float = page.evaluate(FRAMES, PLAYED_S)
    page.click("#play")
    return frames / PLAYED_S


def _script_ms_a_frame(page: Page) -> tuple[float, float, int]:
    """Script without and with drawing, milliseconds a frame, and how many frames there were."""
    session = page.context.new_cdp_session(page)
    session.send("Profiler.enable")
    session.send("Profiler.setSamplingInterval", {"interval": 200})
    page.press("#stage-canvas", "Home")
    page.click("#play")
    session.send("Profiler.start")
    frames: int = page.evaluate(FRAMES, PLAYED_S)
    profile = session.send("Profiler.stop")["profile"]
    spent = _self_ms_by_place(profile)
    drawing = sum(ms for (name, url), ms in spent.items() if name in NATIVE_DRAWING and url == "")
    script = sum(ms for (name, url), ms in spent.items() if name not in {"(idle)", "(program)", "(root)"})
    page.click("#play")
    return (script - drawing) / frames, script / frames, frames


NATIVE_DRAWING = frozenset(
    {"drawElements", "drawArrays", "drawElementsInstanced", "clear", "readPixels", "texSubImage2D"}
)
"""What WebGL does inside of a call, where SwiftShader may wait for the processor."""


def _self_ms_by_place(profile: dict) -> dict[tuple[str, str], float]:  # type: ignore[type-arg]
    places = {node["id"]: (node["callFrame"]["functionName"], node["callFrame"]["url"]) for node in profile["nodes"]}
    spent: dict[tuple[str, str], float] = {}
    for node, passed_us in zip(profile["samples"], profile["timeDeltas"], strict=True):
        spent[places[node]] = spent.get(places[node], 0.0) + passed_us / 1000
    return spent


def _changes_ms(page: Page) -> list[float]:
    """From a change in a field until the motion of the new performance is on the stage."""
    return [page.evaluate(CHANGED, seed) for seed in range(1, CHANGES + 1)]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--url", help="a service that runs already")
    add_record_option(parser)
    arguments = parser.parse_args()
    weight = sum(file.stat().st_size for file in FOLDER.rglob("*") if file.is_file())
    print(f"page weight        {weight / 1e6:6.2f} MB   (at most 2)")
    with _served(arguments.url) as url, sync_playwright() as playwright:
        chromium = shutil.which("chromium") or shutil.which("chromium-browser")
        browser = playwright.chromium.launch(executable_path=chromium, args=[*FLAGS, PLAYING])
        paints = [_first_paint_ms(browser, url) for _ in range(LOADS)]
        print(f"first paint        {statistics.median(paints):6.0f} ms   (at most 150; {LOADS} fresh loads)")
        page = _opened(browser, url, "?line=example")
        page.wait_for_selector("#stage-canvas[data-roles='speaker']")
        changes = _changes_ms(page)
        print(f"change to motion   {statistics.median(changes):6.0f} ms   (at most 300; worst {max(changes):.0f})")
        rate_hz = _frames_a_second(page)
        print(f"frames a second    {rate_hz:6.1f}      (at least 20, drawn on the processor)")
        script, whole, frames = _script_ms_a_frame(page)
        print(f"script a frame     {script:6.2f} ms   (at most 6; {whole:.2f} with WebGL's own, {frames} frames)")
        browser.close()
    if arguments.record:
        record("studio", "page weight", weight / 1e6, "MB", bar="≤ 2")
        record("studio", "first paint", statistics.median(paints), "ms", bar="≤ 150")
        record("studio", "change to motion, median", statistics.median(changes), "ms", bar="≤ 300")
        record("studio", "frames a second, without a graphics card", rate_hz, "", bar="≥ 20")
        record("studio", "script in a frame", script, "ms", bar="≤ 6")


if __name__ == "__main__":
    main()

"""The studio page in Debian's Chromium, against a service that is started once for all tests of a process.

`page` is a page that was not opened yet; when a test is over it fails where something went wrong in the page, or where
the page asked anybody but its own service. `opened` has performed the example line.
"""

import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from os import environ
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, ViewportSize, expect, sync_playwright

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--autoplay-policy=no-user-gesture-required",
)
SIZE = ViewportSize(width=1280, height=720)
PATIENCE_MS = 60_000
NOT_ASKED = ("data:", "blob:")


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Closed after each module: while playwright runs, nothing else in its process can run an event loop."""
    if CHROMIUM is None:
        pytest.skip("chromium is not installed")
    expect.set_options(timeout=PATIENCE_MS)
    with sync_playwright() as started:
        found = started.chromium.launch(executable_path=CHROMIUM, args=list(FLAGS))
        yield found
        found.close()


@pytest.fixture(scope="session")
def service_url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A service on a free port, with one worker."""
    log = tmp_path_factory.mktemp("service") / "log"
    command = [sys.executable, "-m", "understudy.cli", "serve", "--port", "0"]
    with log.open("wb") as out:
        process = subprocess.Popen(command, stderr=out, env=environ | {"UNDERSTUDY_WORKERS": "1"})
    try:
        yield _address(process, log)
    finally:
        process.terminate()
        process.wait()


@pytest.fixture
def page(browser: Browser, service_url: str) -> Iterator[Page]:
    faults: list[str] = []
    context = browser.new_context(viewport=SIZE, accept_downloads=True, base_url=service_url)
    made = context.new_page()
    made.set_default_timeout(PATIENCE_MS)
    made.on("pageerror", lambda error: faults.append(str(error)))
    made.on("request", lambda request: faults.extend(_elsewhere(request.url, service_url)))
    yield made
    context.close()
    assert faults == []


@pytest.fixture
def opened(page: Page) -> Page:
    page.goto("/?line=example")
    page.wait_for_selector("#stage-canvas[data-roles='speaker']")
    return page


def _elsewhere(url: str, service_url: str) -> list[str]:
    return [] if url.startswith((service_url, *NOT_ASKED)) else [f"asked for {url}"]


def _address(process: subprocess.Popen[bytes], log: Path) -> str:
    while process.poll() is None:
        found = re.search(r"listening on (http://\S+)", log.read_text())
        if found:
            return found[1]
        time.sleep(0.05)
    raise AssertionError(log.read_text())

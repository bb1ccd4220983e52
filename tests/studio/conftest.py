"""The studio page in Debian's Chromium, against a service that is started once for all tests of a process.

`page` is a page that was not opened yet; when a test is over it fails where something went wrong in the page, or where
the page asked anybody but its own service. `opened` has performed the example line, for one test; `looked_at` too, for
all tests of a module that leave the line as it is: a visit costs some four seconds of processor time.
"""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, ViewportSize, expect, sync_playwright

from tests.studio.support.serving import FLAGS, Theme, perform_scene, served
from understudy.models import Understudy

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
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
    with served(tmp_path_factory.mktemp("service") / "log") as address:
        yield address


@pytest.fixture(scope="session")
def scene(understudy: Understudy, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a scene that was performed."""
    return perform_scene(understudy, tmp_path_factory.mktemp("scene"))


@pytest.fixture
def page(browser: Browser, service_url: str) -> Iterator[Page]:
    with opened_page(browser, service_url) as made:
        yield made


@contextmanager
def opened_page(
    browser: Browser, service_url: str, size: ViewportSize | None = None, theme: Theme = "light"
) -> Iterator[Page]:
    """A page that was not opened yet; raises AssertionError at the end where something went wrong in it."""
    faults: list[str] = []
    context = browser.new_context(
        viewport=size or SIZE, color_scheme=theme, accept_downloads=True, base_url=service_url
    )
    context.add_init_script("localStorage.setItem('understudy-advanced', 'yes')")
    made = context.new_page()
    made.set_default_timeout(PATIENCE_MS)
    made.on("pageerror", lambda error: faults.append(str(error)))
    made.on("request", lambda request: faults.extend(_elsewhere(request.url, service_url)))
    yield made
    context.close()
    assert faults == []


@pytest.fixture(scope="module")
def looked_at(browser: Browser, service_url: str) -> Iterator[Page]:
    with opened_page(browser, service_url) as made:
        yield _with_example(made)


@pytest.fixture
def opened(page: Page) -> Page:
    return _with_example(page)


def _with_example(page: Page) -> Page:
    page.goto("/?line=example")
    page.wait_for_selector("#stage-canvas[data-roles='speaker']")
    return page


def _elsewhere(url: str, service_url: str) -> list[str]:
    return [] if url.startswith((service_url, *NOT_ASKED)) else [f"asked for {url}"]

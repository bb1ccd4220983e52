"""The studio page in Debian's Chromium, against a service that is started once for all tests of a process.

`page` is a page that was not opened yet, of which nothing is kept for the next test; when a test is over it fails where
something went wrong in the page, or where the page asked anybody but its own service. `opened` has performed the
example line, for one test; `looked_at` too, for all tests of a module that leave the line as it is. A visit costs some
three seconds of processor time, the first of a page seven: so two pages serve the whole package, one visit after the
other.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Error, Page, Request, ViewportSize, expect, sync_playwright

from tests.studio.support.serving import FLAGS, Theme, perform_scene
from tests.support.chromium import CHROMIUM
from tests.support.served import served
from understudy.api.workers.processes import Nursery
from understudy.models import Understudy

KEPT = "localStorage.setItem('understudy-advanced', 'yes'); localStorage.setItem('understudy-quality', 'low');"
"""All settings are there, and bodies are drawn coarsely, since nobody looks: that takes a fifth of the time."""
UNSEEN = """
for (const name of ["drawElements", "drawArrays"]) {
  const draw = WebGL2RenderingContext.prototype[name];
  WebGL2RenderingContext.prototype[name] = function (...given) {
    if (window.isSeen) draw.apply(this, given);
  };
}
"""
"""Nothing is drawn in 3-D until a test that looks at a picture sets `isSeen`: the rest of a frame is as ever."""
SIZE = ViewportSize(width=1280, height=720)
PATIENCE_MS = 60_000
NOT_ASKED = ("data:", "blob:")
STORED = "local_storage,indexeddb,cookies,cache_storage,service_workers"
"""What a page keeps in the browser, but for what belongs to its tab."""


@contextmanager
def chromium() -> Iterator[Browser]:
    """The browser. While playwright runs, nothing else in its process can run an event loop."""
    expect.set_options(timeout=PATIENCE_MS)
    with sync_playwright() as started:
        found = started.chromium.launch(executable_path=CHROMIUM, args=list(FLAGS))
        yield found
        found.close()


@pytest.fixture(scope="package")
def browser() -> Iterator[Browser]:
    """Closed after the package. Imported by a module elsewhere, it would last until the session ends."""
    with chromium() as found:
        yield found


@pytest.fixture(scope="session")
def service_url(nursery: Nursery) -> Iterator[str]:
    """A service on a free port, with one worker, in a thread of the tests."""
    with served(nursery) as running:
        yield running.url


@pytest.fixture(scope="session")
def scene(understudy: Understudy, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a scene that was performed."""
    return perform_scene(understudy, tmp_path_factory.mktemp("scene"))


@pytest.fixture(scope="package")
def visited(browser: Browser, service_url: str) -> Iterator[Page]:
    """A page for the visits of single tests."""
    with _new_page(browser, service_url) as made:
        yield made


@pytest.fixture(scope="package")
def long_visited(browser: Browser, service_url: str) -> Iterator[Page]:
    """A page for visits of several tests."""
    with _new_page(browser, service_url) as made:
        yield made


@pytest.fixture
def page(visited: Page, service_url: str) -> Iterator[Page]:
    with a_visit(visited, service_url):
        yield visited


@contextmanager
def opened_page(browser: Browser, service_url: str) -> Iterator[Page]:
    """A page for a single visit, which was not opened yet; raises AssertionError at the end where something went wrong
    in it."""
    with _new_page(browser, service_url) as made, _watched(made, service_url):
        yield made


@contextmanager
def a_visit(page: Page, service_url: str) -> Iterator[None]:
    """A visit to a page after which nothing is left of it; raises AssertionError as `opened_page` does. The browser
    keeps the scripts that it has compiled: the next visit takes four seconds of processor time less."""
    with _watched(page, service_url):
        yield
        page.goto("/healthz")
    page.evaluate("sessionStorage.clear()")
    devtools = page.context.new_cdp_session(page)
    devtools.send("Storage.clearDataForOrigin", {"origin": service_url, "storageTypes": STORED})
    devtools.detach()
    page.mouse.move(0, 0)
    look(page, SIZE, "light")


def look(page: Page, size: ViewportSize, theme: Theme) -> None:
    """How large the page is, and in which colours it is wanted."""
    page.set_viewport_size(size)
    page.emulate_media(color_scheme=theme)


@contextmanager
def _new_page(browser: Browser, service_url: str) -> Iterator[Page]:
    """A page of a browser that knows nothing yet."""
    context = browser.new_context(viewport=SIZE, color_scheme="light", accept_downloads=True, base_url=service_url)
    context.add_init_script(KEPT)
    context.add_init_script(UNSEEN)
    made = context.new_page()
    made.set_default_timeout(PATIENCE_MS)
    yield made
    context.close()


@contextmanager
def _watched(page: Page, service_url: str) -> Iterator[None]:
    """Raises AssertionError at the end where something went wrong in the page, or where it asked anybody else."""
    faults: list[str] = []

    def note_error(error: Error) -> None:
        faults.append(str(error))

    def note_request(request: Request) -> None:
        faults.extend(_elsewhere(request.url, service_url))

    page.on("pageerror", note_error)
    page.on("request", note_request)
    yield
    page.remove_listener("pageerror", note_error)
    page.remove_listener("request", note_request)
    assert faults == []


@pytest.fixture(scope="module")
def looked_at(long_visited: Page, service_url: str) -> Iterator[Page]:
    with a_visit(long_visited, service_url):
        yield _with_example(long_visited)


@pytest.fixture
def opened(page: Page) -> Page:
    return _with_example(page)


def _with_example(page: Page) -> Page:
    page.goto("/?line=example")
    page.wait_for_selector("#stage-canvas[data-roles='speaker']")
    return page


def _elsewhere(url: str, service_url: str) -> list[str]:
    return [] if url.startswith((service_url, *NOT_ASKED)) else [f"asked for {url}"]

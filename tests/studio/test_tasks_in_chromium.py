"""What people come to the studio for (docs/studio-tasks.md) can be done, and nothing serious is then in the way of
anybody: by turns on a large and a small screen in light and dark. `scripts/pictures.py` does all in every look."""

from collections.abc import Iterator, Mapping
from contextlib import ExitStack
from itertools import cycle
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from tests.studio.conftest import a_visit, new_page
from tests.studio.support.accessibility import findings_as_seen
from tests.studio.support.tasks import LOOKS, TASKS, Desk


@pytest.fixture(scope="module")
def pages(browser: Browser, service_url: str) -> Iterator[Mapping[str, Page]]:
    """A page for each look, for one visit after the other."""
    with ExitStack() as opened:
        yield {look: opened.enter_context(new_page(browser, service_url, *LOOKS[look])) for look in LOOKS}


@pytest.mark.parametrize(("task", "look"), list(zip(TASKS, cycle(LOOKS), strict=False)))
def test_a_task_is_done(
    pages: Mapping[str, Page], service_url: str, scene: Path, tmp_path: Path, *, task: str, look: str
) -> None:
    page = pages[look]
    with a_visit(page, service_url):
        TASKS[task](Desk(page, scene, tmp_path, look=lambda _step: None))
        width = page.evaluate("innerWidth")
        assert page.evaluate("document.documentElement.scrollWidth") <= width, "something is cut off at the side"
        assert findings_as_seen(page) == []

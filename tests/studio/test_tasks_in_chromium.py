"""What people come to the studio for (docs/studio-tasks.md) can be done, and nothing serious is then in the way of
anybody: by turns on a large screen in light and a small one in dark. `scripts/pictures.py` does all in every look."""

from itertools import cycle
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.studio.conftest import opened_page
from tests.studio.support.accessibility import findings_as_seen
from tests.studio.support.tasks import LOOKS, TASKS, Desk


@pytest.mark.parametrize(("task", "look"), list(zip(TASKS, cycle(("large-light", "small-dark")), strict=False)))
def test_a_task_is_done(
    browser: Browser, service_url: str, scene: Path, tmp_path: Path, *, task: str, look: str
) -> None:
    with opened_page(browser, service_url, *LOOKS[look]) as page:
        TASKS[task](Desk(page, scene, tmp_path, look=lambda _step: None))
        width = page.evaluate("innerWidth")
        assert page.evaluate("document.documentElement.scrollWidth") <= width, "something is cut off at the side"
        assert findings_as_seen(page) == []

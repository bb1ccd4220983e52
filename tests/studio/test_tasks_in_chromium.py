"""What people come to the studio for (docs/studio-tasks.md) can be done, and nothing serious is then in the way of
anybody: by turns on a large and a small screen in light and dark. `scripts/pictures.py` does all in every look."""

from itertools import cycle
from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.studio.conftest import look
from tests.studio.support.accessibility import findings_as_seen
from tests.studio.support.tasks import LOOKS, TASKS, Desk


@pytest.mark.parametrize(("task", "looks"), list(zip(TASKS, cycle(LOOKS), strict=False)))
def test_a_task_is_done(page: Page, scene: Path, tmp_path: Path, *, task: str, looks: str) -> None:
    look(page, *LOOKS[looks])
    TASKS[task](Desk(page, scene, tmp_path, look=lambda _step: None))
    width = page.evaluate("innerWidth")
    assert page.evaluate("document.documentElement.scrollWidth") <= width, "something is cut off at the side"
    assert findings_as_seen(page) == []

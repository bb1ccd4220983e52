"""Waits for what a page comes to. Playwright's own wait would evaluate in the page, which the page's policy forbids."""

import time

from playwright.sync_api import Page

PATIENCE_S = 60.0
POLLED_MS = 30


def wait_until(page: Page, expression: str) -> None:
    """Returns when a JavaScript expression is true in the page."""
    end_s = time.monotonic() + PATIENCE_S
    while not page.evaluate(expression):
        assert time.monotonic() < end_s, f"never so: {expression}"
        page.wait_for_timeout(POLLED_MS)

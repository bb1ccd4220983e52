"""Waits for what a page comes to. Playwright's own wait would evaluate in the page, which the page's policy forbids."""

import time

from playwright.sync_api import Page

PATIENCE_S = 60.0
FIRST_MS, LONGEST_MS = 20.0, 120.0
"""How long is waited between two looks: ever longer, since each look takes some milliseconds of four processes."""


def wait_until(page: Page, expression: str) -> None:
    """Returns when a JavaScript expression is true in the page."""
    end_s, pause_ms = time.monotonic() + PATIENCE_S, FIRST_MS
    while not page.evaluate(expression):
        assert time.monotonic() < end_s, f"never so: {expression}"
        page.wait_for_timeout(pause_ms)
        pause_ms = min(1.4 * pause_ms, LONGEST_MS)

"""What axe-core finds in a page that people with a keyboard or a screen reader would stumble over."""

from typing import Any

from axe_playwright_python.base import AXE_SCRIPT
from playwright.sync_api import Page

GRAVE = frozenset({"serious", "critical"})
CONTRAST = {"runOnly": {"type": "rule", "values": ["color-contrast"]}}
"""All that the theme changes is colours."""
ALONE = {"resultTypes": ["violations"]}
"""What is as it should be is not told element by element: that takes five times as long."""


def serious_findings(page: Page) -> list[str]:
    """The serious and critical violations in what is seen, in light, and of contrast also in dark: each rule with the
    elements that break it."""
    return [*_findings(page, "dark", CONTRAST), *_findings(page, "light", {})]


def findings_as_seen(page: Page) -> list[str]:
    """The same in the theme that is shown."""
    theme = page.evaluate("matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'")
    return _findings(page, theme, {})


def _findings(page: Page, theme: str, options: dict[str, Any]) -> list[str]:
    page.evaluate("(theme) => { document.documentElement.dataset.theme = theme; }", theme)
    if not page.evaluate("'axe' in window"):
        page.evaluate(AXE_SCRIPT)
    found = page.evaluate("async (options) => (await axe.run(options)).violations", options | ALONE)
    return [
        f"{theme}: {violation['id']}: {', '.join(str(node['target']) for node in violation['nodes'])}"
        for violation in found
        if violation["impact"] in GRAVE
    ]

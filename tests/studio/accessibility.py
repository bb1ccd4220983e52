"""What axe-core finds in a page that people with a keyboard or a screen reader would stumble over."""

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page

GRAVE = frozenset({"serious", "critical"})

in_light_and_dark = pytest.mark.parametrize("theme", ["light", "dark"])


def choose_theme(page: Page, theme: str) -> None:
    page.select_option("#preferences select", theme)


def serious_findings(page: Page) -> list[str]:
    """The serious and critical violations in what is seen: each rule with the elements that break it."""
    found = Axe().run(page).response["violations"]
    return [
        f"{violation['id']}: {', '.join(str(node['target']) for node in violation['nodes'])}"
        for violation in found
        if violation["impact"] in GRAVE
    ]

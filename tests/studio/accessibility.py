"""What axe-core finds in a page that people with a keyboard or a screen reader would stumble over."""

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page

GRAVE = frozenset({"serious", "critical"})


def serious_findings(page: Page, selector: str) -> list[str]:
    """The serious and critical violations in what `selector` finds: each rule with the elements that break it."""
    found = Axe().run(page, context=selector).response["violations"]
    return [
        f"{violation['id']}: {', '.join(str(node['target']) for node in violation['nodes'])}"
        for violation in found
        if violation["impact"] in GRAVE
    ]

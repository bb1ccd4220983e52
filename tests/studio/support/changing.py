"""How tests change a line in the page: what is selected, where times are on the timeline, when a change is answered."""

from playwright.sync_api import Page

from tests.studio.support.waiting import wait_until


def select(page: Page, text: str) -> None:
    """By what the service calls it: "gesture NEGATION", "word lights"."""
    page.locator(f"#items li[title*='{text}']").first.click()


def place_of(page: Page, time_s: float, top_px: float = 8.0) -> tuple[float, float]:
    """Where a time is on the timeline when all of it is seen: on the ruler, unless lower."""
    box = page.locator("#timeline-canvas").bounding_box()
    assert box is not None
    return box["x"] + 104 + time_s / whole_s(page) * (box["width"] - 114), box["y"] + top_px


def whole_s(page: Page) -> float:
    """When the last thing on the timeline is over."""
    ends = page.locator("#items li").all_inner_texts()
    return max(7.18, *(float(text.split("–")[1].split(" s")[0]) for text in ends))


def performed(page: Page) -> None:
    """Waits until the service has answered the last change."""
    page.wait_for_timeout(50)
    wait_until(page, "!document.querySelector('#state').textContent.startsWith('Performing')")

"""Time from a change in the studio until its new motion is shown, in Chromium with a service of its own.

A gesture of the bundled line (7.18 s) is moved by the field of a mark, again and again, each time with its edits, its
performance, its BML and its motion. Printed are milliseconds from the change to the motion in the page, and of the two
requests within, the page's own share, and the processor time that the service takes for a change,
which is the same on a busy machine.

    python -m benchmarks.api.changing_a_line
"""

import statistics
from contextlib import ExitStack

from playwright.sync_api import Page, sync_playwright

from tests.studio.conftest import SIZE
from tests.studio.support.serving import FLAGS
from tests.studio.support.waiting import wait_until
from tests.support.chromium import CHROMIUM

from .watching import HOST, Running, percentile, serving

CHANGES = 20
WARMING = 3
STEP_S = 0.04

CHANGE = """(field) => {
  const mark = document.querySelector(`#selected input[data-mark=${field.mark}]`);
  globalThis.changed = null;
  performance.clearResourceTimings();
  const begun_ms = performance.now();
  new MutationObserver((_, observer) => {
    observer.disconnect();
    const requests = performance.getEntriesByType("resource")
      .map(({ name, duration }) => [new URL(name).pathname, duration]);
    globalThis.changed = { whole: performance.now() - begun_ms, ...Object.fromEntries(requests) };
  }).observe(document.querySelector("#selected"), { childList: true });
  mark.value = String(Number(mark.value) + field.later_s);
  mark.dispatchEvent(new Event("change"));
}"""


def main() -> None:
    with ExitStack() as stack:
        service = stack.enter_context(serving({"workers": "1"}))
        browser = stack.enter_context(sync_playwright()).chromium.launch(executable_path=CHROMIUM, args=list(FLAGS))
        page = browser.new_context(viewport=SIZE, base_url=f"http://{HOST}:{service.port}").new_page()
        page.goto("/?line=example")
        page.wait_for_selector("#stage-canvas[data-roles='speaker']")
        page.locator("#items li[title*='gesture NEGATION']").first.click()
        for mark in ("stroke", "relax"):
            for number in range(WARMING):
                _changed(page, mark, number)
            begun_s = _processor_s(service)
            found = [_changed(page, mark, WARMING + number) for number in range(CHANGES)]
            _tell(mark, found, (_processor_s(service) - begun_s) / CHANGES)
        browser.close()


def _changed(page: Page, mark: str, number: int) -> dict[str, float]:
    """One change and back again, by turns."""
    later_s = STEP_S if number % 2 == 0 else -STEP_S
    page.evaluate(CHANGE, {"mark": mark, "later_s": later_s})
    wait_until(page, "globalThis.changed")
    found: dict[str, float] = page.evaluate("globalThis.changed")
    return found


def _processor_s(service: Running) -> float:
    """The processor time that the service and its processes have taken."""
    times = [each.cpu_times() for each in service.family()]
    return sum(each.user + each.system for each in times)


def _tell(mark: str, found: list[dict[str, float]], processor_s: float) -> None:
    own = [each["whole"] - each["/perform"] - each["/realize"] for each in found]
    parts = {name: [each[name] for each in found] for name in ("whole", "/perform", "/realize")} | {"page": own}
    told = ", ".join(f"{name} {statistics.median(times):.0f} ms" for name, times in parts.items())
    most_ms = percentile(tuple(parts["whole"]), 95)
    print(
        f"{mark}: median {told}; 95 % within {most_ms:.0f} ms; {1000 * processor_s:.0f} ms of the service's processors"
    )


if __name__ == "__main__":
    main()

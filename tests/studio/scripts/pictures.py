"""Takes the pictures of docs/studio-tasks.md: `python -m tests.studio.scripts.pictures docs/images/studio/tasks`.

Each task (../support/tasks.py) is done in one look, by turns as its test does, with a picture of what it comes to; with
`--steps` or `--look` in each look (or those that are named), with a picture of every step.
"""

import argparse
import base64
from collections.abc import Callable, Iterable
from itertools import cycle, product
from pathlib import Path
from tempfile import TemporaryDirectory

from playwright.sync_api import Browser, Page, expect, sync_playwright

from tests.studio.conftest import PATIENCE_MS
from tests.studio.support.serving import FLAGS, perform_scene, served
from tests.studio.support.tasks import LOOKS, TASKS, Desk
from tests.support.chromium import CHROMIUM
from understudy.models import Understudy
from understudy.settings import Settings

QUALITY = 0.8
SETTLED_MS = 400
AS_WEBP = """
async ([png, quality]) => {
  const image = new Image();
  image.src = `data:image/png;base64,${png}`;
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
  canvas.getContext("2d").drawImage(image, 0, 0);
  return canvas.toDataURL("image/webp", quality).split(",")[1];
}
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--steps", action="store_true", help="a picture of every step, in all looks")
    parser.add_argument("--look", action="append", choices=list(LOOKS), help="a picture of every step in this look")
    parser.add_argument("--task", action="append", choices=list(TASKS))
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    expect.set_options(timeout=PATIENCE_MS)
    with TemporaryDirectory() as folder, served(Path(folder, "log")) as address, sync_playwright() as started:
        Path(folder, "scene").mkdir()
        with Understudy.load(Settings()) as understudy:
            scene = perform_scene(understudy, Path(folder, "scene"))
        browser = started.chromium.launch(executable_path=CHROMIUM, args=list(FLAGS))
        desk = Desk(browser.new_page(), scene, Path(folder), look=print)
        for name, look in _asked_for(asked):
            steps = _steps(browser, address, desk, task=name, look=look)
            number = list(TASKS).index(name) + 1
            named = {f"{number:02}-{name}-{step}-{look}": png for step, png in steps.items()}
            for told, png in (named if _is_whole(asked) else {name: steps[_telling(name, steps)]}).items():
                webp = desk.page.evaluate(AS_WEBP, [base64.b64encode(png).decode(), QUALITY])
                (asked.out / f"{told}.webp").write_bytes(base64.b64decode(webp))
        browser.close()


def _telling(task: str, steps: Iterable[str]) -> str:
    """The step that tells most of a task: the last, but where that leads elsewhere."""
    return "scene" if task == "table_read" else list(steps)[-1]


def _is_whole(asked: argparse.Namespace) -> bool:
    """Whether every step is asked for, not the last alone."""
    return bool(asked.steps or asked.look)


def _asked_for(asked: argparse.Namespace) -> list[tuple[str, str]]:
    """The tasks, each with a look in which it is to be done."""
    by_turns = list(zip(TASKS, cycle(LOOKS), strict=False))
    pairs = list(product(TASKS, asked.look or LOOKS)) if _is_whole(asked) else by_turns
    return [(name, look) for name, look in pairs if not asked.task or name in asked.task]


def _steps(browser: Browser, address: str, desk: Desk, *, task: str, look: str) -> dict[str, bytes]:
    """Pictures of the steps of a task, PNG."""
    size, theme = LOOKS[look]
    context = browser.new_context(viewport=size, color_scheme=theme, base_url=address, reduced_motion="reduce")
    page = context.new_page()
    page.set_default_timeout(PATIENCE_MS)
    steps: dict[str, bytes] = {}
    TASKS[task](Desk(page, desk.scene, desk.folder, look=_keeper(page, steps)))
    context.close()
    return steps


def _keeper(page: Page, steps: dict[str, bytes]) -> Callable[[str], None]:
    def keep(step: str) -> None:
        page.wait_for_timeout(SETTLED_MS)
        steps[step] = page.screenshot()

    return keep


if __name__ == "__main__":
    main()

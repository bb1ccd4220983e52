"""Takes the pictures of docs/studio-tasks.md: `python -m tests.studio.scripts.pictures docs/images/studio/tasks`.

Each task (../support/tasks.py) is done in each look, with a picture of its last step; with `--steps` of every one.
"""

import argparse
import base64
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from playwright.sync_api import Browser, Page, expect, sync_playwright

from tests.studio.conftest import CHROMIUM, PATIENCE_MS
from tests.studio.support.serving import FLAGS, perform_scene, served
from tests.studio.support.tasks import LOOKS, TASKS, Desk
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
    parser.add_argument("--steps", action="store_true", help="a picture of every step")
    parser.add_argument("--look", action="append", choices=list(LOOKS), help="all, unless some are named")
    parser.add_argument("--task", action="append", choices=list(TASKS))
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    expect.set_options(timeout=PATIENCE_MS)
    with TemporaryDirectory() as folder, served(Path(folder, "log")) as address, sync_playwright() as started:
        Path(folder, "scene").mkdir()
        with Understudy.load(Settings()) as understudy:
            scene = perform_scene(understudy, Path(folder, "scene"))
        browser = started.chromium.launch(executable_path=CHROMIUM, args=list(FLAGS))
        for look in asked.look or LOOKS:
            _take(browser, address, look, asked, Desk(browser.new_page(), scene, Path(folder), look=print))
        browser.close()


def _take(browser: Browser, address: str, look: str, asked: argparse.Namespace, desk: Desk) -> None:
    """The pictures of all tasks in one look; `desk.page` is where they are made smaller."""
    size, theme = LOOKS[look]
    for number, (name, task) in enumerate(TASKS.items(), start=1):
        if asked.task and name not in asked.task:
            continue
        context = browser.new_context(viewport=size, color_scheme=theme, base_url=address, reduced_motion="reduce")
        page = context.new_page()
        page.set_default_timeout(PATIENCE_MS)
        steps: dict[str, bytes] = {}
        task(Desk(page, desk.scene, desk.folder, look=_keeper(page, steps)))
        context.close()
        for step, png in steps.items() if asked.steps else list(steps.items())[-1:]:
            told = f"{number:02}-{name}-{step}-{look}" if asked.steps else f"{name}-{look}"
            webp = desk.page.evaluate(AS_WEBP, [base64.b64encode(png).decode(), QUALITY])
            (asked.out / f"{told}.webp").write_bytes(base64.b64decode(webp))


def _keeper(page: Page, steps: dict[str, bytes]) -> Callable[[str], None]:
    def keep(step: str) -> None:
        page.wait_for_timeout(SETTLED_MS)
        steps[step] = page.screenshot()

    return keep


if __name__ == "__main__":
    main()

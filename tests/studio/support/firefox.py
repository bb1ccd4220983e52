"""Firefox as Debian has it, driven by WebDriver BiDi (https://w3c.github.io/webdriver-bidi): Playwright drives only
its own build of it."""

import json
import re
import shutil
import subprocess
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from typing import Any

from websockets.sync.client import ClientConnection, connect

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
PREFERENCES = {
    "webgl.force-enabled": True,
    "media.autoplay.default": 0,
    "datareporting.policy.dataSubmissionEnabled": False,
    "app.update.enabled": False,
    "browser.shell.checkDefaultBrowser": False,
}
PATIENCE_S = 60.0
POLLED_S = 0.1


class Tab:
    """A tab of a Firefox that runs: what it shows, what is pressed in it."""

    def __init__(self, connection: ClientConnection) -> None:
        self._connection = connection
        self._numbers = count(1)
        self._ask("session.new", capabilities={})
        self._context = self._ask("browsingContext.getTree")["contexts"][0]["context"]

    def go(self, url: str, *, width: int, height: int) -> None:
        self._ask("browsingContext.setViewport", context=self._context, viewport={"width": width, "height": height})
        self._ask("browsingContext.navigate", context=self._context, url=url, wait="complete")

    def value(self, expression: str) -> object:
        """What a JavaScript expression is in the page: a string, a number, a boolean or None."""
        found: object = self._evaluated(expression).get("value")
        return found

    def wait_until(self, expression: str) -> None:
        end_s = time.monotonic() + PATIENCE_S
        while not self.value(f"Boolean({expression})"):
            assert time.monotonic() < end_s, f"never so: {expression}"
            time.sleep(POLLED_S)

    def click(self, selector: str) -> None:
        origin = {"type": "element", "element": self._element(selector)}
        actions = [
            {"type": "pointerMove", "x": 0, "y": 0, "origin": origin},
            {"type": "pointerDown", "button": 0},
            {"type": "pointerUp", "button": 0},
        ]
        pointer = {"type": "pointer", "id": "mouse", "actions": actions}
        self._ask("input.performActions", context=self._context, actions=[pointer])

    def set_files(self, selector: str, files: Sequence[Path]) -> None:
        names = [str(file) for file in files]
        self._ask("input.setFiles", context=self._context, element=self._element(selector), files=names)

    def picture(self) -> str:
        """A PNG in base64."""
        return str(self._ask("browsingContext.captureScreenshot", context=self._context)["data"])

    def _element(self, selector: str) -> dict[str, str]:
        self.wait_until(f"document.querySelector({json.dumps(selector)})")
        found = self._evaluated(f"document.querySelector({json.dumps(selector)})")
        return {"sharedId": found["sharedId"]}

    def _evaluated(self, expression: str) -> dict[str, Any]:
        target = {"context": self._context}
        answer = self._ask("script.evaluate", expression=expression, target=target, awaitPromise=True)
        assert answer["type"] == "success", answer
        result: dict[str, Any] = answer["result"]
        return result

    def _ask(self, method: str, **params: object) -> dict[str, Any]:
        number = next(self._numbers)
        self._connection.send(json.dumps({"id": number, "method": method, "params": params}))
        while True:
            told = json.loads(self._connection.recv(timeout=PATIENCE_S))
            if told.get("id") == number:
                assert told["type"] == "success", told
                result: dict[str, Any] = told["result"]
                return result


@contextmanager
def firefox_tab(folder: Path) -> Iterator[Tab]:
    """The tab of a Firefox without a window, whose profile is in an empty folder; it ends with the block."""
    written = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in PREFERENCES.items()]
    (folder / "user.js").write_text("\n".join(written))
    command = [str(FIREFOX), "--headless", "--no-remote", "--profile", str(folder), "--remote-debugging-port", "0"]
    log = folder / "log"
    with log.open("wb") as out:
        process = subprocess.Popen(command, stdout=out, stderr=out)
    try:
        with connect(f"{_address(process, log)}/session", max_size=None) as connection:
            yield Tab(connection)
    finally:
        process.terminate()
        process.wait()


def _address(process: subprocess.Popen[bytes], log: Path) -> str:
    end_s = time.monotonic() + PATIENCE_S
    while process.poll() is None and time.monotonic() < end_s:
        found = re.search(r"WebDriver BiDi listening on (ws://\S+)", log.read_text(errors="replace"))
        if found:
            return found[1]
        time.sleep(POLLED_S)
    raise AssertionError(log.read_text(errors="replace"))

"""The page of `examples/live` in Debian's Chromium, with a recording for a microphone."""

import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import numpy as np
import pytest
import soundfile
from playwright.sync_api import sync_playwright

from tests.support.chromium import CHROMIUM

ROOT = Path(__file__).parents[2]
PATIENCE_MS = 60_000
KEY = "schlüssel?>?>~~~for-the-page"
"""Its base64 has characters that no protocol's name may have."""

FLAGS = ("--no-sandbox", "--disable-gpu", "--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream")


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_: object) -> None:
        """Says nothing."""


@contextmanager
def page_served() -> Iterator[str]:
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(ROOT / "examples/live"))) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@contextmanager
def service_started(folder: Path, page: str) -> Iterator[str]:
    log = folder / "log"
    command = [sys.executable, "-m", "understudy.cli", "serve", "--port", "0", "--allow-origin", page]
    with log.open("wb") as out:
        process = subprocess.Popen(
            command, stderr=out, env=os.environ | {"UNDERSTUDY_WORKERS": "1", "UNDERSTUDY_API_KEYS": KEY}
        )
    try:
        while "http://" not in log.read_text():
            assert process.poll() is None, log.read_text()
            time.sleep(0.2)
        yield log.read_text().partition("http://")[2].split()[0].rstrip(".,;")
    finally:
        process.terminate()
        process.wait()


@pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")
def test_a_voice_with_the_right_key_moves_the_body_until_it_is_ended(tmp_path: Path) -> None:
    samples, rate_hz = soundfile.read(ROOT / "examples/example.flac")
    soundfile.write(tmp_path / "voice.wav", np.clip(samples, -1, 1), rate_hz, subtype="PCM_16")
    flags = [*FLAGS, f"--use-file-for-fake-audio-capture={tmp_path / 'voice.wav'}"]
    with page_served() as url, service_started(tmp_path, url) as address, sync_playwright() as started:
        browser = started.chromium.launch(executable_path=CHROMIUM, args=flags)
        page, wrong = browser.new_page(), list[str]()
        page.set_default_timeout(PATIENCE_MS)
        page.on("pageerror", lambda error: wrong.append(str(error)))
        page.goto(url)
        page.fill("#address", f"ws://{address}/live")
        for key in ("", "wrong"):
            page.fill("#key", key)
            page.click("#talk")
            page.wait_for_function("() => document.querySelector('#state').textContent.includes('another key')")
            page.wait_for_selector("#talk:not([disabled])")
            page.evaluate("() => { document.querySelector('#state').textContent = '' }")
        page.fill("#key", KEY)
        page.click("#talk")
        page.wait_for_selector("#told li:has-text('gesture')")
        assert page.inner_text("#state") == "listening"
        drawn = "() => { const c = document.querySelector('#body'); return c.toDataURL().length }"
        assert page.evaluate(drawn) > 2000
        page.click("#end")
        page.wait_for_function("() => document.querySelector('#state').textContent.startsWith('done')")
        browser.close()
    assert not wrong

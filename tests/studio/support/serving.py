"""A service of one's own for the page, and a scene to read: what tests and pictures of the studio are made with."""

import re
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from os import environ
from pathlib import Path
from typing import Literal

from tests.support.batches import ThisProcess
from understudy.batch.planning import BatchRequest
from understudy.batch.whole_run import Nobody, run_batch
from understudy.batch.work.formats import formats_named
from understudy.batch.work.jobs import MotionForm
from understudy.files import resource_folder
from understudy.models import Understudy
from understudy.settings import Settings

FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--autoplay-policy=no-user-gesture-required",
)
"""With which Chromium draws without a graphics card and plays without a press."""
Theme = Literal["light", "dark"]
ONE_WORKER: Mapping[str, str] = {"UNDERSTUDY_WORKERS": "1"}


@contextmanager
def served(log: Path) -> Iterator[str]:
    """The address of a service with one worker, which ends with the block."""
    command = [sys.executable, "-m", "understudy.cli", "serve", "--port", "0"]
    with log.open("wb") as out:
        process = subprocess.Popen(command, stderr=out, env=environ | ONE_WORKER)
    try:
        yield _address(process, log)
    finally:
        process.terminate()
        process.wait()


def perform_scene(understudy: Understudy, folder: Path) -> Path:
    """A batch of two lines, which two characters say to each other; the bundled line, twice."""
    example = resource_folder("examples")
    text = (example / "example.txt").read_text().strip()
    (folder / "audio").mkdir()
    for name in ("one", "two"):
        (folder / "audio" / f"{name}.flac").write_bytes((example / "example.flac").read_bytes())
    (folder / "lines.csv").write_text(f'id,scene,character,text\none,1,ELIZA,"{text}"\ntwo,1,HENRY,"{text}"\n')
    request = BatchRequest(
        folder / "lines.csv",
        folder / "audio",
        folder / "out",
        formats=formats_named(["clip.json", "wav"]),
        motion=MotionForm(frame_rate_hz=30),
        learns_voices=False,
    )
    run_batch(request, Settings(), lambda: ThisProcess(understudy), Nobody())
    return folder / "out"


def _address(process: subprocess.Popen[bytes], log: Path) -> str:
    while process.poll() is None:
        found = re.search(r"listening on (http://\S+)", log.read_text())
        if found:
            return found[1]
        time.sleep(0.05)
    raise AssertionError(log.read_text())

"""The extension, built and installed into a Blender whose settings are thrown away, and a service for it to ask.

The service is `understudy` of the checkout's own environment, or the command in UNDERSTUDY_COMMAND: Blender's Python
has no Understudy.
"""

import importlib.util
import os
import socket
import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import requests

ROOT = Path(__file__).parents[4]
COMMAND = os.environ.get("UNDERSTUDY_COMMAND", str(ROOT / ".venv" / "bin" / "understudy"))
ADDON = "bl_ext.user_default.understudy"
AUDIO = ROOT / "examples" / "example.flac"
WORDS = (ROOT / "examples" / "example.txt").read_text(encoding="utf-8").strip()
_SETTINGS = tempfile.TemporaryDirectory(prefix="understudy-blender-")
os.environ["BLENDER_USER_RESOURCES"] = _SETTINGS.name  # read once, as bpy is imported


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Without Blender's module these tests are skipped."""
    if importlib.util.find_spec("bpy") is None:
        missing = pytest.mark.skip(reason="Blender's module bpy is not installed: make test-plugins")
        here = f"{Path(__file__).parent}{os.sep}"
        for item in items:
            if str(item.path).startswith(here):
                item.add_marker(missing)


@pytest.fixture(scope="session")
def service() -> Iterator[str]:
    """The URL of a service that is ready."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    url = f"http://127.0.0.1:{port}"
    with subprocess.Popen([COMMAND, "serve", "--port", str(port), "--quiet"]) as process:
        try:
            _wait_for(url)
            yield url
        finally:
            process.terminate()


def _wait_for(url: str) -> None:
    for _try in range(3000):
        try:
            if requests.get(f"{url}/readyz", timeout=5).ok:
                return
        except requests.ConnectionError:
            pass
        time.sleep(0.1)
    raise TimeoutError(f"no service is ready at {url}")


@pytest.fixture(scope="session")
def extension(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The zip, installed as a person would from a file."""
    import bpy

    from plugins.build_blender import build

    archive = build(tmp_path_factory.mktemp("extension"))
    bpy.ops.extensions.package_install_files(
        filepath=str(archive), repo="user_default", enable_on_install=True, overwrite=True
    )
    return archive


@pytest.fixture
def blender(extension: Path, service: str) -> Any:
    """An empty scene at 30 frames a second, in which the service performs; the module bpy."""
    import bpy

    assert extension.exists()
    bpy.ops.wm.read_homefile(use_empty=True)
    chosen = bpy.context.preferences.addons[ADDON].preferences
    chosen.performer, chosen.url = "SERVICE", service
    bpy.context.scene.render.fps = 30
    return bpy


@pytest.fixture
def mannequin(blender: Any) -> Any:
    """Understudy's own character, added to the scene."""
    blender.ops.understudy.add_mannequin()
    return blender.context.object


@pytest.fixture
def sounds(blender: Any) -> None:
    """Skips where Blender's module was built without sounds, as that of 4.2 is."""
    if not blender.app.build_options.audaspace:
        pytest.skip("this build of bpy has no sounds (Audaspace)")


@pytest.fixture
def line(blender: Any) -> Any:
    """The scene's settings, with the example line."""
    settings = blender.context.scene.understudy
    settings.source, settings.audio, settings.text = "FILE", str(AUDIO), WORDS
    return settings


@pytest.fixture
def performed(blender: Any, mannequin: Any, line: Any) -> Any:
    """The armature with the example line."""
    assert line.text
    blender.ops.understudy.perform()
    return mannequin

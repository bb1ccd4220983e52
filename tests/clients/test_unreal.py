"""The client for Unreal against the application, as far as it goes without Unreal."""

import importlib.util
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.settings import Settings

ROOT = Path(__file__).parents[2]
AUDIO = ROOT / "tests" / "audio" / "figure8.flac"
BOUNDARY = "a-boundary"


@pytest.fixture(scope="module")
def unreal() -> Iterator[Any]:
    """The module, which is part of no package."""
    spec = importlib.util.spec_from_file_location("understudy_unreal", ROOT / "clients/unreal/understudy_unreal.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    yield module
    sys.modules.pop("understudy_unreal", None)


def test_the_service_reads_its_forms(unreal: Any, nursery: Nursery) -> None:  # noqa: ANN401 -- a module
    headers = {"Content-Type": f"multipart/form-data; boundary={BOUNDARY}"}
    text = AUDIO.with_suffix(".txt").read_text(encoding="utf-8").strip()
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        form = unreal._form({"text": text, "options": '{"seed": 3}'}, AUDIO, BOUNDARY)
        performed = client.post("/perform", content=form, headers={**headers, "Accept": "application/json"}).json()
        assert performed["performance"]["seed"] == 3
        form = unreal._form({"bml": performed["bml"]}, AUDIO, BOUNDARY)
        glb = client.post("/realize", content=form, headers={**headers, "Accept": "model/gltf-binary"}).content
    assert glb.startswith(b"glTF")


def test_what_the_service_says_is_told(unreal: Any) -> None:  # noqa: ANN401 -- a module
    assert unreal._detail(b'{"detail": "the text has no words"}') == "the text has no words"
    assert unreal._detail(b"<html>") == ""
    with pytest.raises(unreal.UnderstudyError, match="no service answers"):
        unreal.perform(AUDIO, "No.", url="http://127.0.0.1:9")

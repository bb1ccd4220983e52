"""Of a batch's folder the page gets what its index names, and nothing else."""

import json
from pathlib import Path

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from understudy.errors import InputError
from understudy.studio.pages import page_router
from understudy.studio.scenes import OpenedScene

LONG = "a" * 300
"""A name that an index may have and no file."""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "out"
    (folder / "sub").mkdir(parents=True)
    line = {
        "files": {"wav": "a.wav", "bml": "../secret.txt"},
        "listeners": {"BEN": {"clip.json": "sub/a.BEN.clip.json", "long": LONG, "null": "a\0b"}},
    }
    (folder / "index.json").write_text(json.dumps({"lines": [line]}))
    for path in (folder / "a.wav", folder / "sub/a.BEN.clip.json", folder / "report.csv", tmp_path / "secret.txt"):
        path.write_text(path.name)
    return folder


def _status(client: TestClient, name: str) -> int:
    return client.get(f"/opened/scene/{name}").status_code


def test_files_of_the_index_are_served_and_no_others(folder: Path) -> None:
    app = FastAPI()
    app.include_router(page_router(OpenedScene.of(folder)))
    client = TestClient(app)
    assert client.get("/opened/scene/sub/a.BEN.clip.json").text == "a.BEN.clip.json"
    assert [_status(client, name) for name in ("index.json", "a.wav")] == [200, 200]
    others = (LONG, "a%00b", "report.csv", "..%2Fsecret.txt", "%2e%2e/secret.txt", "sub", "none.wav")
    assert {_status(client, name) for name in others} == {404}
    assert client.get("/opened/line").status_code == 404


def test_a_service_without_a_scene_has_none() -> None:
    app = FastAPI()
    app.include_router(page_router())
    assert _status(TestClient(app), "index.json") == 404


def test_what_is_no_batch_is_told(folder: Path) -> None:
    (folder / "index.json").write_text("[1]")
    with pytest.raises(InputError) as raised:
        OpenedScene.of(folder)
    assert raised.value.code == "scene_wrong"

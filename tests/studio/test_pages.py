"""What is served at / and below /studio, and to whom."""

import base64
import hashlib
import re
import shutil
from pathlib import Path

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from starlette.datastructures import Headers

from understudy.api.admission.access import Admission, Arrival
from understudy.settings import Settings
from understudy.studio import pages
from understudy.studio.pages import OpenedLine, content_policy, page_router

LARGEST_BYTES = 4_000_000
KEYED = {"UNDERSTUDY_API_KEYS": "a-key-of-16-or-more"}


def _client(line: OpenedLine | None = None) -> TestClient:
    app = FastAPI(docs_url=None)
    app.include_router(page_router(line))
    return TestClient(app)


def test_the_page_loads_its_own_files_alone() -> None:
    shown = _client().get("/")
    assert shown.headers["content-type"].startswith("text/html")
    loaded = re.findall(r'(?:src|href|": ")="?\.?/?([^"]+)"', shown.text)
    assert "//" not in shown.text.replace("http://www.w3.org/2000/svg", "")
    for path in (name for name in loaded if name != "data:,"):
        assert _client().get(f"/{path}").status_code == 200


def test_the_policy_lets_in_the_pages_import_map_and_nothing_from_elsewhere() -> None:
    answer = _client().get("/")
    policy = answer.headers["content-security-policy"]
    hashes = {}
    for name, inline in {"script": r'<script type="importmap">(.*?)</script>', "style": "<style>(.*?)</style>"}.items():
        (found,) = re.findall(inline, answer.text, re.DOTALL)
        hashes[name] = f"'sha256-{base64.b64encode(hashlib.sha256(found.encode()).digest()).decode()}'"
        assert f"{name}-src 'self' {hashes[name]}" in policy
    sources = {source for directive in policy.split("; ") for source in directive.split()[1:]}
    assert sources == {"'none'", "'self'", "data:", "blob:", *hashes.values()}
    assert "sha256" not in content_policy(b"<p>no map</p>")


@pytest.mark.parametrize(
    "path",
    [
        "../pages.py",
        "..%2fpages.py",
        "vendor",
        "nothing.js",
        "example/other.txt",
        "",
        "%00",
        "a%00.js",
        "a" * 300,
        "a/" * 3000,
        "main.js/x",
    ],
)
def test_there_is_nothing_else(path: str) -> None:
    assert _client().get(f"/studio/{path}").status_code == 404


def test_a_file_that_the_browser_has_is_not_sent_again() -> None:
    first = _client().get("/studio/main.js")
    again = _client().get("/studio/main.js", headers={"If-None-Match": first.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")
    assert again.headers["etag"] == first.headers["etag"]


def test_what_the_page_names_is_kept_until_a_file_changes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(pages.FOLDER, tmp_path / "page")
    monkeypatch.setattr(pages, "FOLDER", tmp_path / "page")
    client = _client()

    def main_script() -> str:
        (found,) = re.findall(r'src="\./(studio/\w{16}/main\.js)"', client.get("/").text)
        return f"/{found}"

    first = main_script()
    assert main_script() == first
    assert "immutable" in client.get(first).headers["cache-control"]
    assert client.get("/").headers["cache-control"] == client.get("/studio/main.js").headers["cache-control"]
    (tmp_path / "page" / "dom.js").write_text("// another\n")
    assert main_script() != first


def test_a_version_that_another_service_named_is_not_kept() -> None:
    answer = _client().get("/studio/0123456789abcdef/main.js")
    assert (answer.status_code, answer.headers["cache-control"]) == (200, "no-cache")


def test_it_is_sent_as_it_is_taken() -> None:
    path = "/studio/vendor/three/three.core.js"
    plain, packed = (_client().get(path, headers={"Accept-Encoding": coding}) for coding in ("x", "gzip"))
    assert "content-encoding" not in plain.headers
    assert packed.headers["content-encoding"] == "gzip"
    assert plain.content == packed.content
    assert int(packed.headers["content-length"]) < len(plain.content) / 2


def test_the_example_is_there() -> None:
    assert _client().get("/studio/example/example.flac").content.startswith(b"fLaC")
    assert _client().get("/studio/example/example.txt").text.startswith("No,")


def test_the_opened_line_is_there_if_there_is_one() -> None:
    line = OpenedLine(b"RIFF", "größer.wav", "No.")
    client = _client(line)
    assert client.get("/opened/line").json() == {"name": "größer.wav", "text": "No."}
    assert client.get("/opened/audio").headers["content-type"] == "audio/wav"
    assert _client().get("/opened/audio").status_code == 404


def test_the_page_needs_no_key_and_the_line_that_was_opened_does(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in KEYED.items():
        monkeypatch.setenv(name, value)
    admission = Admission.of(Settings())
    headers = Headers({"host": "127.0.0.1"})
    let_in = [
        path
        for path in ("/", "/studio/main.js", "/opened/line", "/perform", "/studios")
        if not admission.refusal(Arrival(path, headers))
    ]
    assert let_in == ["/", "/studio/main.js"]


def test_it_can_be_left_out() -> None:
    admission = Admission.of(Settings(closed="studio"))
    headers = Headers({"host": "127.0.0.1"})
    closed = [
        path for path in ("/", "/studio/main.js", "/perform", "/healthz") if admission.refusal(Arrival(path, headers))
    ]
    assert closed == ["/", "/studio/main.js"]


def test_the_page_weighs_less_than_it_may() -> None:
    assert sum(file.stat().st_size for file in Path(pages.FOLDER).rglob("*") if file.is_file()) < LARGEST_BYTES


def test_the_page_carries_its_style() -> None:
    shown = _client().get("/").text
    assert 'rel="stylesheet"' not in shown
    sheets = (pages.FOLDER / "index.html").read_text().count('rel="stylesheet"')
    (style,) = re.findall("<style>(.*?)</style>", shown, re.DOTALL)
    assert sheets > 1
    assert all(sheet.read_text() in style for sheet in (pages.FOLDER / "style").glob("*.css"))


def test_the_page_names_in_advance_what_it_begins_with_and_nothing_that_comes_later() -> None:
    shown = _client().get("/").text
    named = re.findall(r'<link rel="modulepreload" href="\./studio/\w{16}/([^"]+)" />', shown)
    assert {"dom.js", "line/start.js", "vendor/understudy-client.js"} <= set(named)
    assert not [name for name in named if "three" in name or name.startswith(("stage/stage", "rules/", "table_read/"))]
    assert len(named) == len(set(named))

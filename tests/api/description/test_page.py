"""The page at /docs works without the network: all that it loads is in the package."""

import re

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from understudy.api.description import page

LOADED = re.compile(r"""(?:src|href|url)\s*[=:(]\s*["']?([^"')\s>]+)""")


def _client() -> TestClient:
    app = FastAPI(docs_url=None)
    app.include_router(page.router)
    return TestClient(app)


def test_it_loads_its_own_files_and_no_others() -> None:
    client = _client()
    shown = client.get("/docs")
    assert shown.headers["content-type"].startswith("text/html")
    assert "//" not in shown.text
    named = set(LOADED.findall(shown.text)) - {"data:,"}
    assert named == {f"docs/{name}" for name in page.MEDIA_TYPES}
    for name in named:
        answer = client.get(f"/{name}")
        assert answer.status_code == 200
        assert answer.headers["content-type"].startswith(page.MEDIA_TYPES[name.removeprefix("docs/")])


def test_the_policy_lets_nothing_in_from_elsewhere() -> None:
    policy = _client().get("/docs").headers["content-security-policy"]
    sources = {source for directive in policy.split("; ") for source in directive.split()[1:]}
    assert sources <= {"'none'", "'self'", "'unsafe-inline'", "data:"}
    assert "'unsafe-inline'" not in policy.split("script-src")[1].split(";")[0]


def test_what_it_loads_names_no_other_host_to_load_from() -> None:
    style = _client().get("/docs/swagger-ui.css").text
    assert [url for url in LOADED.findall(style) if not url.startswith("data:")] == []
    assert "validatorUrl: null" in (page.FOLDER / "page.js").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["swagger-ui.css", "swagger-ui-bundle.js"])
def test_it_is_sent_as_it_is_taken(name: str) -> None:
    plain, packed = (_client().get(f"/docs/{name}", headers={"Accept-Encoding": coding}) for coding in ("x", "gzip"))
    assert "content-encoding" not in plain.headers
    assert packed.headers["content-encoding"] == "gzip"
    assert plain.content == packed.content
    assert int(packed.headers["content-length"]) < len(plain.content) / 2


def test_there_is_nothing_else_under_it() -> None:
    for name in ("README.md", "page.html", "..%2fpage.py", "nothing"):
        assert _client().get(f"/docs/{name}").status_code == 404

"""Every page is found from the index and in the site's menu, and every link between pages leads somewhere. `make docs`
checks the site itself."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from understudy.files import resource_folder

ROOT = resource_folder("lexicon").parent
DOCS = ROOT / "docs"
PAGES = sorted(DOCS.rglob("*.md"))
WITH_AN_INDEX = ("measurements", "decisions")
_LINK = re.compile(r"\]\(([^)#\s:]*)(?:#([^)\s]+))?\)")


def _in_menu(entry: object) -> Iterator[str]:
    if isinstance(entry, str):
        yield entry
    elif isinstance(entry, dict | list):
        for part in entry.values() if isinstance(entry, dict) else entry:
            yield from _in_menu(part)


def _anchors(page: Path) -> set[str]:
    headings = re.findall(r"^#+ +(.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    named = re.findall(r'(?:id|name)="([^"]+)"|\{#([^}]+)\}', page.read_text(encoding="utf-8"))
    slugs = (re.sub(r"[-\s]+", "-", re.sub(r"[^\w\s-]", "", heading).strip().lower()) for heading in headings)
    return {*slugs, *(one or other for one, other in named)}


def test_every_page_is_in_the_menu() -> None:
    menu = yaml.safe_load((ROOT / "mkdocs.yml").read_text(encoding="utf-8"))["nav"]
    assert sorted(_in_menu(menu)) == sorted(page.relative_to(DOCS).as_posix() for page in PAGES)


def test_every_page_is_found_from_the_index() -> None:
    index = (DOCS / "index.md").read_text(encoding="utf-8")
    own = [page.relative_to(DOCS) for page in PAGES if page.parent.name not in WITH_AN_INDEX]
    assert [page.as_posix() for page in own if page.name != "index.md" and f"({page.as_posix()})" not in index] == []


@pytest.mark.parametrize("page", [*PAGES, ROOT / "README.md", ROOT / "CONTRIBUTING.md"], ids=lambda page: page.name)
def test_links_lead_somewhere(page: Path) -> None:
    lost = []
    for path, anchor in _LINK.findall(page.read_text(encoding="utf-8")):
        target = page.parent / path if path else page
        if not target.exists() or (anchor and target.suffix == ".md" and anchor not in _anchors(target)):
            lost.append(f"{path}#{anchor}")
    assert lost == []

"""What docstrings and data cite is there: nobody who clones the repository has the folder of the papers and notes."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = ("app", "lexicon", "plugins")
TEXTS = frozenset({".py", ".rules", ".yaml", ".gesture", ".js", ".lark", ".toml"})


@pytest.mark.parametrize("folder", SHIPPED)
def test_nothing_shipped_cites_a_folder_that_no_clone_has(folder: str) -> None:
    files = (path for path in (ROOT / folder).rglob("*") if path.suffix in TEXTS and "vendor" not in path.parts)
    citing = [path for path in files if "shared/" in path.read_text(encoding="utf-8")]
    assert citing == []


def test_every_page_that_docstrings_cite_is_there() -> None:
    cited = {
        word.strip("`().,;:\"'")
        for path in (ROOT / "app").rglob("*.py")
        for word in path.read_text(encoding="utf-8").split()
        if "docs/" in word and ".md" in word
    }
    pages = {page.split("docs/", 1)[1].split(".md")[0] for page in cited}
    docs = ROOT / "docs"
    assert pages - {path.relative_to(docs).with_suffix("").as_posix() for path in docs.rglob("*.md")} == set()


def test_every_module_that_the_page_of_the_papers_names_is_there() -> None:
    page = (ROOT / "docs" / "papers.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`([\w/]+\.(?:py|yaml)|[\w/]+/)`", page))
    there = [
        path.relative_to(ROOT).as_posix()
        for folder in (*SHIPPED, "tests", "benchmarks", "examples")
        for path in _all(folder)
    ]
    missing = [name for name in named if not any(f"/{name.rstrip('/')}/" in f"/{path}/" for path in there)]
    assert missing == []


def _all(folder: str) -> list[Path]:
    return [path for path in (ROOT / folder).rglob("*") if "__pycache__" not in path.parts]

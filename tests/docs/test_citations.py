"""What docstrings and data cite is there: nobody who clones the repository has the folder of the papers and notes."""

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

"""Docstrings, messages and pages are in plain English: none has a word of `plain_english.yaml`."""

import re
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
WORDS: dict[str, str] = yaml.safe_load((Path(__file__).parent / "plain_english.yaml").read_text(encoding="utf-8"))
TEXTS = (
    *sorted((ROOT / "app").rglob("*.py")),
    *sorted((ROOT / "plugins").rglob("*.py")),
    *sorted((ROOT / "docs").rglob("*.md")),
    *sorted(ROOT.glob("*.md")),
)
PHRASE = re.compile(r"(?<!all )\b(" + "|".join(map(re.escape, WORDS)).replace(r"\ ", r"\s+") + r")\b", re.IGNORECASE)
"""("all of whose" is plain English)"""


def found_in(text: str) -> list[str]:
    """The places of the words, each with what to write instead."""
    return [
        f"line {text.count(chr(10), 0, match.start()) + 1}: {match[0]!r}: {WORDS[' '.join(match[0].lower().split())]}"
        for match in PHRASE.finditer(text)
    ]


def test_a_word_is_found_with_what_to_write_instead_even_across_a_line() -> None:
    assert found_in("It is\nnot Mended\nas\never.") == [
        "line 2: 'Mended': fixed",
        "line 3: 'as\\never': as usual; unchanged",
    ]
    assert found_in("amended, all of whose") == []


@pytest.mark.parametrize("folder", ["app", "plugins", "docs", "."])
def test_no_text_has_such_a_word(folder: str) -> None:
    within = [path for path in TEXTS if path.is_relative_to(ROOT / folder) and (folder != "." or path.parent == ROOT)]
    told = {str(path.relative_to(ROOT)): found_in(path.read_text(encoding="utf-8")) for path in within}
    assert within
    assert {path: found for path, found in told.items() if found} == {}

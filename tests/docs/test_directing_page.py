"""docs/directing.md: its examples are notes on its line, and its tables are the vocabulary."""

import json
import re
from pathlib import Path

from understudy.behavior.candidates.notes import check_direction, conflicts
from understudy.behavior.candidates.vocabulary import KINDS
from understudy.schemas.direction import read_direction

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "directing.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"```json direction\n(.*?)```", PAGE, flags=re.DOTALL)
LINE = "Not the red one, I want all of these."


def test_the_examples_are_notes_on_the_line_without_a_conflict() -> None:
    assert LINE in PAGE
    assert len(EXAMPLES) == 3
    for example in EXAMPLES:
        direction = read_direction(example.encode())
        check_direction(direction, words=len(LINE.split()))
        assert conflicts(direction) == ()


def test_the_ideas_of_the_first_example_stand_on_their_words() -> None:
    moments = json.loads(EXAMPLES[0])["moments"]
    assert [LINE.split()[moment["stroke"]] for moment in moments] == ["red", "all"]


def test_the_tables_are_the_vocabulary() -> None:
    tables = re.findall(r"^\| `(\w+)` \| [^|]*\|\n\|---\|---\|\n((?:\|.*\n)+)", PAGE, flags=re.MULTILINE)
    rows = {name: dict(re.findall(r"^\| `(\w+)` \| (.*) \|$", table, flags=re.MULTILINE)) for name, table in tables}
    assert rows == {channel.value: dict(kinds) for channel, kinds in KINDS.items()}

"""The example of docs/edits.md is a file of edits that fits its line, and every warning is documented."""

import re
from pathlib import Path

from understudy.edits.applying import find_behaviors
from understudy.edits.words import find_word
from understudy.model import Line, Word
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.schemas.edits import read_edits

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "edits.md").read_text(encoding="utf-8")
EXAMPLE = re.findall(r"```json edits\n(.*?)```", PAGE, flags=re.DOTALL)[0].encode()
CODE = re.compile(r'"(edit_[a-z_]+)"')


def test_the_example_names_words_of_its_line() -> None:
    texts = re.findall(r'For "(.*?)"', PAGE)[0].split()
    words = [Word(number, text) for number, text in enumerate(texts)]
    edits = read_edits(EXAMPLE)
    named = [*(edit.at for edit in edits.words), *(edit.word for edit in edits.behaviors)]
    assert [find_word(reference, words) for reference in named] == [reference.word for reference in named]


def test_the_example_is_made_in_the_bundled_line(understudy: Understudy) -> None:
    text = (ROOT / "examples" / "example.txt").read_text(encoding="utf-8")
    line = Line((ROOT / "examples" / "example.flac").read_bytes(), text)
    edits = read_edits(EXAMPLE)
    assert len(find_behaviors(perform(understudy, line, Options()), edits.behaviors).behaviors) == 2
    told = {notice.code for notice in perform(understudy, line, Options().with_edits(edits)).notices}
    assert told.isdisjoint(CODE.findall(_code()))


def test_every_warning_is_on_the_page_and_no_other() -> None:
    assert set(re.findall(r"^\| `(edit_[a-z_]+)` ", PAGE, flags=re.MULTILINE)) == set(CODE.findall(_code()))


def _code() -> str:
    return "\n".join(path.read_text(encoding="utf-8") for path in sorted((ROOT / "app" / "edits").glob("*.py")))

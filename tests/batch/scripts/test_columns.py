"""Columns are found by their usual names or as named; messages about missing ones list those that exist."""

from pathlib import Path

import pytest

from understudy.batch.scripts.columns import ColumnNames, find_columns, letters, read_named
from understudy.errors import AuthoringError, InputError

NAMES = ColumnNames.load()


def test_usual_names_in_any_spelling() -> None:
    columns = find_columns(["Line_ID", "SPEAKER", "File-Name", "Dialogue"], NAMES, {}, file="lines.csv")
    assert dict(columns.places) == {"id": 0, "character": 1, "recording": 2, "text": 3}
    assert columns.name("recording") == "C (File-Name)"


def test_the_more_usual_of_two_names_is_taken() -> None:
    columns = find_columns(["Source", "Text", "Number", "ID"], NAMES, {}, file="lines.csv")
    assert (columns.places["text"], columns.places["id"]) == (1, 3)


def test_a_named_column_goes_before_the_usual_names() -> None:
    columns = find_columns(["Text", "What she says"], NAMES, {"text": "what she says"}, file="lines.csv")
    assert dict(columns.places) == {"text": 1}


@pytest.mark.parametrize(("header", "named"), [(["ID", "Sprache"], {}), (["ID", "Text"], {"text": "Txt"})])
def test_a_missing_column_is_told_with_the_headings(header: list[str], named: dict[str, str]) -> None:
    with pytest.raises(InputError) as raised:
        find_columns(header, NAMES, named, file="lines.csv")
    assert raised.value.code == "columns_missing"
    assert header[1] in raised.value.message


def test_options_that_name_columns() -> None:
    assert read_named(["text=What she says", "id=Nr"]) == {"text": "What she says", "id": "Nr"}
    with pytest.raises(InputError, match="did you mean 'text'"):
        read_named(["txt=What she says"])


def test_every_mistake_in_the_table_of_names_is_told(tmp_path: Path) -> None:
    table = tmp_path / "columns.yaml"
    table.write_text("id: [id, line]\ntext: [line, words]\nspeech: [speech]\n", encoding="utf-8")
    with pytest.raises(AuthoringError) as raised:
        ColumnNames.load(table)
    assert [(mistake.line, mistake.column) for mistake in raised.value.mistakes] == [(2, 8), (3, 9)]


@pytest.mark.parametrize(("place", "told"), [(0, "A"), (25, "Z"), (26, "AA"), (701, "ZZ"), (702, "AAA")])
def test_letters_of_columns(place: int, told: str) -> None:
    assert letters(place) == told

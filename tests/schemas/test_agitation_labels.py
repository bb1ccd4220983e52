"""Tables of recordings with their agitation, and every mistake in them with its line."""

from pathlib import Path

import pytest

from understudy.errors import InputError
from understudy.schemas.agitation_labels import read_labels


@pytest.fixture
def table(tmp_path: Path) -> Path:
    (tmp_path / "a.wav").write_bytes(b"")
    return tmp_path / "labels.csv"


def test_rows_are_read_by_the_names_of_columns_and_others_left_alone(table: Path) -> None:
    read = read_labels(b"speaker,emotion,Agitation,file\nAnn,fear,mid,a.wav\n\nBob,,medium/high,a.wav\n", table)
    assert [(each.speaker, each.memberships) for each in read] == [("Ann", (0.0, 1.0, 0.0)), ("Bob", (0.0, 0.5, 0.5))]
    assert read[0].path == table.parent / "a.wav"


def test_a_spreadsheets_semicolons_separate_too(table: Path) -> None:
    (read,) = read_labels("file;speaker;agitation\r\na.wav;Müller, Ann;low\r\n".encode("utf-8-sig"), table)
    assert (read.speaker, read.memberships) == ("Müller, Ann", (1.0, 0.0, 0.0))


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b"file,speaker,agitaton\n", r"labels.csv:1: the column agitation is missing; did you mean 'agitaton'\?"),
        (b"", "the first line must name file, speaker, agitation"),
        (b"file,speaker,agitation\nb.wav,Ann,low\n", r"labels.csv:2: there is no file 'b.wav' beside the table"),
        (b"file,speaker,agitation\na.wav,,low\n", r"labels.csv:2: no speaker"),
        (
            b"file,speaker,agitation\na.wav,Ann,angry\na.wav,Ann\n",
            r"csv:2: agitation 'angry'; give.*csv:3: 2 cells",
        ),
        (b"\xff\xfe,", "not CSV in UTF-8"),
        (b"file,speaker,agitation\n\n", "labels.csv: no recordings; give a line for each below the first"),
    ],
)
def test_mistakes_are_told_with_their_lines(table: Path, content: bytes, told: str) -> None:
    with pytest.raises(InputError, match=told) as wrong:
        read_labels(content, table)
    assert wrong.value.code == "labels_wrong"

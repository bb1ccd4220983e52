from pathlib import Path

import pytest

from understudy.errors import AuthoringError
from understudy.yaml_files import DEEPEST, MOST_MISTAKES, MOST_NODES, Entry, Source, has_key


class Side(Entry):
    name: str
    hot: bool = False


class Dish(Entry):
    name: str
    price: float
    tags: tuple[str, ...] = ()
    sides: tuple[Side, ...] = ()


def _source(folder: Path, text: str) -> Source:
    path = folder / "dish.yaml"
    path.write_bytes(text.encode())
    return Source(path)


def _mistakes(folder: Path, text: str) -> list[tuple[int, int, str]]:
    with pytest.raises(AuthoringError) as caught:
        _source(folder, text).validated(Dish)
    return [(mistake.line, mistake.column, mistake.message) for mistake in caught.value.mistakes]


def test_words_that_yaml_takes_for_booleans_stay_words(tmp_path: Path) -> None:
    dish = _source(tmp_path, "name: no\nprice: 2.50\ntags: [yes, 'on', 012]\n").validated(Dish)
    assert dish == Dish(name="no", price=2.5, tags=("yes", "on", "012"))


def test_every_mistake_is_told_where_it_stands(tmp_path: Path) -> None:
    found = _mistakes(tmp_path, "name: soup\nprice: dear\ncolour: red\n")
    assert [(line, column) for line, column, _ in found] == [(2, 8), (3, 9)]
    assert "number" in found[0][2]
    assert found[1][2] == "unknown key"


def test_a_missing_key_is_told_where_its_mapping_begins(tmp_path: Path) -> None:
    assert _mistakes(tmp_path, "# a dish\nname: soup\n") == [(2, 1, "the key 'price' is missing")]


@pytest.mark.parametrize(
    ("text", "place", "told"),
    [
        ("sides: [rice]", (3, 9), "expected keys with values (name required, hot); found 'rice'"),
        ("sides: [[rice]]", (3, 9), "expected keys with values (name required, hot); found a list"),
        ("sides: rice", (3, 8), "expected a list, such as [one, two]; found 'rice'"),
        ("sides: {name: rice}", (3, 8), "expected a list, such as [one, two]; found keys with values"),
        ("sides: [{hot: yes}]", (3, 9), "the key 'name' is missing"),
    ],
)
def test_what_was_meant_is_said(text: str, place: tuple[int, int], told: str, tmp_path: Path) -> None:
    assert _mistakes(tmp_path, f"name: soup\nprice: 1\n{text}\n") == [(*place, told)]


@pytest.mark.parametrize(
    ("text", "line", "column"),
    [
        ("name: &a soup\nprice: 1\n", 1, 7),
        ("name: !!str soup\nprice: 1\n", 1, 7),
        ("name: soup\nprice: 1\nname: stew\n", 3, 1),
        ("name: [soup\nprice: 1\n", 2, 6),
        ("name: soup\n? [a, b]\n: 1\n", 2, 3),
        ("name: soup\n{a: 1}: 1\n", 2, 1),
        ("", 1, 1),
        ("name: s\x01p\n", 1, 1),
    ],
)
def test_what_a_file_does_not_show_or_say_is_refused(tmp_path: Path, text: str, line: int, column: int) -> None:
    assert [found[:2] for found in _mistakes(tmp_path, text)] == [(line, column)]


def test_a_file_that_is_no_text_is_told(tmp_path: Path) -> None:
    path = tmp_path / "dish.yaml"
    path.write_bytes(b"name: \xff\n")
    with pytest.raises(AuthoringError, match="UTF-8"):
        Source(path)


@pytest.mark.parametrize(
    "text", ["[" * 100_000, "{a: " * 3000, "- " * 3000, "\n".join(" " * n + "a:" for n in range(600))]
)
def test_what_is_too_deep_is_refused_before_it_is_built(tmp_path: Path, text: str) -> None:
    [(_line, _column, message)] = _mistakes(tmp_path, text)
    assert message == f"nested more than {DEEPEST} levels deep"


def test_as_deep_as_may_be_is_read(tmp_path: Path) -> None:
    assert _source(tmp_path, "[" * DEEPEST + "]" * DEEPEST).value


@pytest.mark.parametrize(
    "text", ["\n".join(f"k{n}: v" for n in range(MOST_NODES // 2 + 1)), "[" + "a," * MOST_NODES + "]"]
)
def test_what_is_too_large_is_refused_at_once(tmp_path: Path, text: str) -> None:
    [(_line, _column, message)] = _mistakes(tmp_path, text)
    assert message == f"more than {MOST_NODES} keys and values"


@pytest.mark.parametrize("apart", ["\n", ", "])
def test_of_very_many_mistakes_the_first_are_told_and_no_line_without_end(tmp_path: Path, apart: str) -> None:
    keys = apart.join(f"k{n}: v" for n in range(MOST_NODES // 2 - 10))
    with pytest.raises(AuthoringError) as caught:
        _source(tmp_path, keys if apart == "\n" else f"{{{keys}}}").validated(Dish)
    assert len(caught.value.mistakes) == MOST_MISTAKES + 1
    assert "more mistakes" in caught.value.mistakes[-1].message
    assert len(caught.value.message) < 200 * MOST_MISTAKES


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("class: a\nwords: [", True),
        ("words: [class]\n'class': a\n", True),
        ("{words: {class: a}, b: class}", False),
        ("[class, words]", False),
        ("class", False),
    ],
)
def test_a_key_is_found_without_reading_on(tmp_path: Path, text: str, found: bool) -> None:
    path = tmp_path / "words.yaml"
    path.write_text(text, encoding="utf-8")
    assert has_key(path, "class") is found


@pytest.mark.parametrize("text", ["words: [", "[" * (DEEPEST + 1), "a: &b c", ""])
def test_a_file_without_the_key_is_read_to_its_end_and_its_mistakes_are_told(tmp_path: Path, text: str) -> None:
    path = tmp_path / "words.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(AuthoringError):
        has_key(path, "class")

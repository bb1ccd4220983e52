"""The file of what words say: every mistake at its place."""

from pathlib import Path

import pytest

from understudy.behavior.slots.table import SlotTable
from understudy.errors import AuthoringError

HEAD = """sets: {child: [kid]}
numbers: {2: [two]}
units_m: {0.01: [cm]}
heights_m: {knee: 0.5, child: 0.95, waist: 1.05, chest: 1.3, neck: 1.5, own: 1.65, over_head: 1.9}
sizes_m: {tiny: 0.02, small: 0.12, big: 0.6, huge: 1.3}
shown_by: {height: [shape]}
contrasts: []
slots:
"""
SHOWS = {"HEIGHT_HIGH": ("shape",), "BEAT": ("beat",)}


def load(tmp_path: Path, text: str) -> SlotTable:
    path = tmp_path / "slots.yaml"
    path.write_text(text, encoding="utf-8")
    return SlotTable.load(path, SHOWS)


@pytest.mark.parametrize(
    ("slots", "told"),
    [
        ("  heigth: []", (9, 11, "did you mean 'height'")),
        ("  height: [{is: chlid, words: [this tall]}]", (9, 17, "not a value of height; did you mean 'child'")),
        ("  height: [{is: child, words: [this <chld>]}]", (9, 32, "no set is called 'chld'")),
        ("  count: [{is: '11', words: [eleven]}]", (9, 16, "'11' is not a value of count")),
        ("  count: [{is: '²', words: [two]}]", (9, 16, "'²' is not a value of count")),
        (f"  count: [{{is: '{'9' * 5000}', words: [many]}}]", (9, 16, "is not a value of count")),
    ],
)
def test_a_mistake_is_told_with_its_place(tmp_path: Path, slots: str, told: tuple[int, int, str]) -> None:
    with pytest.raises(AuthoringError) as caught:
        load(tmp_path, HEAD + slots)
    (mistake,) = caught.value.mistakes
    assert (mistake.line, mistake.column) == told[:2]
    assert told[2] in mistake.message


def test_a_family_that_does_not_exist_is_told(tmp_path: Path) -> None:
    with pytest.raises(AuthoringError, match="'shapes' is not a family"):
        load(tmp_path, HEAD.replace("[shape]", "[shapes]") + "  height: []")


def test_lengths_reach_classes(tmp_path: Path) -> None:
    table = load(tmp_path, HEAD + "  height: []")
    assert [table.height(metres) for metres in (0.1, 1.0, 3.0)] == ["knee", "child", "over_head"]
    assert [table.size(metres) for metres in (0.001, 0.2, 9.0)] == ["tiny", "small", "huge"]
    assert table.shown == {"HEIGHT_HIGH": {"height"}, "BEAT": set()}

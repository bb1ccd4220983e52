"""The notation of directors, and the check of what is written in it."""

from pathlib import Path

import pytest

from training.acting.lines_check import doubles_in, main, problems_of
from training.acting.notation import NotationError, records_of

PAGE = """== banter
B You paid forty for this? This lamp?
> this#1 amu 0 0,1 | holds it up to the light
for..this@this 3 pre,ph t.bu.T this thing
paid 1 - fr.L the price
! forty count not counted out
L You paid what?
"""


def _page(folder: Path, text: str) -> Path:
    path = folder / "page.txt"
    path.write_text(text, encoding="utf-8")
    return path


def test_deliveries_and_lines_are_read_by_their_words(tmp_path: Path) -> None:
    delivery, line = records_of(_page(tmp_path, PAGE), "9", {})
    assert (delivery["id"], delivery["base"], delivery["focus"]) == ("banter9-001-a", "banter9-001", [4])
    assert (delivery["tone"], delivery["manner"]) == ("amused", {"size": 0, "speed": 1})
    price, thing = delivery["moments"]
    assert price["gesture"] == []
    assert price["face"] == ["frown"]
    assert (thing["first"], thing["last"], thing["stroke"]) == (3, 4, 4)
    assert (thing["head"], thing["face"], thing["gaze"]) == (["tilt"], ["brows_up"], ["target"])
    assert delivery["avoid"] == [{"first": 2, "last": 2, "what": ["count"], "why": "not counted out"}]
    assert (line["id"], line["moments"]) == ("banter9-002", [])


@pytest.mark.parametrize(
    "moment", ["this 3 pre L which", "paid 3 wave L no family", "paid 3 pre q.L no code", "nil 3 - L"]
)
def test_what_cannot_be_read_is_told_with_its_line(tmp_path: Path, moment: str) -> None:
    page = _page(tmp_path, f"{PAGE}L You paid for this and this?\n{moment} idea\n")
    with pytest.raises(NotationError, match=r"page\.txt:9: "):
        records_of(page, "9", {})


def test_two_strokes_on_one_word_are_a_problem(tmp_path: Path) -> None:
    text = "== banter\nL You paid what?\npaid 3 pre L one idea\npaid 2 q L another\n"
    (record,) = records_of(_page(tmp_path, text), "9", {})
    assert problems_of(record) == ["strokes [1, 1] not in order"]


def test_a_line_that_is_half_another_is_a_double() -> None:
    known = {"old": "Turn the brass key left until you feel it give way."}
    assert list(doubles_in({"new": "So turn the brass key left until you feel it."}, known))
    assert not list(doubles_in({"new": "Turn the brass lamp off before you go."}, known))


def test_all_our_readings_are_sound(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("sys.argv", ["lines_check", "check"])

    assert main() == 0, capsys.readouterr().out

"""The file of the face is checked on load: every mistake at once, with its place."""

from pathlib import Path

import pytest

from tests.support.words.speaking import TABLES
from understudy.errors import AuthoringError
from understudy.realizer.face.face_tables import COLUMNS, INDEX, VISEMES, FaceSide, FaceTables, sided

FILE = Path(__file__).resolve().parents[3] / "lexicon" / "face.yaml"


def mistakes(folder: Path, *changes: tuple[str, str]) -> list[str]:
    """What loading says of the file in which each text stands in place of another."""
    text = FILE.read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    path = folder / "face.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(AuthoringError) as caught:
        FaceTables.load(path)
    assert all(mistake.line > 1 and mistake.column >= 1 for mistake in caught.value.mistakes)
    return [mistake.message for mistake in caught.value.mistakes]


def test_names_without_a_side_are_both_sides_but_not_of_jaw_and_mouth() -> None:
    assert COLUMNS["mouthSmile"] == (INDEX["mouthSmileLeft"], INDEX["mouthSmileRight"])
    assert COLUMNS["jawOpen"] == (INDEX["jawOpen"],)
    assert not {"jaw", "mouth"} & COLUMNS.keys()


def test_the_units_of_the_fifty_two_shapes_are_there() -> None:
    """shared/motion.md, "Face"."""
    listed = [1, 2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 16, 17, 18, 20, 22, 24, 26, 27, 28, 43, 45, 61, 62, 63, 64]
    assert {f"AU{number}" for number in listed} <= TABLES.lexemes.keys()


def test_one_side_leaves_the_other_alone_and_halves_what_has_no_side() -> None:
    left = sided(TABLES.lexemes["RAISE_BROWS"], FaceSide.LEFT)
    assert left[INDEX["browOuterUpLeft"]] == 1
    assert left[INDEX["browOuterUpRight"]] == 0
    assert left[INDEX["browInnerUp"]] == 0.5


def test_only_the_visemes_of_closed_lips_close_them() -> None:
    closing = {
        label
        for label, targets in zip(VISEMES, TABLES.visemes.targets, strict=True)
        if targets[INDEX["mouthClose"]] >= 1
    }
    assert closing == {"sil", "PP", "FF"}


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "AU12: {mouthSmile: 1}",
            "AU12: {mouthSmlie: 1}",
            "no shape is called 'mouthSmlie'; did you mean 'mouthSmile'?",
        ),
        ("{units: {AU43: 1}}", "{units: {AU48: 1}}", "no action unit is called 'AU48'; did you mean 'AU4'?"),
        ("  U: {shapes", "  UU: {shapes", "U is missing in visemes"),
        ("mouthPucker: 0.8", "mouthPucker: 1.2", "only `mouthClose` may be more than 1"),
        ("mouthPucker: 0.8", "browInnerUp: 0.8", "no articulator moves 'browInnerUp'"),
        ("[tongueOut]", "[tongueOut, jawOpen]", "'jawOpen' is moved by another articulator already"),
        ("widest_jaw: 0.5", "widest_jaw: 5", "Input should be less than or equal to 1"),
        ("side: left", "side: front", "Input should be 'left', 'right' or 'both'"),
        ("{down: 0.12, up: 0.12}", "{down: 0.12}", "Value error, missing: up"),
        ("leaves_corners: 1}", "leaves_corners: 1, opening: 1}", "unknown key"),
    ],
)
def test_mistakes_are_found(tmp_path: Path, old: str, new: str, message: str) -> None:
    assert message in mistakes(tmp_path, (old, new))


def test_all_mistakes_are_told_at_once(tmp_path: Path) -> None:
    found = mistakes(tmp_path, ("mouthSmile: 1}", "smile: 1}"), ("{AU43: 1}", "{AU99: 1}"), ("  U: {", "  UU: {"))
    assert len(found) >= 4

"""`understudy gestures`: what it lists, shows and finds wrong."""

import json
from pathlib import Path

import pytest

from tests.support.motion.gesture_files import gesture
from understudy.authoring.catalogue import load_gestures
from understudy.cli.main import main
from understudy.model import Level

Captured = pytest.CaptureFixture[bytes]


def _run(capture: Captured, *argv: str) -> tuple[int, str, str]:
    capture.readouterr()
    code = main(argv)
    out, err = capture.readouterr()
    return code, out.decode(), err.decode()


def test_the_list_has_every_gesture_and_category(capfdbinary: Captured) -> None:
    library = load_gestures()
    code, out, _ = _run(capfdbinary, "gestures", "list")
    assert code == 0
    headlines, counts = out.split("\n\n")
    assert [line.split()[0] for line in headlines.splitlines()] == [one.name for one in library.definitions]
    assert [line.split()[0] for line in counts.splitlines()[1:-1]] == list(library.categories)
    assert counts.splitlines()[-1] == f"{len(library.categories)} categories, {len(library.definitions)} gestures"


def test_the_list_as_json(capfdbinary: Captured) -> None:
    code, out, _ = _run(capfdbinary, "gestures", "list", "--json")
    assert code == 0
    small = next(one for one in json.loads(out)["gestures"] if one["name"] == "small")
    assert (small["class"], small["categories"], small["file"]) == (
        "adjectival",
        ["SMALL"],
        "lexicon/gestures/small.gesture",
    )
    assert "arms" not in small
    assert list(small["levels"]) == [level.value for level in Level]
    assert small["levels"]["medium"]["markers_s"]["stroke_end"] == 0.6


def test_a_gesture_is_shown_as_written(capfdbinary: Captured) -> None:
    code, out, _ = _run(capfdbinary, "gestures", "show", "small")
    assert code == 0
    assert "    FINGER index bend_curved" not in out.splitlines()
    assert "      FINGER index bend_curved" in out.splitlines()
    rows = [line.split() for line in out.splitlines() if line.startswith("  medium")]
    assert rows == [
        ["medium", "1.00", "1.00", "0.50", "0.50", "0.35", "0.18"],
        ["medium", "0.000", "0.000", "0.366", "0.600", "1.500", "1.500"],
    ]


def test_a_category_is_shown_with_all_its_gestures(capfdbinary: Captured) -> None:
    assert _run(capfdbinary, "gestures", "show", "SMALL")[1].startswith("small: lexicon/gestures/small.gesture:1\n")


def test_a_file_that_is_not_in_the_library_is_shown(capfdbinary: Captured, tmp_path: Path) -> None:
    path = tmp_path / "own.gesture"
    path.write_text(f"# Mine.\n{gesture(name='own')}", encoding="utf-8")
    out = _run(capfdbinary, "gestures", "show", str(path))[1]
    assert out.splitlines()[:3] == [f"own: {path}:2", "    # Mine.", "    GESTURECLASS beat"]


def test_an_unknown_name(capfdbinary: Captured) -> None:
    code, out, err = _run(capfdbinary, "gestures", "show", "smal")
    assert (code, out) == (2, "")
    assert "did you mean 'small" in err


def test_checking(capfdbinary: Captured, tmp_path: Path) -> None:
    assert _run(capfdbinary, "gestures", "check")[:2] == (0, "")
    path = tmp_path / "trial.gesture"
    path.write_text(gesture(), encoding="utf-8")
    assert _run(capfdbinary, "gestures", "check", str(path)) == (0, "", "no mistake in 1 files\n")
    path.write_text(gesture("ARMS none\nAIMD"), encoding="utf-8")
    code, _, err = _run(capfdbinary, "gestures", "check", str(tmp_path))
    assert code == 2
    assert f"{path}:4:6: 'none' is not an arm, nor both" in err
    assert f"{path}:5:1: no line begins with 'AIMD'; did you mean AIMED?" in err


def test_a_gesture_is_drawn(capfdbinary: Captured, tmp_path: Path) -> None:
    sheet = tmp_path / "sheet.png"
    code, _, err = _run(capfdbinary, "gestures", "render", "small", "-o", str(sheet), "--level", "high")
    assert code == 0
    assert err == f"3 key poses and the speeds of 1 gestures in {sheet}\n"
    assert sheet.read_bytes().startswith(b"\x89PNG")


def test_a_picture_has_the_name_of_one(capfdbinary: Captured, tmp_path: Path) -> None:
    code, _, err = _run(capfdbinary, "gestures", "render", "small", "-o", str(tmp_path / "sheet.jpg"))
    assert code == 2
    assert "pictures are PNG" in err

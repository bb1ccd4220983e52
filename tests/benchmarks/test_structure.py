"""What the measure of the house finds, and what it holds to."""

from pathlib import Path

from benchmarks.structure import function_lengths, modules, shared_names


def test_a_public_class_name_has_one_meaning() -> None:
    assert shared_names(modules()) == {}


def test_names_that_stand_twice_are_found_with_their_places(tmp_path: Path) -> None:
    paths = [tmp_path / name for name in ("one.py", "other.py")]
    paths[0].write_text("class Line: ...\nclass _Part: ...\nclass Word: ...\n", encoding="utf-8")
    paths[1].write_text("class Line: ...\nclass _Part: ...\n", encoding="utf-8")
    assert shared_names(paths) == {"Line": tuple(paths)}


def test_no_function_is_longer_than_a_page() -> None:
    assert max(function_lengths(modules())) <= 40

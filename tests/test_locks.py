"""The locks agree: what draws pictures, and what tests, comes on top of what the service is made of."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


def pinned(name: str) -> set[str]:
    """The packages of a lock, with their versions."""
    return set(re.findall(r"^[A-Za-z0-9._-]+==[^ ;]+", (ROOT / name).read_text(encoding="utf-8"), re.MULTILINE))


@pytest.mark.parametrize("name", ["requirements-plot.lock", "requirements-test.lock"])
def test_a_larger_lock_has_all_of_the_smallest(name: str) -> None:
    assert pinned("requirements.lock") <= pinned(name)


def test_a_checkout_can_draw_pictures() -> None:
    """`make perform` installs this lock."""
    assert any(each.startswith("matplotlib==") for each in pinned("requirements-plot.lock"))
    assert "-r requirements-plot.lock" in (ROOT / "Makefile").read_text(encoding="utf-8")

"""The table of mimes: mistakes in the file are told with their places, and every mime of ours is one of the lexicon."""

from pathlib import Path

import pytest

from understudy.behavior.mimes.table import MimeTable
from understudy.errors import AuthoringError

BEHAVIORS = {"mime_ring", "mime_stir"}


def load(folder: Path, text: str) -> MimeTable:
    path = folder / "mimes.yaml"
    path.write_text(text, encoding="utf-8")
    return MimeTable.load(path, BEHAVIORS)


def test_actions_are_kept_by_verb_in_the_order_of_the_file(tmp_path: Path) -> None:
    table = load(
        tmp_path,
        "people: [man]\nmimes:\n  mime_ring:\n    - {verbs: [ring], objects: [bell]}\n  mime_stir:\n"
        "    - {verbs: [stir, ring], without: [up], doer: told}\n",
    )
    assert [each.name for each in table.by_verb["ring"]] == ["mime_ring", "mime_stir"]
    (stir,) = table.by_verb["stir"]
    assert (stir.objects, stir.without, stir.told) == (frozenset(), frozenset({"up"}), True)


def test_an_unknown_behaviour_is_a_mistake_with_its_place_and_a_guess(tmp_path: Path) -> None:
    with pytest.raises(AuthoringError, match=r"no behaviour is called 'mime_rnig'.*mime_ring") as caught:
        load(tmp_path, "people: [man]\nmimes:\n  mime_rnig:\n    - {verbs: [ring]}\n")
    assert [mistake.line for mistake in caught.value.mistakes] == [4]


@pytest.mark.parametrize("line", ["{verbs: []}", "{verbs: [Ring]}", "{objects: [bell]}", "{verbs: [ring], doer: they}"])
def test_wrong_lines_are_mistakes(tmp_path: Path, line: str) -> None:
    with pytest.raises(AuthoringError):
        load(tmp_path, f"people: [man]\nmimes:\n  mime_ring:\n    - {line}\n")

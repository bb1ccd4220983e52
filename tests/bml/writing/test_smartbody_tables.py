"""The tables of what SmartBody can play, and mistakes in them."""

from pathlib import Path

import pytest

from understudy.bml.writing.smartbody_tables import FILE, SmartBodyTables
from understudy.errors import AuthoringError
from understudy.files import resource_folder
from understudy.model.formats import VisemeNames
from understudy.model.tables import PHONES

SHIPPED = (resource_folder("lexicon") / FILE).read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("there", "instead", "told"),
    [
        ("  ME: >-", "  MINE: >-", "the map has no type MINE"),
        ("LEFT: PLACE_LEFT", "LEFT: BEAT PLACE_LEFT", "BEAT has more than one type"),
        ("LEFT: PLACE_LEFT", "LEFT: RHYTHM PLACE_LEFT", "RHYTHM has more than one type"),
        ("    PP: {name: PBM}\n", "", "the shapes of smartbody are"),
        ("    PP: {name: Bump}", "    XX: {name: Bump}", "the shapes of facefx are"),
        ("WE: {right: [plain]}", "WE: {foot: [plain]}", "'left', 'right' or 'both'"),
        ("WE: {right: [plain]}", "WE: {right: []}", "at least 1"),
        ("20: {unit: 12,", "20: {unit: 24,", "the face lacks unit 24 too"),
        ("share: 0.5", "share: 1.5", "less than or equal to 1"),
    ],
)
def test_mistakes_are_found_with_their_place(tmp_path: Path, there: str, instead: str, told: str) -> None:
    assert there in SHIPPED
    path = tmp_path / FILE
    path.write_text(SHIPPED.replace(there, instead), encoding="utf-8")
    with pytest.raises(AuthoringError) as caught:
        SmartBodyTables.load(path)
    assert any(told in mistake.message for mistake in caught.value.mistakes)
    assert all(mistake.line > 1 for mistake in caught.value.mistakes)


def test_every_shape_of_our_mouth_has_a_name_in_every_set() -> None:
    tables = SmartBodyTables.load(resource_folder("lexicon") / FILE)
    assert {names: tables.visemes[names].keys() for names in VisemeNames} == dict.fromkeys(VisemeNames, PHONES.keys())

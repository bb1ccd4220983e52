"""Mistakes in authored files are reported with file and line, all at once."""

import shutil
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

import pytest

from understudy.authoring.catalogue import load_gestures
from understudy.authoring.file_checking import check_files
from understudy.authoring.proofreading import check_coverage, check_files_in_use
from understudy.errors import AuthoringError, InputError
from understudy.model import Level
from understudy.realizer.gestures.gesture import Expressivity
from understudy.realizer.gestures.library import Library

ROOT = Path(__file__).resolve().parents[2]


def test_what_is_in_use_has_no_mistake() -> None:
    check_files_in_use()
    assert check_files([ROOT / "app" / "rules", ROOT / "lexicon"]) > 20


GOOD_RULE = """rule fine
foreach
  fcn(negation, plain, $start, $end, $p)
choose
  weight 1
    small_shake($start, $end)
"""

WRONG = {
    "rule.rules": (GOOD_RULE.replace("$end)", "$stop)"), 6),
    "vocabulary_unknown.rules": (GOOD_RULE.replace("fcn(", "function("), 3),
    "words.yaml": ("class: negation\ngroups:\n  - {words: [no], meaning: plain, example: '{} way'}\n", 3),
    "unread.yaml": ("words: [no]\n", 1),
    "abbreviations.yaml": ("anywhere: {dr: doctor}\n", 1),
    "conflicts.yaml": ("within_class: []\nbetween: none\n", 2),
    "priorities.yaml": ("negation: {plain: 5}\naffirmation: {plain: much}\n", 2),
    "behaviors.yaml": ("behaviors: {}\ntimings: {}\nmore: 1\n", 3),
    "face.yaml": ("units: {}\nlexemes: {}\nmore: 1\n", 3),
    "families.yaml": ("gesture: {}\nhead: {}\nface: {frown: [smirk]}\nshows: {}\n", 3),
    "aliases.yaml": ("aliases:\n  WAVE: [HELLO]\n", 2),
    "wave.gesture": ("GESTURECLASS emblem\nGESTUREINSTANCE wave\nDURATION no\n", 3),
}


@pytest.mark.parametrize("name", sorted(WRONG))
def test_a_mistake_is_told_with_its_line(name: str, tmp_path: Path) -> None:
    content, line = WRONG[name]
    (tmp_path / name).write_text(content)
    with pytest.raises(AuthoringError) as caught:
        check_files([tmp_path / name])
    assert line in {mistake.line for mistake in caught.value.mistakes}
    assert {mistake.path for mistake in caught.value.mistakes} == {tmp_path / name}


def test_the_mistakes_of_all_files_come_at_once(tmp_path: Path) -> None:
    """Aliases are read against gestures, which have mistakes here; beside a file that nothing reads no words are."""
    together = WRONG.keys() - {"unread.yaml", "aliases.yaml"}
    for name in together:
        (tmp_path / name).write_text(WRONG[name][0])
    with pytest.raises(AuthoringError) as caught:
        check_files([tmp_path])
    assert {mistake.path.name for mistake in caught.value.mistakes} == together


def test_every_gesture_of_the_table_and_the_characters_can_be_shown() -> None:
    check_coverage(ROOT / "lexicon", load_gestures())


def test_a_gesture_that_cannot_be_shown_is_told_where_it_is_asked_for(tmp_path: Path) -> None:
    """The library is shown as without the gestures for ME, and without calm ones for YOU."""
    library = load_gestures()
    calm = MappingProxyType({Level.HIGH: Expressivity()})
    rest = [
        replace(one, levels=calm) if "YOU" in one.categories else one
        for one in library.definitions
        if "ME" not in one.categories
    ]
    shutil.copytree(ROOT / "lexicon", tmp_path / "lexicon")
    elder = tmp_path / "lexicon" / "characters" / "formal_elder.yaml"
    elder.write_text(elder.read_text(encoding="utf-8").replace("PALMS_TOGETHER", "PALMS_APART", 1), encoding="utf-8")
    with pytest.raises(AuthoringError) as caught:
        check_coverage(tmp_path / "lexicon", Library.of(rest))
    told = [(one.path.name, one.source_line.split(":")[0].strip(), one.message) for one in caught.value.mistakes]
    both = [
        (
            "formal_elder.yaml",
            "gesture_apology",
            "no gesture shows PALMS_APART at low, medium, high agitation with hand both",
        )
    ]
    assert [one for one in told if "PALMS" in one[2]] == both
    assert (
        "behaviors.yaml",
        "gesture_me_both",
        "no gesture shows ME at low, medium, high agitation with hand both",
    ) in told
    assert ("behaviors.yaml", "gesture_you", "no gesture shows YOU at low, medium agitation with hand left") in told


def test_good_files_are_counted(tmp_path: Path) -> None:
    (tmp_path / "fine.rules").write_text(GOOD_RULE)
    (tmp_path / "words.yaml").write_text("class: negation\ngroups:\n  - {words: [nay], example: '{}, I say'}\n")
    assert check_files([tmp_path]) == 2


SHEET = "description: shy\nhandedness: left\ngestures_per_minute: 8\nbehaviors:\n  NAME: {amount: 0.1}\n"


def test_a_character_is_checked_against_the_table_in_use_with_the_entries_beside_it(tmp_path: Path) -> None:
    sheet = tmp_path / "characters" / "shy.yaml"
    sheet.parent.mkdir()
    sheet.write_text(SHEET.replace("NAME", "shake"))
    assert check_files([sheet]) == 1
    sheet.write_text(SHEET.replace("NAME", "wag"))
    with pytest.raises(AuthoringError) as caught:
        check_files([tmp_path])
    assert {(mistake.path, mistake.line) for mistake in caught.value.mistakes} == {(sheet, 5)}
    entry = "wag: {channel: gesture, lexeme: BEAT, timing: gesture}"
    (tmp_path / "behaviors.yaml").write_text(f"behaviors:\n  {entry}\n")
    assert check_files([tmp_path]) == 2


def test_a_gesture_that_there_is_already_is_told(tmp_path: Path) -> None:
    gesture = tmp_path / "again.gesture"
    gesture.write_bytes((ROOT / "lexicon" / "gestures" / "small.gesture").read_bytes())
    with pytest.raises(AuthoringError) as caught:
        check_files([gesture])
    assert all("lexicon/gestures/again.gesture" in mistake.message for mistake in caught.value.mistakes)


@pytest.mark.parametrize("content", [None, b"caf\xe9"])
def test_files_that_cannot_be_read_are_told(content: bytes | None, tmp_path: Path) -> None:
    path = tmp_path / "some.rules"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        check_files([path])
    assert str(path) in caught.value.message


def test_a_right_file_is_not_called_right_when_its_neighbour_keeps_it_from_loading(tmp_path: Path) -> None:
    (tmp_path / "fine.yaml").write_text("class: negation\ngroups:\n  - {words: [nay], example: '{}, I say'}\n")
    (tmp_path / "broken.yaml").write_text("class: negation\n")
    with pytest.raises(AuthoringError) as caught:
        check_files([tmp_path / "fine.yaml"])
    assert {mistake.path.name for mistake in caught.value.mistakes} == {"broken.yaml"}

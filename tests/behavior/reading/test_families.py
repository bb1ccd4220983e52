"""The families of gestures, head movements and faces, and the behaviours that show them."""

import json
import re
from pathlib import Path

import pytest

from tests.support.shared_data import SHARED, needs
from understudy.behavior.reading.decoding import BOTH_AT_ONCE
from understudy.behavior.reading.families import Families, FamilyBehavior, fitting, load_families
from understudy.behavior.table.behavior_table import BehaviorTable, load_table
from understudy.errors import AuthoringError
from understudy.model import Channel, Level
from understudy.realizer.gestures.library import Library

ROOT = Path(__file__).resolve().parents[3]
LEXICON = ROOT / "lexicon"
PAGE = ROOT / "docs" / "families.md"
DIRECTING = SHARED / "directing"


@pytest.fixture(scope="module")
def table() -> BehaviorTable:
    return load_table(LEXICON / "behaviors.yaml")


@pytest.fixture(scope="module")
def families(table: BehaviorTable) -> Families:
    return load_families(LEXICON / "acting" / "families.yaml", table.lines)


def test_a_lemma_s_own_behaviour_goes_before_the_general_ones() -> None:
    general = FamilyBehavior("hold_between_hands")
    long = FamilyBehavior("draw_out", lemmas=frozenset({"long", "length"}))
    assert fitting((general, long), {"a", "long", "road"}, Level.LOW) == ("draw_out", "hold_between_hands")
    assert fitting((general, long), {"a", "short", "road"}, Level.LOW) == ("hold_between_hands",)


def test_a_behaviour_is_for_its_levels_of_agitation_only() -> None:
    small, large = FamilyBehavior("small"), FamilyBehavior("large", levels=frozenset({Level.HIGH}))
    assert fitting((large, small), (), Level.HIGH) == ("large", "small")
    assert fitting((large, small), (), Level.MEDIUM) == ("small",)


def test_every_family_but_stillness_has_a_behaviour_for_any_moment(families: Families) -> None:
    """An action that is shown needs to be known: there is no general one."""
    bare = {
        family
        for part in (families.gesture, families.head, families.face)
        for family, behaviors in part.items()
        if not all(fitting(behaviors, (), level) for level in Level)
    }
    assert bare == {"still", "neutral", "emblem_other"}


def test_every_gesture_of_the_library_is_read_as_something(families: Families) -> None:
    library = Library.load(LEXICON / "gestures")
    assert set(library.by_category) - families.shows.keys() == set()


def test_every_gesture_of_the_table_stands_under_a_family(families: Families, table: BehaviorTable) -> None:
    gestures = {name for name, line in table.lines.items() if line.channel is Channel.GESTURE}
    assert gestures - {each.name for behaviors in families.gesture.values() for each in behaviors} == set()


@needs(DIRECTING)
def test_what_the_lexemes_show_is_what_the_directing_says(families: Families) -> None:
    known = json.loads((DIRECTING / "families.json").read_text(encoding="utf-8"))
    ours = {lexeme: list(shown) for lexeme, shown in families.shows.items() if lexeme in known}
    assert len(ours) > 100
    assert ours == {lexeme: known[lexeme] for lexeme in ours}


@needs(DIRECTING)
def test_all_families_and_kinds_of_the_guide_are_there(families: Families) -> None:
    guide = (DIRECTING / "GUIDE.md").read_text(encoding="utf-8").replace("\n", " ")
    gestures = re.sub(r"\([^)]*\)", "", guide.partition("Gesture families:")[2].partition("Be consistent")[0])
    assert set(re.findall(r"[a-z_]+", gestures)) - {"that", "very"} == set(families.gesture)
    heads = re.search(r"head: ([a-z_, ]+)\. face: ([a-z_, ]+)\. gaze:", guide)
    assert heads is not None
    assert [set(names.split(", ")) for names in heads.groups()] == [
        set(families.head) - BOTH_AT_ONCE.keys(),
        set(families.face),
    ]


def test_the_page_names_every_family_and_kind(families: Families) -> None:
    rows = re.findall(r"^\| `(\w+)` \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(rows) == sorted([*families.gesture, *families.head, *families.face])


SMALLEST = """\
gesture:
  self: [gesture_me]
head:
  nod: [half_nod]
face:
  smile: [smile]
shows:
  ME: [self]
"""


@pytest.mark.parametrize(
    ("change", "line", "message"),
    [
        (("[gesture_me]", "[gesture_mee]"), 2, "no behaviour is called 'gesture_mee'; did you mean 'gesture_me'"),
        (("[half_nod]", "[smile]"), 4, "smile is a behaviour of face; head wants one of head or posture"),
        (("ME: [self]", "ME: [selfish]"), 8, "'selfish' is not a family of gestures; did you mean 'self'"),
        (("[gesture_me]", "[gesture_you]"), 8, "YOU is missing"),
        (("[gesture_me]", "[{behavior: gesture_me, lemmas: [My]}]"), 2, "pattern"),
        (("[gesture_me]", "[{behavior: gesture_me, agitation: [wild]}]"), 2, "'low', 'medium' or 'high'"),
        (("[gesture_me]", "[{behaviour: gesture_me}]"), 2, "unknown key"),
        (("ME: [self]", "ME: []"), 8, "at least 1 item"),
    ],
)
def test_a_mistake_is_told_with_its_place(
    tmp_path: Path, table: BehaviorTable, change: tuple[str, str], line: int, message: str
) -> None:
    path = tmp_path / "families.yaml"
    path.write_text(SMALLEST.replace(*change), encoding="utf-8")
    names = ["gesture_me", "half_nod", "smile", *(["gesture_you"] if "gesture_you" in change[1] else [])]
    with pytest.raises(AuthoringError, match=message) as caught:
        load_families(path, {name: table.lines[name] for name in names})
    assert line in {mistake.line for mistake in caught.value.mistakes}


def test_a_behaviour_stands_only_under_families_that_its_lexeme_shows(tmp_path: Path, table: BehaviorTable) -> None:
    path = tmp_path / "families.yaml"
    path.write_text(SMALLEST.replace("head:", "  heart: [gesture_me]\nhead:"), encoding="utf-8")
    with pytest.raises(AuthoringError, match="gesture_me is a ME, which `shows` says is read as self") as caught:
        load_families(path, {name: table.lines[name] for name in ("gesture_me", "half_nod", "smile")})
    assert [mistake.line for mistake in caught.value.mistakes] == [3]


def test_all_mistakes_come_at_once(tmp_path: Path, table: BehaviorTable) -> None:
    path = tmp_path / "families.yaml"
    path.write_text(SMALLEST.replace("half_nod", "half_nodd").replace("[smile]", "[blink]"), encoding="utf-8")
    with pytest.raises(AuthoringError) as caught:
        load_families(path, {name: table.lines[name] for name in ("gesture_me", "half_nod", "smile", "blink")})
    assert [mistake.line for mistake in caught.value.mistakes] == [4, 6]

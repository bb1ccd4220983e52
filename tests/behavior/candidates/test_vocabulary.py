"""The vocabulary of notes agrees with what the library of gestures, heads and faces can show."""

from pathlib import Path

from understudy.behavior.candidates.vocabulary import AVOIDABLE, FACES, GESTURES, HEADS, KINDS
from understudy.behavior.characters.overlays import Characters
from understudy.behavior.reading.decoding import BOTH_AT_ONCE
from understudy.behavior.reading.families import load_families

LEXICON = Path(__file__).resolve().parents[3] / "lexicon"


def test_whatever_can_be_asked_for_has_behaviours_that_show_it() -> None:
    entries = Characters.load(LEXICON).named("default").entries
    families = load_families(LEXICON / "acting" / "families.yaml", entries)
    for asked, shown in ((GESTURES, families.gesture), (HEADS, families.head), (FACES, families.face)):
        assert asked.keys() - shown.keys() <= {"still", "neutral"}
        assert shown.keys() <= asked.keys() | BOTH_AT_ONCE.keys()


def test_all_that_can_be_asked_for_can_be_avoided() -> None:
    assert {kind for kinds in KINDS.values() for kind in kinds} | {"hands", "any"} == AVOIDABLE

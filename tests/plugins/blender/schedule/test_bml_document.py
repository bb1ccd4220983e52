"""BML with strips moved, longer and out, read again by Understudy's own reader."""

from pathlib import Path

import pytest

from plugins.blender.schedule.bml_document import (
    StripChange,
    WrongBmlError,
    changed,
    character_of,
    described,
    text_of,
)
from tests.plugins.blender.documents import BML, REALIZED_S, SMARTBODY
from understudy.bml.reading.reader import read_bml
from understudy.bml.reading.resolving import resolve


def test_behaviours_are_found_by_local_name() -> None:
    assert [(each.id, each.kind, each.lexeme) for each in described(BML)] == [
        ("gesture1", "gesture", "NEGATION"),
        ("head1", "head", "SHAKE"),
        ("face1", "eyes", "BLINK"),
        ("posture1", "posture", "posture"),
    ]
    assert [(each.id, each.lexeme) for each in described(SMARTBODY)] == [("h1", "NOD"), ("g1", "RHYTHM")]
    assert (text_of(BML), character_of(BML), character_of(SMARTBODY)) == ("No, not those.", "anna", "")


def played_s(bml: bytes) -> dict[str, tuple[float, float]]:
    """Starts and ends by Understudy's reader."""
    document, _notices = read_bml(bml, Path("strips.bml"))
    return {each.id: (each.sync.start, each.sync.end) for each in resolve(document, ()).behaviors}


def test_a_moved_strip_takes_what_refers_to_it_along() -> None:
    found = played_s(changed(BML, {"gesture1": StripChange("gesture1", shift_s=0.25)}, REALIZED_S))
    assert found["gesture1"] == pytest.approx((0.35, 1.45))
    assert found["head1"] == pytest.approx((0.95, 1.45))
    assert found["face1"] == pytest.approx((2.0, 2.2))


def test_a_strip_that_refers_to_another_keeps_the_reference() -> None:
    again = changed(BML, {"head1": StripChange("head1", shift_s=-0.3)}, REALIZED_S)
    assert b'start="gesture1:stroke-0.200" end="gesture1:end-0.300"' in again
    assert played_s(again)["head1"] == pytest.approx((0.4, 0.9))


def test_what_is_taken_out_leaves_its_times_to_those_that_refer_to_it() -> None:
    again = changed(BML, {"gesture1": StripChange("gesture1", removed=True)}, REALIZED_S)
    assert b"NEGATION" not in again
    assert played_s(again)["head1"] == pytest.approx((0.7, 1.2))


def test_a_longer_strip_ends_later_and_starts_as_before() -> None:
    again = changed(BML, {"face1": StripChange("face1", longer_s=0.5)}, REALIZED_S)
    assert played_s(again)["face1"] == pytest.approx((2.0, 2.7))


def test_nothing_begins_before_the_block() -> None:
    again = changed(BML, {"gesture1": StripChange("gesture1", shift_s=-0.5)}, REALIZED_S)
    assert b'start="0.000" ready="0.000" stroke="0.100" end="0.700"' in again


def test_a_behaviour_without_times_gets_its_own() -> None:
    again = changed(BML, {"posture1": StripChange("posture1", shift_s=0.5)}, REALIZED_S)
    assert b'id="posture1" start="0.500"' in again


def test_smartbodys_dialect_is_moved_too() -> None:
    again = changed(SMARTBODY, {"g1": StripChange("g1", 0.2), "h1": StripChange("h1", 0.1)}, {})
    assert b'stroke="1.000" relax="1.200"' in again
    assert b'start="sp1:T1+0.100"' in again


def test_what_is_not_changed_stays_as_it_is() -> None:
    assert played_s(changed(BML, {}, REALIZED_S)) == played_s(BML)


@pytest.mark.parametrize(
    ("bml", "said"), [(b"{}", "not BML"), (b"<!DOCTYPE bml [<!ENTITY a 'b'>]><bml>&a;</bml>", "DOCTYPE")]
)
def test_what_cannot_be_read_is_refused(bml: bytes, said: str) -> None:
    with pytest.raises(WrongBmlError, match=said):
        described(bml)

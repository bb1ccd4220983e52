"""Constraints: points are brought together in whatever order they are named, and what cannot be is told."""

from itertools import permutations
from pathlib import Path
from time import process_time

import pytest

from tests.support.words.by_hand import spoken
from understudy.bml.reading.reader import read_bml
from understudy.bml.reading.resolving import ResolvedDocument, resolve
from understudy.model import SyncPoints, Word

CORE = 'xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b" characterId="c"'
WORDS = spoken("we come in peace", start_s=1.0)


def tie(*refs: str) -> str:
    points = "".join(f'<sync ref="{ref}"/>' for ref in refs)
    return f"<constraint><synchronize>{points}</synchronize></constraint>"


def resolved(inside: str, words: tuple[Word, ...] = ()) -> ResolvedDocument:
    return resolve(read_bml(f"<bml {CORE}>{inside}</bml>".encode(), Path("a.bml"))[0], words)


def synced(inside: str, words: tuple[Word, ...] = ()) -> tuple[dict[str, SyncPoints], list[str]]:
    """The sync points by id, and what the constraints that are not met say."""
    found = resolved(inside, words)
    missed = [notice.message for notice in found.notices if notice.code == "bml_constraint_missed"]
    return {each.id: each.sync for each in found.behaviors}, missed


@pytest.mark.parametrize("refs", list(permutations(["speech1:s1", "10"])))
def test_an_absolute_time_moves_the_speech_and_all_that_refers_to_it(refs: tuple[str, ...]) -> None:
    """As in `core__testspeechandnod_synctimed` of the conformance suite: the nod begins with the speech, before 10."""
    inside = """<speech id="speech1"><text>We <sync id="s1"/>come in peace</text></speech>
    <head id="nod1" lexeme="NOD" start="speech1:start"/>"""
    found = resolved(inside + tie(*refs), WORDS)
    assert found.speech_start_s == pytest.approx(10 - 1.4)
    assert found.behaviors[0].sync.start == pytest.approx(8.6)
    assert found.notices == ()
    assert [notice.code for notice in resolved(inside + tie(*refs)).notices] == ["speech_untimed"]


@pytest.mark.parametrize("refs", list(permutations(["f1:start", "h1:end"])))
def test_what_has_no_time_comes_to_what_is_timed(refs: tuple[str, ...]) -> None:
    inside = '<faceLexeme id="f1" lexeme="SMILE"/><head id="h1" lexeme="NOD" stroke="2.6"/>'
    found, missed = synced(inside + tie(*refs))
    alone, _ = synced(inside)
    assert found["h1"] == alone["h1"]
    assert found["f1"].start == found["h1"].end > 2.6
    assert found["f1"].end - found["f1"].start == pytest.approx(alone["f1"].end - alone["f1"].start)
    assert missed == []


@pytest.mark.parametrize("order", list(permutations(range(3))))
def test_what_is_timed_by_another_constraint_is_an_anchor_too(order: tuple[int, ...]) -> None:
    ties = [tie("g1:stroke", "h1:end + 0.5"), tie("f1:end", "g1:start"), tie("3", "h1:stroke")]
    inside = '<gesture id="g1" lexeme="BEAT"/><faceLexeme id="f1" lexeme="SMILE"/><head id="h1" lexeme="NOD"/>'
    found, missed = synced(inside + "".join(ties[number] for number in order))
    assert found["h1"].stroke == 3
    assert found["g1"].stroke == pytest.approx(found["h1"].end + 0.5)
    assert found["f1"].end == found["g1"].start
    assert missed == []


@pytest.mark.parametrize("refs", list(permutations(["h1:stroke", "g1:start"])))
def test_behaviours_without_a_time_move_with_all_that_refer_to_them(refs: tuple[str, ...]) -> None:
    inside = """<head id="h0" lexeme="NOD"/><head id="h1" lexeme="NOD" start="h0:end" stroke="h0:end + 0.4"/>
    <gesture id="g1" lexeme="BEAT" start="4"/>"""
    found, missed = synced(inside + tie(*refs))
    assert (found["h1"].stroke, found["g1"].start) == (4.0, 4.0)
    assert (found["h1"].start, found["h0"].end) == (3.6, 3.6)
    assert missed == []


@pytest.mark.parametrize("refs", list(permutations(["h1:stroke", "s1:w2"])))
def test_the_speech_stays_where_only_a_point_before_0_would_bring_them_together(refs: tuple[str, ...]) -> None:
    inside = """<speech id="s1"><text>we come <sync id="w2"/>in peace</text></speech>
    <head id="h1" lexeme="NOD" start="0.5"/>"""
    found, missed = synced(inside + tie(*refs), WORDS)
    assert (found["h1"].start, found["h1"].stroke) == (0.5, 1.8)
    assert missed == []


def test_a_speech_that_is_heard_ends_when_it_is_asked_to_and_keeps_its_length() -> None:
    said = "<text>we <sync id='s1'/>come in peace</text>"
    found = resolved(f'<speech id="s" end="6">{said}</speech><head id="h" lexeme="NOD" start="s:s1"/>', WORDS)
    assert (found.speech_start_s, found.behaviors[0].sync.start) == pytest.approx((3.4, 4.8))
    assert found.notices == ()
    found = resolved(
        f'<speech id="s" start="1" end="6">{said}</speech><head id="h" lexeme="NOD" start="s:end"/>', WORDS
    )
    assert (found.speech_start_s, found.behaviors[0].sync.start) == (1, 6)
    assert found.notices == ()
    (told,) = resolved(f'<speech id="s" end="2">{said}</speech>', WORDS).notices
    assert told.message == "s:end comes at 2.600 s, not at 2.000 s as asked: its words keep their times"


def test_words_that_nobody_hears_share_the_time_of_their_speech() -> None:
    speech = '<speech id="s" start="1" end="5"><text>we come <sync id="s1"/>in peace</text></speech>'
    found = resolved(f'{speech}<head id="h" lexeme="NOD" start="s:s1"/>')
    assert found.behaviors[0].sync.start == 3
    assert [notice.message.partition(": ")[2] for notice in found.notices] == [
        "they share its time evenly; send the audio"
    ]


def test_a_behaviour_of_another_block_is_none_of_this() -> None:
    inside = '<head id="h1" lexeme="NOD" start="4"/><head id="h2" lexeme="NOD" start="b7:h1:end"/>'
    found = resolved(f'{inside}<head id="h3" lexeme="NOD" start="b:h1:end"/>')
    assert [each.id for each in found.behaviors] == ["h1", "h3"]
    assert [notice.code for notice in found.notices] == ["bml_untimed"]


def test_every_constraint_that_is_not_met_is_told() -> None:
    inside = """<head id="h1" lexeme="NOD" stroke="2.6"/><gesture id="g1" lexeme="BEAT" stroke="4"/>
    <faceLexeme id="f1" lexeme="SMILE" start="h1:start"/>"""
    ties = tie("h1:stroke", "g1:stroke", "f1:attackPeak") + tie("g1:stroke", "5") + tie("h1:stroke", "b:start + 2.6")
    found, missed = synced(inside + ties)
    assert (found["h1"].stroke, found["g1"].stroke, found["f1"].ready) == (2.6, 4.0, 2.6)
    assert missed == [
        "g1:stroke comes at 4.000 s, not at 2.600 s together with h1:stroke as asked",
        "g1:stroke comes at 4.000 s, not at 5.000 s together with 5.000 as asked",
    ]


def test_a_constraint_that_goes_in_a_circle_loses_nothing() -> None:
    inside = '<gesture id="g1" lexeme="BEAT"/><head id="h1" lexeme="NOD" start="g1:end"/>' + tie("g1:start", "h1:end")
    found, missed = synced(inside)
    assert found.keys() == {"g1", "h1"}
    assert len(missed) == 1


def test_a_point_of_what_has_no_time_is_told() -> None:
    inside = '<head id="h1" lexeme="NOD" start="g1:end"/><gesture id="g1" lexeme="BEAT" start="h1:end"/>'
    _found, missed = synced(inside + tie("h1:start", "3"))
    assert missed == ["h1:start has no time, not at 3.000 s together with 3.000 as asked"]


@pytest.mark.parametrize(
    ("constraint", "points"),
    [
        ('<after ref="b7:g1:end"><sync ref="h1:start"/></after>', ["b7:g1:end"]),
        ('<before ref="2"><sync ref="h1:start"/><sync ref="b7:g1:end"/></before>', ["b7:g1:end"]),
        ('<synchronize><sync ref="b7:g1:end"/><sync ref="b8:g1:end"/></synchronize>', ["b7:g1:end", "b8:g1:end"]),
    ],
)
def test_a_constraint_on_a_point_without_a_time_is_told(constraint: str, points: list[str]) -> None:
    _found, missed = synced(f'<head id="h1" lexeme="NOD"/><constraint>{constraint}</constraint>')
    assert missed == [f"{point} has no time here, so that its constraint cannot be met" for point in points]


def test_many_constraints_of_many_behaviours_are_read_in_time() -> None:
    """They were quadratic, and each constraint resolves the block anew."""
    heads = "".join(f'<head id="h{n}" lexeme="NOD" start="h{n + 1}:end"/>' for n in range(400))
    ties = "".join(tie(f"h{n}:stroke", f"h{n + 7}:end") for n in range(390))
    began_s = process_time()
    found = resolved(f'{heads}<head id="h400" lexeme="NOD"/>{ties}')
    assert len(found.behaviors) == 401
    assert process_time() - began_s < 10

"""BML resolved to behaviours: what we write is recovered, and others' BML gets absolute times."""

from dataclasses import replace
from pathlib import Path

import pytest

from tests.bml.writing.test_writer import everything
from tests.support.shared_data import BML_SUITE, needs
from tests.support.words.by_hand import spoken
from understudy.behavior.table.behavior_table import STROKED
from understudy.bml.reading.reader import read_bml
from understudy.bml.reading.resolving import ResolvedDocument, resolve
from understudy.bml.writing.writer import write_bml
from understudy.errors import WrongBmlError
from understudy.model import Behavior, Channel, Interval, Level, Word
from understudy.model.formats import BmlForm, DialectName, TimeForm

CORE = 'xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b" characterId="c"'


def resolved(inside: str, words: tuple[Word, ...] = ()) -> ResolvedDocument:
    document, _notices = read_bml(f"<bml {CORE}>{inside}</bml>".encode(), Path("a.bml"))
    return resolve(document, words)


def in_core_bml(behavior: Behavior) -> Behavior:
    """What core BML can say of one of our behaviours."""
    shifts = behavior.lexeme == "SHIFT"
    sync = behavior.sync
    return replace(
        behavior,
        sync=replace(sync, ready=sync.end, relax=sync.end) if shifts else sync,
        priority=0.0,
        amount=None if behavior.kind in (Channel.GESTURE, Channel.POSTURE) else behavior.amount,
        first=0,
        last=0,
    )


@pytest.mark.parametrize("timing", TimeForm)
def test_what_is_written_in_the_core_comes_back(timing: TimeForm) -> None:
    performance = everything()
    content = write_bml(performance, BmlForm(DialectName.BML, timing))
    found = resolve(read_bml(content, Path("a.bml"))[0], performance.utterance.words)
    assert found.notices == ()
    back = {behavior.id: replace(behavior, first=0, last=0) for behavior in found.behaviors}
    for behavior in performance.behaviors:
        assert back[behavior.id] == in_core_bml(behavior)


def test_smartbodys_dialect_gives_lips_style_and_priorities() -> None:
    performance = everything()
    content = write_bml(performance, BmlForm(DialectName.SMARTBODY))
    found = resolve(read_bml(content, Path("a.bml"))[0], performance.utterance.words)
    gestures = [behavior for behavior in found.behaviors if behavior.kind is Channel.GESTURE]
    asked = [behavior for behavior in performance.behaviors if behavior.kind is Channel.GESTURE]
    assert [each.sync.stroke for each in gestures] == [each.sync.stroke for each in asked]
    assert {each.priority for each in gestures} == {1.0}
    assert all(each.sync.stroke is None for each in found.behaviors if each.kind not in STROKED)


def test_smartbodys_style_is_the_agitation_and_its_lips_are_visemes() -> None:
    act = """<act><participant id="a" role="actor"/><bml><gesture type="BEAT" style="high" stroke="1" relax="2"/>
    <lips viseme="PP" articulation="0.5" start="0.1" ready="0.12" relax="0.18" end="0.2"/>
    <gaze target="you" sbm:joint-range="EYES" xmlns:sbm="http://ict.usc.edu" start="0.5"/>
    <gaze target="me" start="1.5"/></bml></act>"""
    found = resolve(read_bml(act.encode(), Path("a.xml"))[0])
    assert found.agitation is Level.HIGH
    [viseme] = found.visemes
    assert (viseme.label, viseme.interval, viseme.articulation) == ("PP", Interval(0.1, 0.2), 0.5)
    gazes = [(each.lexeme, each.target, each.sync.end) for each in found.behaviors if each.kind is Channel.GAZE]
    assert gazes == [("GLANCE", "you", 1.5), ("SHIFT", "me", 1.65)]


def test_marks_of_the_speech_lie_where_its_words_are_heard() -> None:
    words = spoken("hold that thought", start_s=1.0)
    inside = """<speech id="s" start="0.5"><text>hold <sync id="m"/>that thought</text></speech>
    <head id="h" lexeme="NOD" stroke="s:m"/><gesture id="g" lexeme="BEAT" stroke="s:end - 0.2"/>"""
    found = resolved(inside, words)
    nod, beat = found.behaviors
    assert nod.sync.stroke == pytest.approx(0.5 + 1.4)
    assert (nod.first, beat.first) == (1, 2)
    assert beat.sync.stroke == pytest.approx(0.5 + 2.2 - 0.2)
    assert found.words[0].interval == Interval(1.5, 1.9)


def test_without_a_recording_words_are_guessed_and_it_is_said() -> None:
    inside = (
        """<speech id="s"><text>one two <sync id="m"/>three</text></speech><head id="h" lexeme="NOD" start="s:m"/>"""
    )
    found = resolved(inside)
    assert found.behaviors[0].sync.start == pytest.approx(0.7)
    assert [notice.code for notice in found.notices] == ["speech_untimed"]


def test_constraints_tie_points_together_and_wishes_are_checked() -> None:
    inside = """<head id="h" lexeme="NOD" start="1"/><gesture id="g" lexeme="BEAT"/>
    <constraint><synchronize><sync ref="h:stroke"/><sync ref="g:stroke + 0.1"/></synchronize></constraint>
    <constraint><before ref="h:start"><sync ref="g:end"/></before></constraint>"""
    found = resolved(inside)
    by_id = {each.id: each.sync for each in found.behaviors}
    assert by_id["h"].stroke is not None
    assert by_id["g"].stroke == pytest.approx(by_id["h"].stroke - 0.1)
    assert [notice.code for notice in found.notices] == ["bml_constraint_missed"]


def test_a_constraint_may_tie_times_alone() -> None:
    found = resolved("""<head id="h" lexeme="NOD" start="1"/>
    <constraint><synchronize><sync ref="1.5"/></synchronize></constraint>""")
    assert [each.id for each in found.behaviors] == ["h"]


def test_what_is_not_played_is_said() -> None:
    inside = '<locomotion id="l" target="door"/><head id="h" lexeme="NOD" start="x:y:end"/>'
    with pytest.raises(WrongBmlError):
        resolved(inside.replace("x:y:end", "nobody:end"))
    found = resolved(inside)
    assert found.behaviors == ()
    assert sorted(notice.code for notice in found.notices) == ["bml_not_played", "bml_untimed"]


def test_a_wait_lasts_as_long_as_it_may() -> None:
    found = resolved('<wait id="w" start="1" max-wait="2"/><head id="n" lexeme="NOD" start="w:end"/>')
    assert [each.sync.start for each in found.behaviors] == [3.0]
    assert found.notices == ()
    endless = resolved('<wait id="w" start="1"/><head id="n" lexeme="NOD" start="w:end"/>')
    assert [each.code for each in endless.notices] == ["bml_not_played"]


def test_stances_and_further_poses_that_are_not_played_are_said() -> None:
    poses = '<pose part="ARMS" lexeme="ARMS_OPEN"/><pose part="LEGS" lexeme="LEGS_OPEN"/>'
    found = resolved(f'<posture id="p" start="0" end="5"><stance type="SITTING"/>{poses}</posture>')
    assert [each.lexeme for each in found.behaviors] == ["ARMS_OPEN"]
    assert [each.message for each in found.notices] == [
        "the stance SITTING of p is not played: bodies always stand",
        "the pose LEGS_OPEN of p is not played: a body takes one pose at a time, here ARMS_OPEN",
    ]
    stands = resolved('<posture id="p" start="0" end="5"><stance type="STANDING"/></posture>')
    assert [each.code for each in stands.notices] == ["bml_not_played"], "nothing to show"


@needs(BML_SUITE)
def test_every_file_of_the_suite_that_is_read_is_resolved_in_order() -> None:
    for path in sorted(BML_SUITE.glob("*.xml")):
        try:
            document, _notices = read_bml(path.read_bytes(), path)
        except WrongBmlError:
            continue
        for behavior in resolve(document).behaviors:
            times_s = [time_s for _name, time_s in behavior.sync.in_order()]
            assert times_s == sorted(times_s), path.name
            assert times_s[0] >= 0, path.name


@needs(BML_SUITE)
def test_the_suites_own_comment_on_three_gestures_is_fulfilled() -> None:
    """Its comment: relaxleft starts half a second after g1 ends, transleft ends where g1 starts, nothing before 0."""
    path = BML_SUITE / "core__testspeechgestures.xml"
    by_id = {each.id: each.sync for each in resolve(read_bml(path.read_bytes(), path)[0]).behaviors}
    assert by_id["relaxleft"].start == pytest.approx(by_id["g1"].end + 0.5)
    assert by_id["transleft"].end == pytest.approx(by_id["g1"].start)
    assert by_id["transleft"].start == 0

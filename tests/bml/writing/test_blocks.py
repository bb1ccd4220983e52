"""Writing and reading the record of a performance."""

from dataclasses import replace
from pathlib import Path

import pytest
from lxml import etree

from tests.support.bml.bml_checker import check
from tests.support.words.by_hand import FIGURE_8, spoken, utterance
from understudy.bml.markup.elements import CORE, OURS, RECORD_TYPE
from understudy.bml.reading.reader import read_bml
from understudy.bml.reading.record import read_record
from understudy.bml.writing.writer import to_xml, write_bml
from understudy.errors import WrongBmlError
from understudy.model import Behavior, Channel, Hand, Level, Manner, Notice, Performance, SyncPoints, Word

SYNC = SyncPoints(start=0.1, ready=0.25, stroke_start=0.3, stroke=0.4, stroke_end=0.5, relax=0.75, end=1.0)
GESTURE = Behavior(
    "gesture1",
    Channel.GESTURE,
    "POINT",
    SYNC,
    2,
    4,
    5.125,
    rule="by_hand",
    function="f1",
    hand=Hand.LEFT,
    amount=0.35,
    target="door",
    moment="m1",
    reason='0.1 s before its word, "so" & so',
    manner=Manner(1.25, 0.8, 1.1),
)
WORDS = (
    *(replace(word, prominence=1 / 3, stressed_ratio=0.1, spread=True) for word in spoken(FIGURE_8)),
    Word(12, "(unsaid)"),
)
LINE = replace(utterance(WORDS[:-1], Level.HIGH), words=WORDS)
NOTICES = (Notice("audio_quiet", "very quiet"),)
PERFORMANCE = Performance(LINE, (), (GESTURE,), "default", 7, NOTICES, stillness=0.25)
BML = write_bml(PERFORMANCE)


def test_what_the_core_cannot_say_comes_back_exactly() -> None:
    document, notices = read_bml(BML, Path("a.bml"))
    assert notices == ()
    record = read_record(document)
    assert record is not None
    assert record.words == WORDS
    assert (record.agitation, record.stillness, record.seed) == (Level.HIGH, 0.25, 7)
    assert (record.duration_s, record.notices) == (LINE.duration_s, NOTICES)
    bare = Behavior("gesture1", Channel.GESTURE, "POINT", SYNC, 0, 0, 0.0, hand=Hand.LEFT)
    assert record.completed(bare) == GESTURE
    assert record.completed(replace(bare, id="other")) == replace(bare, id="other")


def test_the_record_is_where_realizers_skip_it() -> None:
    """In a description after the text of the speech, nowhere else, in a namespace of its own."""
    assert check(BML) == []
    speech, gesture = etree.fromstring(BML)
    assert [part.tag for part in speech] == [f"{{{CORE}}}text", f"{{{CORE}}}description"]
    assert speech[1].get("type") == RECORD_TYPE
    assert all(etree.QName(part).namespace == OURS for part in speech[1].iterdescendants("*"))
    assert not any("{" in str(name) for name in gesture.attrib)


def test_it_is_read_and_written_byte_for_byte() -> None:
    document, _notices = read_bml(BML, Path("a.bml"))
    assert to_xml(document) == BML


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (b'priority="5.125"', b'priority="high"', "priority='high' is not a fixed decimal"),
        (b'agitation="high"', b'agitation="huge"', "agitation='huge' is not one of high, low, medium"),
        (b' moment="m1"', b' momento="m1"', "unknown attribute momento; did you mean moment?"),
        (b'phones="T 1.', b'phones="T one ', "is not phones: the label, start and end of each"),
    ],
)
def test_what_is_wrong_in_it_is_told_with_its_place(old: bytes, new: bytes, message: str) -> None:
    assert old in BML
    with pytest.raises(WrongBmlError, match="line") as raised:
        read_bml(BML.replace(old, new, 1), Path("a.bml"))
    assert message in raised.value.mistakes[0].message


def test_what_others_put_into_descriptions_is_left_alone() -> None:
    theirs = b'<description priority="2" type="x"><a xmlns="urn:x" b="c"><d/></a></description>'
    document, notices = read_bml(BML.replace(b"</speech>", theirs + b"</speech>"), Path("a.bml"))
    assert read_record(document) is not None
    assert notices == ()

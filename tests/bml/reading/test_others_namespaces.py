"""Documents whose names are of other times: a prefix that nobody declared, and Greta's first namespace."""

from pathlib import Path

import pytest

from understudy.bml.markup.documents import Document
from understudy.bml.markup.elements import SBM
from understudy.bml.reading.reader import read_bml
from understudy.bml.reading.resolving import resolve
from understudy.bml.writing.writer import to_xml
from understudy.errors import WrongBmlError
from understudy.model import Channel, Notice
from understudy.model.formats import DialectName

ACT = """<?xml version="1.0"
  encoding="UTF-8"?>
<act><participant id="brad" role="actor"/><bml>
  <gesture type="YOU" stroke="1" relax="2" sbm:style="high" sbm:frequency="0.05"/>
  <gaze target="ann" sbm:joint-range="EYES NECK" start="0.5"/>
</bml></act>
"""

GRETA = """<?xml version="1.0" encoding="UTF-8"?>
<bml xmlns="http://www.mindmakers.org/projects/BML" character="Greta" composition="blend" reaction_type="NONE">
  <speech xmlns="" id="s1" language="english" start="0.0" text="" type="SAPI4">
    <description level="1" type="gretabml"><reference>line.pho</reference></description>
    <tm id="tm1"/>Good <tm id="tm2"/>evening, friends. <tm id="tm3"/>
    <boundary end="s1:tm3+0.5" id="b1" start="s1:tm3" type="LL"/>
  </speech>
  <head end="1.6" id="pa1_0" lexeme="Aside_Right" start="-0.56">
    <description priority="1" type="gretabml"><reference>ASIDE</reference><intensity>1.000</intensity></description>
  </head>
  <face amount="0.500" end="1.6" id="pa1-1" start="-0.6"><lexeme lexeme="joy"/></face>
  <gesture end="2.7" id="pa1_0" lexeme="Beat_Low" start="s1:tm2"/>
  <torso id="t1" start="0" lexeme="Neutral"/>
</bml>
"""


def read(text: str) -> tuple[Document, tuple[Notice, ...]]:
    return read_bml(text.encode(), Path("a.xml"))


def test_smartbodys_prefix_needs_no_declaration() -> None:
    document, (notice,) = read(ACT)
    declared, told = read(ACT.replace("<act>", f'<act xmlns:sbm="{SBM}">'))
    assert told == ()
    assert (notice.code, SBM in notice.message) == ("bml_namespace", True)
    assert document == declared
    assert document.dialect is DialectName.SMARTBODY
    assert [behavior.kind for behavior in resolve(document).behaviors] == [Channel.GESTURE, Channel.GAZE]


def test_mistakes_are_where_they_were_without_it() -> None:
    with pytest.raises(WrongBmlError) as caught:
        read(ACT.replace('stroke="1"', 'stroke="soon"'))
    assert [(each.line, each.column) for each in caught.value.mistakes] == [(4, 3)]
    with pytest.raises(WrongBmlError) as caught:
        read(f"{ACT}<act/>")
    assert "not well-formed XML" in caught.value.message


@pytest.mark.parametrize(
    ("prefix", "remedy"),
    [("bmlt", 'xmlns:bmlt="http://hmi.ewi.utwente.nl/bmlt"'), ("mine", 'xmlns:mine="its namespace"')],
)
def test_the_remedy_for_another_prefix_is_named(prefix: str, remedy: str) -> None:
    with pytest.raises(WrongBmlError) as caught:
        read(ACT.replace("sbm:frequency", f"{prefix}:frequency"))
    assert remedy in caught.value.message
    assert [(each.line, each.column) for each in caught.value.mistakes] == [(4, 3)]


def test_gretas_first_namespace_is_read() -> None:
    document, notices = read(GRETA)
    assert document.dialect is DialectName.BML
    assert notices[0].code == "bml_translated"
    assert "shifted by 0.600 s" in notices[0].message
    assert {notice.code for notice in notices[1:]} == {"bml_foreign"}
    found = resolve(document)
    assert (found.character, found.speech_start_s) == ("Greta", 0.6)
    face, head, gesture = found.behaviors
    assert (face.id, face.lexeme, face.amount, face.sync.start) == ("pa1_1", "RAISE_MOUTH_CORNERS", 0.5, 0.0)
    assert (head.lexeme, head.sync.start, head.sync.end) == ("TILT_RIGHT", 0.04, 2.2)
    assert (gesture.id, gesture.lexeme, gesture.sync.start, gesture.sync.end) == ("pa1_0_2", "Beat_Low", 0.95, 3.3)
    assert read(to_xml(document).decode())[0] == document


def test_the_level_of_a_description_is_its_priority() -> None:
    """As BML had it before 1.0; anywhere, not in a speech alone."""
    older = GRETA.replace('<description priority="1"', '<description level="2"')
    (head,) = [part for part in read(older)[0].root.children if part.name == "head"]
    (description,) = head.children
    assert description.attributes["priority"] == 2
    assert resolve(read(older)[0]).behaviors == resolve(read(GRETA)[0]).behaviors


def test_a_look_without_a_target_is_at_the_listener() -> None:
    inside = '<gaze id="g" start="0" end="2" modality="TORSO" offsetDirection="DOWN" offsetAngle="30"/>'
    (gaze,) = resolve(read(f'<bml xmlns="http://www.mindmakers.org/projects/BML">{inside}</bml>')[0]).behaviors
    assert (gaze.target, gaze.direction, gaze.amount) == ("listener", "DOWN", 0.5)

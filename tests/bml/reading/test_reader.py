"""Other people's files: the conformance suite's, wrong ones, and hostile ones."""

from pathlib import Path

import pytest

from tests.support.shared_data import BML_SUITE, needs
from understudy.bml.markup.documents import Document, Element, Reference
from understudy.bml.markup.parsing import ReadingLimits
from understudy.bml.reading.reader import MOST_MISTAKES, read_bml
from understudy.bml.writing.writer import to_xml
from understudy.errors import TooLargeError, WrongBmlError
from understudy.model.formats import DialectName

FILES = sorted(path.stem for path in BML_SUITE.glob("*.xml"))
needs_suite = needs(BML_SUITE)

REFUSED = {
    "core__bmlnoid": (13, "<bml>: no id"),
    "core__testgazeoverlap": (6, "<gaze gaze2>: it overlaps on the same joints with <gaze gaze1>"),
}
"""The files that the suite has to be refused or to lose a behaviour, with line and reason."""

RIGHT = """\
<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="bml1" characterId="Anna">
  <speech id="s1" start="0"><text><sync id="w0"/>Oh <sync id="w1"/></text></speech>
  <gesture id="g1" lexeme="BEAT" mode="LEFT_HAND"
    start="0.1" ready="0.2" strokeStart="0.2" stroke="0.3" end="1"/>
  <head id="h1" lexeme="NOD" amount="0.5" start="s1:w0 + 0.2" end="s1:w0 + 1"/>
  <gaze id="z1" target="Ben" influence="EYES" start="0" end="1"/>
  <constraint><before ref="h1:end"><sync ref="g1:stroke"/></before></constraint>
</bml>
"""

SMARTBODY = """\
<act><participant id="brad" role="actor"/><bml>
  <speech id="sp1"><text><sync id="T0" time="0"/>Hi<sync id="T1" time="0.23"/></text></speech>
  <lips viseme="E" articulation="1.0" start="0" ready="0.1" relax="0.1" end="0.2"/>
  <gesture type="YOU" stroke="sp1:T0+.1"/>
  <sbm:event xmlns:sbm="http://ict.usc.edu" message="spoke" stroke="sp1:T1"/>
  <animation name="beat" start="1"/>
</bml></act>
"""


def read(text: str) -> Document:
    return read_bml(text.encode(), Path("take.bml"))[0]


def refusal(text: str | bytes, limits: ReadingLimits | None = None) -> WrongBmlError:
    content = text if isinstance(text, bytes) else text.encode()
    with pytest.raises(WrongBmlError) as caught:
        read_bml(content, Path("take.bml"), limits or ReadingLimits())
    assert caught.value.code == "bml_wrong"
    assert "\n" not in caught.value.message
    return caught.value


@needs_suite
@pytest.mark.parametrize("name", [name for name in FILES if name not in REFUSED])
def test_every_file_of_the_suite_is_read_and_comes_back_from_what_is_written(name: str) -> None:
    document, notices = read_bml((BML_SUITE / f"{name}.xml").read_bytes(), Path(f"{name}.xml"))
    again, _ = read_bml(to_xml(document), Path("again.xml"))
    assert again == document
    if name.startswith("core__"):
        assert notices == ()


@needs_suite
@pytest.mark.parametrize("name", sorted(REFUSED))
def test_the_wrong_files_of_the_suite_are_refused_with_the_reason(name: str) -> None:
    line, reason = REFUSED[name]
    (mistake,) = refusal((BML_SUITE / f"{name}.xml").read_bytes()).mistakes
    assert mistake.line == line
    assert reason in mistake.message


@needs_suite
@pytest.mark.parametrize(
    ("name", "reported"),
    [
        ("asap__activate__testactivate", "<{http://www.asap-project.org/bmla}activate> (line 7, 1 in all)"),
        ("asap__appendafter__testnodappendafter", "composition='APPEND-AFTER(bml1,bml2)' (line 5, 1 in all)"),
        ("asap__chunking__secondchunk", "the attribute {http://www.asap-project.org/bmla}chunkAfter (line 1"),
        ("asap__interruptbehavior__testspeechinterrupt", "bmla}interrupt> (line 6, 2 in all)"),
        ("bmlis__filler", "the attribute {http://www.asap-project.org/bmlis}generatefiller (line 2"),
        ("bmlt__bmltaudio", "<{http://hmi.ewi.utwente.nl/bmlt}audiofile> (line 12"),
        ("murml__murmlhandlocation", "<{http://www.techfak.uni-bielefeld.de/ags/soa/murml}murmlgesture> (line 2"),
    ],
)
def test_extensions_are_reported(name: str, reported: str) -> None:
    _, notices = read_bml((BML_SUITE / f"{name}.xml").read_bytes(), Path(f"{name}.xml"))
    assert {notice.code for notice in notices} == {"bml_foreign"}
    assert any(reported in notice.message for notice in notices)


@needs_suite
def test_extensions_are_not_lost() -> None:
    path = BML_SUITE / "murml__murmlbodykeyframe.xml"
    document, _ = read_bml(path.read_bytes(), path)
    postures = to_xml(document).decode().count("Humanoid (l_shoulder 3 100 0 0)")
    assert postures == path.read_text().count("Humanoid (l_shoulder 3 100 0 0)") > 0


def test_values_have_their_types() -> None:
    _, gesture, head, *_ = read(RIGHT).root.children
    assert gesture.attributes["start"] == 0.1
    assert head == Element(
        "head",
        {
            "id": "h1",
            "lexeme": "NOD",
            "amount": 0.5,
            "start": Reference("s1", "w0", 0.2),
            "end": Reference("s1", "w0", 1.0),
        },
    )


def test_smartbodys_dialect_is_told_by_its_root() -> None:
    document, notices = read_bml(SMARTBODY.encode(), Path("take.bml"))
    assert document.dialect is DialectName.SMARTBODY
    gesture = next(part for part in list(document.root.children)[1].children if part.name == "gesture")
    assert gesture.attributes["stroke"] == Reference("sp1", "T0", 0.1)
    assert ["event" in notice.message or "animation" in notice.message for notice in notices] == [True, True]
    assert read_bml(to_xml(document), Path("again"))[0] == document


@pytest.mark.parametrize(
    ("old", "new", "line", "message"),
    [
        ("</bml>", "", 9, "not well-formed XML"),
        ('bml-1.0" id', 'bml-2.0" id', 1, "the root element is"),
        (' id="bml1"', "", 1, "<bml>: no id"),
        ('characterId="Anna"', 'character="Anna"', 1, "unknown attribute character; write characterId"),
        ('characterId="Anna"', 'composition="merge"', 1, "composition='merge' is not one of APPEND, MERGE, REPLACE"),
        ('id="g1"', 'id="g-1"', 3, "id='g-1' is not an id"),
        ('id="h1"', 'id="g1"', 5, "<head g1>: duplicate id, first used in line 3"),
        ('id="h1"', 'id="bml1"', 5, "duplicate id, first used in line 1"),
        ('id="w1"', 'id="w0"', 2, "<sync w0>: duplicate id, first used in line 2"),
        ('lexeme="BEAT" ', "", 3, "<gesture g1>: no lexeme"),
        ('lexeme="BEAT"', 'lexeme=" "', 3, "lexeme=' ' is empty"),
        ("LEFT_HAND", "LEFT", 3, "mode='LEFT' is not one of"),
        ('stroke="0.3"', 'stroke="3e-1"', 3, "stroke='3e-1' is not a time"),
        ('stroke="0.3"', 'Stroke="0.3"', 3, "unknown attribute Stroke; did you mean stroke"),
        ('stroke="0.3"', 'stroke="0.1"', 3, "stroke comes before strokeStart"),
        ("s1:w0 + 1", "s1:w0 - 1", 5, "end comes before start"),
        ('start="0.1"', 'start="-0.1"', 3, "start is before 0"),
        ('amount="0.5"', 'amount="1.5"', 5, "amount='1.5' is not a fixed decimal from 0 to 1"),
        ('amount="0.5"', f'amount="{"9" * 400}"', 5, "is not a fixed decimal from 0 to 1"),
        ("s1:w0 + 0.2", "s2:w0", 5, "no behaviour has the id 's2'"),
        ("s1:w0 + 0.2", "s1:w9", 5, "<speech s1> has no point 'w9'"),
        ("s1:w0 + 0.2", "s1:stroke", 5, "<speech s1> has no point 'stroke'"),
        ("h1:end", "h9:end", 7, "no behaviour has the id 'h9'"),
        ("g1:stroke", "g1:peak", 7, "<gesture g1> has no point 'peak'"),
        ("<gaze", "<gaz", 6, "<gaz> is not allowed in <bml>; did you mean gaze?"),
        (
            '<gaze id="z1" target="Ben" influence="EYES"',
            '<face id="z1"',
            6,
            "<face> is not allowed in <bml>; it is abstract",
        ),
        ('<gaze id="z1" target="Ben" influence="EYES"', '<wave id="z1"', 6, "<wave> is not allowed in <bml>"),
        ('<gaze id="z1" target="Ben" influence="EYES"', '<wave xmlns="" id="z1"', 6, "<wave> is not allowed in <bml>"),
        ('<gaze id="z1" target="Ben"', '<gaze id="z1"', 6, "<gaze z1>: no target"),
        ("<text>", "<text><head/>", 2, "<head> is not allowed in <text>"),
        ('<text><sync id="w0"/>Oh <sync id="w1"/></text>', "", 2, "<speech s1>: no <text> inside"),
        ("  <constraint>", "  so <constraint>", 6, "text 'so' after <gaze z1>"),
        ('<sync ref="g1:stroke"/>', "", 7, "<before>: no <sync> inside"),
    ],
)
def test_a_wrong_file_is_refused_at_its_line(old: str, new: str, line: int, message: str) -> None:
    assert old in RIGHT
    error = refusal(RIGHT.replace(old, new, 1))
    assert [mistake for mistake in error.mistakes if mistake.line == line and message in mistake.message], error


def test_every_mistake_is_told_with_its_source_line() -> None:
    wrong = RIGHT.replace('lexeme="BEAT" ', "").replace('target="Ben" ', "").replace("s1:w0 + 0.2", "s9:w0")
    mistakes = refusal(wrong).mistakes
    assert [mistake.line for mistake in mistakes] == [3, 6, 5]
    assert mistakes[0].source_line[mistakes[0].column - 1 :].startswith("<gesture")
    assert all(mistake.path == Path("take.bml") for mistake in mistakes)


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_a_line_may_end_as_xml_lets_it(line_end: str) -> None:
    [mistake] = refusal(RIGHT.replace('lexeme="BEAT" ', "").replace("\n", line_end)).mistakes
    assert (mistake.line, mistake.source_line.strip()[:8]) == (3, "<gesture")


def test_gazes_of_other_joints_or_at_another_time_may_be() -> None:
    second = '<gaze id="z2" target="Cy" influence="{}" start="{}" end="2"/></bml>'
    for influence, start in (("NECK", 0.5), ("EYES", 1)):
        assert read(RIGHT.replace("</bml>", second.format(influence, start)))
    refusal(RIGHT.replace("</bml>", second.format("EYES", 0.5)))


def test_a_description_is_its_authors_own() -> None:
    described = '<description priority="1" type="x"><b c="1">very<wave/></b> loud</description></speech>'
    document = read(RIGHT.replace("</speech>", described))
    assert read(to_xml(document).decode()) == document
    assert b"very" in to_xml(document)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('<!DOCTYPE bml [<!ENTITY a "aaaa">]><bml>&a;</bml>', "BML has no DOCTYPE"),
        ('<!DOCTYPE bml SYSTEM "http://127.0.0.1:9/a.dtd"><bml/>', "BML has no DOCTYPE"),
        ("<bml>&a;</bml>", "undefined entity"),
        ("<bml>" * 40 + "</bml>" * 40, "elements nested more than 32 deep"),
        ("", "no element found"),
        ("\x00", "not well-formed"),
        ("<bml/><bml/>", "junk after document element"),
    ],
)
def test_hostile_xml_is_refused(text: str, message: str) -> None:
    assert message in refusal(text).message


def test_only_utf8_is_read() -> None:
    assert (refusal(RIGHT.replace("Oh", "é").encode("latin-1")).mistakes[0].line) == 2
    assert refusal(RIGHT.encode("utf-16")).mistakes[0].line == 1
    assert read_bml(b"\xef\xbb\xbf" + RIGHT.encode(), Path("take.bml"))[0] == read(RIGHT)


def test_size_and_depth_are_limited() -> None:
    content = RIGHT.encode()
    assert read_bml(content, Path("take.bml"), ReadingLimits(max_bytes=len(content), max_depth=4))
    with pytest.raises(TooLargeError, match="no more than 521 are read"):
        read_bml(content, Path("take.bml"), ReadingLimits(max_bytes=len(content) - 1))
    refusal(RIGHT, ReadingLimits(max_depth=3))


def test_no_more_mistakes_are_told_than_anyone_reads() -> None:
    assert len(refusal(RIGHT.replace("</bml>", "<wave/>" * 20_000 + "</bml>")).mistakes) == MOST_MISTAKES

import pytest

from tests.support.bml.bml_checker import check
from tests.support.shared_data import BML_SUITE, needs

RIGHT = """\
<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="bml1" characterId="Anna">
  <speech id="s1" start="0"><text><sync id="w0"/>Oh <sync id="w1"/></text></speech>
  <gesture id="g1" lexeme="BEAT" mode="LEFT_HAND" start="0.1" ready="0.2" strokeStart="0.2" stroke="0.3" end="1"/>
  <head id="h1" lexeme="NOD" start="s1:w0 + 0.2" end="1.5"/>
  <faceLexeme id="f1" lexeme="RAISE_BROWS" amount="0.5" start="0" attackPeak="0.2" relax="0.3" end="1"/>
  <faceFacs xmlns="http://www.bml-initiative.org/bml/coreextensions-1.0" id="e1" au="45" start="0" end="0.2"/>
  <gaze id="z1" target="Ben" influence="EYES" start="0" end="1"/>
  <wait id="t1" max-wait="2" start="0"/>
  <constraint><before ref="h1:end"><sync ref="g1:stroke"/></before></constraint>
</bml>
"""
EXTENSIONS = 'xmlns="http://www.bml-initiative.org/bml/coreextensions-1.0"'


def test_a_right_document_has_no_mistakes() -> None:
    assert check(RIGHT.encode()) == []


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("</bml>", "", "not well-formed"),
        ('bml-1.0" id', 'bml-2.0" id', "the root is"),
        ("<bml", "<!DOCTYPE bml><bml", "DOCTYPE"),
        ("Oh ", "&#233; ", "numeric character references"),
        ("Oh ", "&#xE9; ", "numeric character references"),
        (' characterId="Anna"', "", "<bml> has no characterId"),
        ('characterId="Anna"', 'character="Anna" characterId="Anna"', "<bml> may not have character"),
        ('characterId="Anna"', 'characterId="Anna" xmlns:a="urn:a" a:b="1"', "<bml> may not have {urn:a}b"),
        ('characterId="Anna"', 'characterId="Anna" composition="merge"', "composition='merge' is none of"),
        ('id="bml1"', 'id="bml-1"', "id='bml-1' breaks references"),
        ('id="g1"', 'id="1g"', "id='1g' breaks references"),
        ('id="h1"', 'id="g1"', "id 'g1' is there 2 times"),
        ('id="w1"', 'id="w0"', "id 'w0' is there 2 times"),
        ('id="g1" ', "", "<gesture>: no id"),
        ('lexeme="BEAT" ', "", "<gesture g1>: no lexeme"),
        ('lexeme="NOD" ', "", "<head h1>: no lexeme"),
        ('lexeme="RAISE_BROWS" ', "", "<faceLexeme f1>: no lexeme"),
        ('lexeme="BEAT"', 'lexeme=""', "lexeme='' is empty"),
        ('stroke="0.3"', 'stroke=""', "stroke='' is empty"),
        ("LEFT_HAND", "LEFT", "mode='LEFT' is none of"),
        ('start="0.1" ', "", "<gesture g1>: no start"),
        ('start="0.1"', 'start="1e-1"', "neither a fixed decimal nor a reference"),
        ('amount="0.5"', 'amount="5e-1"', "is not a fixed decimal"),
        ('amount="0.5"', 'amount="1.5"', "not between 0 and 1"),
        ('start="0.1"', 'start="-0.1"', "is before 0"),
        ('ready="0.2"', 'ready="0.05"', "ready 0.05 is before start 0.1"),
        ('stroke="0.3"', 'stroke="0.1"', "stroke 0.1 is before strokeStart 0.2"),
        ('attackPeak="0.2"', 'ready="0.2"', "<faceLexeme f1>: ready is refused"),
        ('influence="EYES"', 'lexeme="X"', "<gaze z1>: lexeme is refused"),
        ('target="Ben" ', "", "<gaze z1>: no target"),
        ('au="45"', 'au="blink"', "is not a whole number"),
        (EXTENSIONS, "", "no behaviour of BML 1.0 core"),
        (EXTENSIONS, 'xmlns="urn:ours"', "no behaviour of BML 1.0 core"),
        ('<gaze id="z1" target="Ben"', '<faceShift id="z1"', "<faceShift z1>: no behaviour"),
        ('<gaze id="z1" target="Ben"', '<lips id="z1"', "<lips z1>: no behaviour"),
        ('<gaze id="z1" target="Ben"', '<face id="z1"', "<face z1>: no behaviour"),
        ("max-wait", "duration", "<wait t1>: duration is refused"),
        ("<constraint>", '<constraint id="c1">', "id is refused"),
        ("s1:w0", "s2:w0", "unknown behaviour 's2'"),
        ("s1:w0", "s1:w9", "unknown mark 's1:w9"),
        ("h1:end", "h2:end", "unknown behaviour 'h2'"),
        ("<text>", "<text><b/>", "<b>: no part of a behaviour"),
        ('<text><sync id="w0"/>Oh <sync id="w1"/></text>', "", "<speech s1>: no text"),
        ("</text>", '</text><description type="a"/>', "<description>: no priority"),
        ('influence="EYES" start="0"', 'influence="EYES" start="-1"', "is before 0"),
    ],
)
def test_a_wrong_document_has_its_mistake(old: str, new: str, message: str) -> None:
    assert old in RIGHT
    found = check(RIGHT.replace(old, new, 1).encode())
    assert [each for each in found if message in each], found


@pytest.mark.parametrize(
    ("mode", "overlaps"), [("LEFT_HAND", True), ("BOTH_HANDS", True), ("RIGHT_HAND", False), (None, True)]
)
def test_gestures_overlap_hand_by_hand(mode: str | None, *, overlaps: bool) -> None:
    attribute = f'mode="{mode}"' if mode else ""
    second = f'<gesture id="g2" lexeme="ME" {attribute} start="0.5" end="2"/>'
    assert bool(check(RIGHT.replace("</bml>", f"{second}</bml>").encode())) is overlaps


def test_bytes_that_are_no_utf8_are_told() -> None:
    assert check(RIGHT.encode("utf-16"))
    assert check(RIGHT.replace("Oh", "é").encode("latin-1"))


@needs(BML_SUITE)
@pytest.mark.parametrize(
    "name", ["testgaze", "testgazewaist", "testnodlong", "testpoint", "testpose", "testshortbeh", "testspeech2"]
)
def test_files_that_realizers_read_have_no_mistakes_but_ours(name: str) -> None:
    assert check((BML_SUITE / f"core__{name}.xml").read_bytes()) == ["<bml> has no characterId"]

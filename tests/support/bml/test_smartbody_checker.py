"""The checker finds what the real SmartBody refused."""

import pytest

from tests.support.bml.smartbody_checker import check_act, check_speech_file

ACT = (
    '<act><participant id="a" role="actor"/><bml><speech id="speech1" ref="line" type="application/ssml+xml">'
    '<mark name="T0"/>Yes <mark name="T1"/></speech><gesture id="g" type="ME" mode="LEFT_HAND" stroke="speech1:T0+0.1" '
    'relax="2"/><gaze id="z" target="anna" start="1"/><head id="h" type="NOD" start="1"/></bml></act>'
)
SIDE = (
    '<bml><speech><text><sync id="T0" time="0.1"/>Yes <sync id="T1" time="0.4"/></text></speech>'
    '<lips viseme="wide" articulation="1" start="0.1" end="0.2"/></bml>'
)


def test_what_smartbody_played_passes() -> None:
    assert check_act(ACT.encode(), frozenset({"anna"})) == []
    assert check_speech_file(SIDE.encode(), ACT.encode()) == []


@pytest.mark.parametrize(
    ("there", "instead", "told"),
    [
        (' ref="line"', "", "no ref"),
        ("Yes", "R&amp;D", "has &"),
        ("application/ssml+xml", "text/plain", "nor a mark of the speech"),
        ("speech1:T0", "speech1:T2", "nor a mark of the speech"),
        ('name="T1"', 'name="T_1"', "no mark can be called"),
        ('type="ME"', 'type="CENTER"', "no gesture"),
        ("LEFT_HAND", "RIGHT_HAND", "no gesture"),
        ('id="g"', 'id="g" style="high"', "not read"),
        ('stroke="speech1:T0+0.1"', 'start="0.1" stroke="1"', "exactly stroke and relax"),
        ('target="anna"', 'target="bob"', "gaze at bob"),
        ('type="NOD"', 'type="TILT"', "head type"),
        ("<head", '<lips viseme="wide"/><head', "lips is unknown"),
    ],
)
def test_what_smartbody_refused_of_an_act(there: str, instead: str, told: str) -> None:
    assert there in ACT
    assert told in " ".join(check_act(ACT.replace(there, instead).encode(), frozenset({"anna"})))


@pytest.mark.parametrize(
    ("there", "instead", "told"),
    [
        ("<lips", "<curve", "no lips"),
        ('viseme="wide"', 'viseme="PP"', "no mouth has PP"),
        ('id="T1"', 'id="T2"', "no time for T1"),
        ('time="0.1"', 'time="-0.1"', "before the recording"),
    ],
)
def test_what_smartbody_refused_of_a_speech_file(there: str, instead: str, told: str) -> None:
    assert told in " ".join(check_speech_file(SIDE.replace(there, instead).encode(), ACT.encode()))

"""Pawns are read wherever they are permitted; a target without a place is a mistake if others have one."""

from pathlib import Path

import pytest

from understudy.bml.markup.elements import CORE, OURS
from understudy.bml.reading.pawns import placed_by_coordinates, scene_of
from understudy.bml.reading.reader import read_bml
from understudy.bml.reading.resolving import resolve
from understudy.errors import InputError, WrongBmlError
from understudy.model import Behavior, Channel, SyncPoints, Target

DOOR = Target("door", (1.2, 1.4, 2.0))
HEAD = f'<bml xmlns="{CORE}" xmlns:u="{OURS}" id="b" characterId="c">\n'


def read(content: str) -> tuple[tuple[Target, ...], tuple[str, ...]]:
    document, notices = read_bml(f"{HEAD}{content}</bml>".encode(), Path("a.bml"))
    return resolve(document).targets, tuple(notice.code for notice in notices)


PAWN = '<u:pawn name="door" x="1.2" y="1.4" z="2.0"/>'
DESCRIBED = f'<description priority="1" type="application/vnd.understudy.performance+xml">{PAWN}</description>'


@pytest.mark.parametrize("content", [PAWN, f'<speech id="s" start="0"><text>A door.</text>{DESCRIBED}</speech>'])
def test_pawns_stand_in_the_block_or_in_a_description_and_are_not_foreign(content: str) -> None:
    assert read(content) == ((DOOR,), ())


@pytest.mark.parametrize(
    ("pawns", "said"),
    [
        ('<u:pawn name="door" x="1"/>', "line 2: <pawn>: no y, z"),
        ('<u:pawn name="door" x="1" y="nan" z="2"/>', "y is nan"),
        ('<u:pawn name="the door" x="1" y="1" z="2"/>', "a name has letters"),
        ('<u:pawn name="door" x="1" y="left" z="2"/>', "metres"),
        (f"{PAWN}\n{PAWN}", "line 3: <pawn>: target 'door' comes twice"),
    ],
)
def test_a_wrong_pawn_is_told_with_its_line(pawns: str, said: str) -> None:
    with pytest.raises(WrongBmlError) as caught:
        read(pawns)
    assert caught.value.code == "bml_wrong"
    assert said in caught.value.message


def gaze(target: str) -> Behavior:
    return Behavior(f"at_{target}", Channel.GAZE, "LOOK", SyncPoints(0.0, 1.0), 0, 0, 0.0, target=target)


def test_what_is_given_goes_before_the_pawns() -> None:
    nearer = Target("door", (0.6, 1.4, 1.0))
    assert scene_of([gaze("door")], [nearer], [DOOR, Target("window", (0, 1, 1))]) == (
        nearer,
        Target("window", (0, 1, 1)),
    )


def test_a_target_that_nobody_placed_is_a_mistake_in_a_scene_that_places_others() -> None:
    with pytest.raises(InputError) as caught:
        scene_of([gaze("listener"), gaze("door"), gaze("dor")], [], [DOOR])
    assert (caught.value.code, caught.value.field) == ("unknown_target", "targets")
    assert "at_dor: no target is called 'dor'; did you mean 'door'" in caught.value.message


@pytest.mark.parametrize("targets", [("user", "camera"), ("user",), ("listener", "user")])
def test_bml_of_others_places_nothing_and_is_played(targets: tuple[str, ...]) -> None:
    assert scene_of([gaze(target) for target in targets], [], []) == ()


def test_one_other_person_needs_no_place() -> None:
    assert scene_of([gaze("speaker"), gaze("speaker")], [DOOR], []) == (DOOR,)
    with pytest.raises(InputError, match="no target is called 'speaker'"):
        scene_of([gaze("speaker"), gaze("door")], [DOOR], [])


@pytest.mark.parametrize("written", ["1,1.5,-2", " 1.0 , 1.5 , -2.0 ", "1 1.5 -2.0"])
def test_a_target_may_be_a_place(written: str) -> None:
    inside = f'<gaze id="a" target="{written}" start="1"/><pointing id="b" target="1,1.5,-2" start="3"/>'
    core = 'xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b1" characterId="c"'
    found = resolve(read_bml(f'<bml {core}>{inside}<gaze id="c" target="box"/></bml>'.encode(), Path("a.bml"))[0])
    assert found.places == (Target("place1", (1.0, 1.5, -2.0)),)
    assert {each.id: each.target for each in found.behaviors} == {"a": "place1", "b": "place1", "c": "box"}
    assert scene_of(found.behaviors, (), found.targets, found.places) == found.places
    with pytest.raises(InputError, match="no target is called 'box'"):
        scene_of(found.behaviors, (Target("door", (0.0, 1.0, 2.0)),), found.targets, found.places)


@pytest.mark.parametrize("written", ["1,2", "1,2,3,4", "1,2,two", "1,2,5000", "1e3,0,0"])
def test_what_is_no_place_stays_a_name(written: str) -> None:
    behavior = Behavior("a", Channel.GAZE, "LOOK", SyncPoints(0.0, 1.0), 0, 0, 0.0, target=written)
    assert placed_by_coordinates([behavior]) == ((behavior,), ())

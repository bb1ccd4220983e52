"""Others' names of head movements and faces."""

from pathlib import Path

import pytest

from understudy.bml.reading.element_behaviors import LexemeAliases, shipped_aliases
from understudy.bml.reading.reader import read_bml
from understudy.bml.reading.resolving import resolve
from understudy.errors import AuthoringError
from understudy.models import load_realizer
from understudy.realizer.head_and_gaze.head import MOVEMENTS

CORE = 'xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b" characterId="c"'


def lexeme_of(inside: str) -> str:
    content = inside if inside.startswith("<act") else f"<bml {CORE}>{inside}</bml>"
    (found,) = resolve(read_bml(content.encode(), Path("a.bml"))[0]).behaviors
    return found.lexeme


def in_smartbody(inside: str) -> str:
    return f'<act><participant id="brad" role="actor"/><bml>{inside}</bml></act>'


def test_every_lexeme_of_the_file_is_one_that_the_realizer_plays() -> None:
    aliases = shipped_aliases()
    assert set(aliases.heads.values()) <= MOVEMENTS.keys()
    assert set(aliases.faces.values()) <= load_realizer().face.lexemes.keys()


@pytest.mark.parametrize(
    ("inside", "lexeme"),
    [
        ('<head id="h" lexeme="TILT"/>', "TILT_LEFT"),
        ('<head id="h" lexeme="Aside_Right"/>', "TILT_RIGHT"),
        ('<head id="h" lexeme="nod"/>', "NOD"),
        ('<head id="h" lexeme="SOMERSAULT"/>', "SOMERSAULT"),
        ('<faceLexeme id="f" lexeme="joy"/>', "RAISE_MOUTH_CORNERS"),
        (in_smartbody('<head type="nod"/>'), "NOD"),
        (in_smartbody('<gesture lexeme="DEICTIC" type="ME"/>'), "ME"),
        (in_smartbody('<gesture lexeme="METAPHORIC" type="OBLIGATION"/>'), "OBLIGATION"),
        (in_smartbody('<gesture lexeme="SHRUG" type="LAZILY"/>'), "SHRUG"),
        (in_smartbody('<gesture lexeme="MINE" type="ALSO_MINE"/>'), "ALSO_MINE"),
        (in_smartbody('<gesture lexeme="DEICTIC"/>'), "DEICTIC"),
        (in_smartbody('<gesture lexeme="BEAT" type="SHRUG"/>'), "SHRUG"),
        (in_smartbody('<gesture lexeme="NEGATION" type="BEAT"/>'), "NEGATION"),
        (in_smartbody('<gesture type="BEAT"/>'), "BEAT"),
    ],
)
def test_others_names_are_ours(inside: str, lexeme: str) -> None:
    assert lexeme_of(inside) == lexeme


@pytest.mark.parametrize(
    ("unit", "played"),
    [
        ("12", ("AU12", None)),
        ("1_left", ("AU1", "LEFT")),
        ("24", ("PRESS_LIPS", None)),
        ("9" * 5000, None),
        ("x", None),
    ],
)
def test_an_action_unit_may_name_its_side(unit: str, played: tuple[str, str | None] | None) -> None:
    document, _ = read_bml(in_smartbody(f'<face type="facs" au="{unit}"/>').encode(), Path("a.xml"))
    found = [(each.lexeme, each.direction) for each in resolve(document).behaviors]
    assert found == ([played] if played else [])


@pytest.mark.parametrize(
    ("lexeme", "category"), [("CONDUIT", "OPEN_HAND"), ("greta_deictic_self", "ME"), ("greta_refuse", "PUSH_AWAY")]
)
def test_the_gestures_of_asap_have_ours(lexeme: str, category: str) -> None:
    assert load_realizer().library.nearest(lexeme) == category


def test_a_name_stands_once_and_as_it_is_looked_up(tmp_path: Path) -> None:
    path = tmp_path / "bml_aliases.yaml"
    path.write_text("heads:\n  NOD: [YES, yes please]\n  SHAKE: [YES]\nfaces: {}\n")
    with pytest.raises(AuthoringError) as caught:
        LexemeAliases.load(path)
    assert [(each.line, each.column) for each in caught.value.mistakes] == [(2, 14), (3, 11)]

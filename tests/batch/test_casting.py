"""Options of lines: the row overrides the cast, the cast overrides the scene and the command."""

from pathlib import Path
from types import MappingProxyType

import pytest

from understudy.batch.casting import Cast, CastingPlan, CastPart, listener_name, neighbours
from understudy.batch.model import Recording, ScriptLine, Take
from understudy.model import Level, Target
from understudy.options import Options

OURS = ("default", "expansive", "ben")


def line(row: int, character: str, scene: str = "1", **fields: object) -> ScriptLine:
    return ScriptLine(row=row, id=f"l{row}", text="no", character=character, scene=scene, **fields)  # type: ignore[arg-type]


def options(told: ScriptLine, lines: list[ScriptLine], *, has_partners: bool = True, **parts: CastPart) -> Options:
    cast = Cast(MappingProxyType(parts))
    casting = CastingPlan.of(cast, Options(seed=1, stillness=0.25), OURS, lines, has_partners=has_partners)
    return casting.options(Take(told.id, told, Recording(Path("rec/x.wav"))))


def test_those_who_speak_next_in_the_scene_are_partners() -> None:
    lines = [line(1, "A"), line(2, "A"), line(3, "B"), line(4, "C"), line(5, "a"), line(6, "D", "2"), line(7, "E", "")]
    assert neighbours(lines) == {
        **{"l1": ("B",), "l2": ("B",), "l3": ("A", "C"), "l4": ("B", "a"), "l5": ("C",)},
        "l6": (),
    }


def test_partners_listen_and_are_played_by_whom_they_are_cast() -> None:
    lines = [line(1, "Ann"), line(2, "BEN"), line(3, "Mrs. O'Hara")]
    made = options(lines[1], lines, ann=CastPart(character="expansive"))
    assert made.listeners == ("Ann", "Mrs_O_Hara")
    assert made.played_by == (("Ann", "expansive"), ("Mrs_O_Hara", "default"))
    assert (made.character, made.seed, made.stillness) == ("ben", 1, 0.25)
    assert made.form.audio_name == "x"
    assert options(lines[1], lines, has_partners=False).listeners == ()


def test_listeners_have_the_profiles_of_their_parts() -> None:
    lines = [line(1, "Ann"), line(2, "BEN"), line(3, "Eve")]
    made = options(lines[1], lines, ann=CastPart(profile="sparing"), ben=CastPart(profile="sweeping"))
    assert made.profile == "sweeping"
    assert made.listener_profiles == (("Ann", "sparing"),)


def test_the_row_goes_before_the_cast() -> None:
    lines = [line(1, "Ann", seed=9, agitation=Level.HIGH, listeners=("Cat", "ann")), line(2, "BEN")]
    part = CastPart(character="expansive", seed=3, agitation=Level.LOW, stillness=0.0, listeners=("BEN",))
    made = options(lines[0], lines, ann=part)
    assert (made.seed, made.agitation, made.listeners) == (9, Level.HIGH, ("Cat",))
    assert (made.character, made.stillness) == ("expansive", 0.0)
    plain = line(3, "Ann")
    made = options(plain, [*lines, plain], ann=part)
    assert (made.seed, made.agitation, made.listeners) == (3, Level.LOW, ("BEN",))


def test_things_are_where_the_row_says_else_the_cast_else_the_command() -> None:
    told = line(1, "Ann", targets=(Target("door", (3, 1, 1)),))
    part = CastPart(targets=(Target("door", (2, 1, 1)), Target("cup", (2, 1, 1))))
    common = Options(targets=tuple(Target(name, (1, 1, 1)) for name in ("door", "cup", "moon")))
    casting = CastingPlan.of(Cast(MappingProxyType({"ann": part})), common, OURS, [told], has_partners=True)
    targets = casting.options(Take("l1", told, Recording(Path("x.wav")))).targets
    assert {target.name: target.position_m[0] for target in targets} == {"door": 3, "cup": 2, "moon": 1}


@pytest.mark.parametrize(
    ("name", "called"),
    [
        ("MRS. O'HARA", "MRS_O_HARA"),
        ("2nd guard", "L_2nd_guard"),
        ("Zoë", "Zoë"),
        ("Zoe\u0308", "Zoë"),
        ("SÄNGERIN", "SÄNGERIN"),
        ("Jörg Müller", "Jörg_Müller"),
        ("Ж", "Ж"),
        ("?!", "listener"),
    ],
)
def test_listeners_have_names_that_bml_takes(name: str, called: str) -> None:
    assert listener_name(name) == called


def test_what_of_the_cast_is_not_in_the_script_is_told() -> None:
    cast = Cast(MappingProxyType({}), names=("ANNE", "*", "Ben"))
    lines = [line(1, "ANNA"), line(2, "ben")]
    told = CastingPlan.of(cast, Options(), OURS, lines, has_partners=True).remarks(lines)
    assert len(told) == 1
    assert "'ANNA'" in told[0]

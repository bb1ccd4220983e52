from dataclasses import replace
from pathlib import Path

import pytest

from understudy.behavior.characters.overlays import Characters
from understudy.errors import AuthoringError, InputError
from understudy.model import Hand
from understudy.model.figure import PLAIN

LEXICON = Path(__file__).resolve().parents[3] / "lexicon"
SHEET = "description: Somebody.\nhandedness: left\ngestures_per_minute: 12\n"


def lexicon(folder: Path, **sheets: str) -> Path:
    """A lexicon with the shipped table and these characters."""
    (folder / "characters").mkdir()
    (folder / "behaviors.yaml").write_bytes((LEXICON / "behaviors.yaml").read_bytes())
    for name, text in sheets.items():
        (folder / "characters" / f"{name}.yaml").write_text(text, encoding="utf-8")
    return folder


def test_the_shipped_characters_load_and_the_reserved_one_gestures_less() -> None:
    characters = Characters.load(LEXICON)
    default, reserved = characters.named("default"), characters.named("reserved")
    assert reserved.gestures_per_minute < default.gestures_per_minute
    assert default.entries.keys() == reserved.entries.keys() == characters.behavior_names


def test_an_overlay_changes_what_it_says_and_nothing_else(tmp_path: Path) -> None:
    sheet = f"{SHEET}behaviors:\n  beat_both: {{hand: left, timing: gesture}}\n"
    characters = Characters.load(lexicon(tmp_path, plain=SHEET, lefty=sheet))
    plain, lefty = characters.named("plain").entries, characters.named("lefty").entries
    assert characters.named("lefty").handedness is Hand.LEFT
    assert lefty["beat_both"].hand is Hand.LEFT
    assert lefty["beat_both"].timing == plain["gesture_me"].timing != plain["beat_both"].timing
    assert lefty["beat_both"].lexeme == plain["beat_both"].lexeme
    assert [name for name in plain if plain[name] != lefty[name]] == ["beat_both"]


def test_an_unknown_character_is_the_callers_mistake() -> None:
    with pytest.raises(InputError, match="no character 'reservd'; did you mean 'reserved'") as caught:
        Characters.load(LEXICON).named("reservd")
    assert (caught.value.code, caught.value.field) == ("unknown_character", "character")


def test_four_characters_ship_and_none_moves_like_another() -> None:
    characters = list(Characters.load(LEXICON).by_name.values())
    assert {"default", "reserved", "expansive", "formal_elder"} == {each.name for each in characters}
    for setting in ("gestures_per_minute", "amplitude", "eye_contact", "rest_poses", "entries"):
        assert len({repr(getattr(each, setting)) for each in characters}) == 4, setting


def test_amplitude_sizes_what_has_a_size(tmp_path: Path) -> None:
    sheets = {name: f"{SHEET}amplitude: {value}\n" for name, value in (("usual", 1), ("small", 0.5), ("large", 2))}
    characters = Characters.load(lexicon(tmp_path, **sheets))
    usual, small, large = (characters.named(name).entries for name in sheets)
    assert (usual["shake"].amount, small["shake"].amount, large["shake"].amount) == (0.7, 0.35, 1.0)
    assert (small["gesture_me"].amount, usual["gesture_me"].amount) == (0.25, 0.5)
    for name in ("gaze_left", "blink", "lean_back"):
        assert small[name] == usual[name]


@pytest.mark.parametrize("pose", ["rest_hands_foldet", "big_nod"])
def test_a_rest_pose_is_a_posture_of_the_table(tmp_path: Path, pose: str) -> None:
    with pytest.raises(AuthoringError, match="is not a posture") as caught:
        Characters.load(lexicon(tmp_path, wrong=f"{SHEET}rest_poses: [{pose}]\n"))
    assert [mistake.line for mistake in caught.value.mistakes] == [4]


@pytest.mark.parametrize(
    ("behaviors", "message"),
    [
        ("beat_bot: {hand: left}", "no behaviour 'beat_bot'; did you mean 'beat_both'"),
        ("big_nod: {hand: left}", "hand is for gesture"),
        ("big_nod: {timing: brows}", "has a stroke"),
        ("big_nod: {channel: gaze}", "unknown key"),
        ("big_nod: {amount: much}", "valid number"),
    ],
)
def test_a_wrong_change_is_told_with_its_place(tmp_path: Path, behaviors: str, message: str) -> None:
    folder = lexicon(tmp_path, wrong=f"{SHEET}behaviors:\n  {behaviors}\n")
    with pytest.raises(AuthoringError, match=message) as caught:
        Characters.load(folder)
    assert [(mistake.path.name, mistake.line) for mistake in caught.value.mistakes] == [("wrong.yaml", 5)]


def test_the_mistakes_of_all_files_are_told_at_once(tmp_path: Path) -> None:
    folder = lexicon(tmp_path, one=SHEET.replace("left", "third"), two=f"{SHEET}age: 30\n")
    (folder / "characters" / "no-name.yaml").write_text(SHEET, encoding="utf-8")
    (folder / "behaviors.yaml").write_text("timings: {}\nbehaviors: {}\nrules: {}\n", encoding="utf-8")
    with pytest.raises(AuthoringError) as caught:
        Characters.load(folder)
    files = [mistake.path.name for mistake in caught.value.mistakes]
    assert files == ["behaviors.yaml", "no-name.yaml", "one.yaml", "two.yaml"]


def test_the_documented_example_loads(tmp_path: Path) -> None:
    page = (LEXICON.parent / "docs" / "characters.md").read_text(encoding="utf-8")
    example = page.split("```yaml\n")[1].split("```")[0]
    assert Characters.load(lexicon(tmp_path, example=example)).named("example").handedness is Hand.LEFT


def test_no_two_characters_look_alike() -> None:
    figures = [each.figure for each in Characters.load(LEXICON).by_name.values()]
    for part in ("physique", "looks", "manner"):
        assert len({getattr(figure, part) for figure in figures}) == 4, part


def test_who_says_nothing_of_a_body_has_an_average_one(tmp_path: Path) -> None:
    figure = Characters.load(lexicon(tmp_path, plain=SHEET)).named("plain").figure
    assert figure == replace(PLAIN, leading=Hand.LEFT)


@pytest.mark.parametrize(
    ("line", "place", "message"),
    [
        ("body: {height_m: 1.44}", (4, 18), "greater than or equal to 1.45"),
        ("body: {height_m: 2.06}", (4, 18), "less than or equal to 2.05"),
        ("body: {height_m: nan}", (4, 18), ""),
        ("body: {age_years: 12}", (4, 19), "greater than or equal to 16"),
        ("body: {sex: man}", (4, 13), "'female', 'male' or 'neutral'"),
        ("body: {girth: 1}", (4, 15), "unknown key"),
        ('looks: {top_colour: "red"}', (4, 21), "match pattern"),
        ("looks: {hair: mohawk}", (4, 15), "'bald', 'short', 'bob', 'long' or 'bun'"),
        ("gestures: {space: 1.31}", (4, 19), "less than or equal to 1.3"),
        ("gestures: {wrist_deg: -21}", (4, 23), "greater than or equal to -20"),
    ],
)
def test_what_no_body_can_be_is_told_with_its_place(
    tmp_path: Path, line: str, place: tuple[int, int], message: str
) -> None:
    with pytest.raises(AuthoringError) as caught:
        Characters.load(lexicon(tmp_path, wrong=f"{SHEET}{line}\n"))
    (mistake,) = caught.value.mistakes
    assert (mistake.line, mistake.column) == place
    assert message in mistake.message

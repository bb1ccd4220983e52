"""An author's own folder, laid over the bundled files: checked with the places of its mistakes, listed, performed."""

import json
import os
from pathlib import Path

import pytest

import understudy as package
from understudy.authored_folders import VARIABLE, laid_over, lexicon_folder, origin, rules_folder
from understudy.authoring.file_checking import check_files
from understudy.authoring.proofreading import check_files_in_use
from understudy.authoring.rule_edits import mistakes_in
from understudy.cli.main import main
from understudy.errors import AuthoringError, InputError
from understudy.files import RULES, resource_folder
from understudy.models import load_characters, load_families, load_function_rules

GESTURE = """\
GESTURECLASS emblem
GESTUREINSTANCE wag_finger
CATEGORY WAG
DURATION 1.4
STARTFRAME 0.3
  FRAMETYPE stroke_start
  ARM XC YUpperC ZMiddle OFFSET -0.05 0 0
  HAND symbol_1
  WRIST FBUp PalmAway
ENDFRAME
STARTFRAME 0.66
  FRAMETYPE stroke_end
  ARM XC YUpperC ZMiddle OFFSET 0.07 -0.01 0
  HAND symbol_1
  WRIST FBUp PalmAway
ENDFRAME
STARTFRAME 1.0
  FRAMETYPE end
ENDFRAME
"""
RULE = """\
# A finger wagged for thanks, so that nobody else's rule does it.
rule show_muchly
foreach
  fcn(thanks, plain, $start, $end, _)
choose
  always
    wag($start, $end)
"""
FILES = {
    "lexicon/en/thanks_in_britain.yaml": 'class: thanks\ngroups:\n  - example: "{} for it."\n    words: [ta muchly]\n',
    "rules/behaviors/own.rules": RULE,
    "behaviors.yaml": "behaviors:\n  wag: {channel: gesture, lexeme: WAG, timing: gesture}\n",
    "acting/families.yaml": "shows:\n  WAG: [negation]\n",
    "gestures/wag.gesture": GESTURE,
    "characters/stern.yaml": "description: Stern.\nhandedness: left\ngestures_per_minute: 8\n",
    "README.md": "not read",
}


@pytest.fixture
def own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("UNDERSTUDY_CACHE", str(tmp_path / "cache"))
    monkeypatch.delenv(VARIABLE, raising=False)
    folder = tmp_path / "own"
    for name, text in FILES.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def test_own_files_are_read_with_the_bundled_ones(own: Path) -> None:
    with laid_over([own]):
        characters, functions = load_characters(), load_function_rules()
        families = load_families(characters)
    assert "stern" in characters.by_name
    assert {"wag", "shake"} <= characters.behavior_names
    assert families.shows["WAG"] == ("negation",)
    (entry,) = [each for each in functions.lexicon.entries if each.phrase == "ta muchly"]
    assert origin(entry.path) == own / "lexicon" / "en" / "thanks_in_britain.yaml"
    assert "stern" not in load_characters().by_name
    assert (lexicon_folder(), rules_folder()) == (resource_folder("lexicon"), RULES)


def test_a_file_of_the_same_name_takes_the_place_of_a_bundled_one_and_of_an_earlier_folders(own: Path) -> None:
    later = own.parent / "later" / "characters"
    later.mkdir(parents=True)
    (later / "stern.yaml").write_text(FILES["characters/stern.yaml"].replace("left", "right"), encoding="utf-8")
    with laid_over([own, later.parent]):
        assert load_characters().by_name["stern"].handedness == "right"
    with laid_over([later.parent, own]):
        assert load_characters().by_name["stern"].handedness == "left"


def test_the_command_finds_mistakes_where_the_author_made_them(own: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rules", "check", "--lexicon", str(own)]) == 0
    rule = own / "rules" / "behaviors" / "own.rules"
    rule.write_text(RULE.replace("wag(", "wagg("), encoding="utf-8")
    (own / "behaviors.yaml").write_text(FILES["behaviors.yaml"].replace("WAG", "WIG"), encoding="utf-8")
    assert main(["rules", "check", "--lexicon", str(own)]) == 2
    told = capsys.readouterr().err
    assert f"{rule}:7:5: unknown behaviour wagg; did you mean 'wag'?" in told
    assert VARIABLE not in os.environ


def test_the_commands_list_what_the_folder_adds(own: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rules", "list", "--json", "--lexicon", str(own)]) == 0
    rules = {each["name"]: each for each in json.loads(capsys.readouterr().out)["rules"]}
    assert rules["show_muchly"]["file"] == str(own / "rules" / "behaviors" / "own.rules")
    assert rules["wag"]["file"] == str(own / "behaviors.yaml")
    assert rules["wag"]["line"] == 2
    assert not Path(rules["shake"]["file"]).is_absolute()
    assert main(["gestures", "show", "wag_finger", "--lexicon", str(own)]) == 0
    assert main(["characters", "list", "--lexicon", str(own)]) == 0
    assert "stern" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "text"),
    [
        (
            "app/rules/functions/own.rules",
            "rule x\nforeach\n  wrd(never, $s, $e)\nassert\n  fcn(thanks, plain, $s, $e)\n",
        ),
        (
            "app/rules/functions/own.rules",
            "rule x\nforeach\n  word(so, $s, $e)\nassert\n  fcn(thanks, plain, $s, $e)\n",
        ),
        ("app/rules/behaviors/own.rules", RULE),
        ("lexicon/en/own.yaml", "groups: []\n"),
        ("en/own.yaml", FILES["lexicon/en/thanks_in_britain.yaml"].replace("thanks", "thank")),
        ("rules/behaviors/own.rules", RULE.replace("wag", "shake")),
        ("gestures/own.gesture", GESTURE.replace("symbol_1", "symbol1")),
        ("characters/own.yaml", FILES["characters/stern.yaml"] + "behaviors:\n  gesture_negation: {lexeme: WAG}\n"),
        ("characters/own.yaml", "description: Stern.\n"),
        ("profiles/own.yaml", "description: Stern.\n"),
        ("lexicon/acting/weights.yaml", "terms:\n  no_such_term: {any: 1}\n"),
    ],
)
def test_a_new_file_gets_the_same_answer_at_both_doors(tmp_path: Path, name: str, text: str) -> None:
    path = tmp_path / name
    path.parent.mkdir(parents=True)
    path.write_text(text, encoding="utf-8")
    try:
        check_files([path])
        told = []
    except AuthoringError as error:
        told = [(each.line, each.column, each.message) for each in error.mistakes]
    served = mistakes_in({name: text}, load_characters().callable_names)
    assert told == [(each.line, each.column, each.message) for each in served]


def test_a_performance_uses_them(own: Path) -> None:
    with package.load(lexicon=[own]) as models:
        performance = package.say(models, "Ta muchly for that.", character="stern")
        (wag,) = [each for each in performance.behaviors if each.kept and each.lexeme == "WAG"]
        played = package.realize(models, performance, fps=30)
    assert (wag.rule, wag.first) == ("show_muchly", 0)
    assert not any("WAG" in each.reason for each in played.motion.decisions)


def test_files_that_nothing_reads_or_can_read_and_folders_that_are_missing_are_told(own: Path) -> None:
    (own / "own.rules").write_text(RULE, encoding="utf-8")
    with laid_over([own]), pytest.raises(AuthoringError) as wrong:
        load_characters()
    (mistake,) = wrong.value.mistakes
    assert str(mistake).startswith(f"{own / 'own.rules'}:1:1: a file here is never read")
    assert "files are read from en/, gestures/" in mistake.message
    (own / "own.rules").unlink()
    (own / "en").mkdir(exist_ok=True)
    (own / "en" / "lost.yaml").symlink_to("nowhere.yaml")
    (own / "en" / "plain.yaml").write_text("words: [ta]\n", encoding="utf-8")
    with (
        laid_over([own]),
        pytest.raises(AuthoringError, match=r"nowhere\.yaml:1:1: is neither a file nor a link to one"),
    ):
        load_characters()
    (own / "en" / "lost.yaml").unlink()
    with laid_over([own]), pytest.raises(AuthoringError, match=r"plain\.yaml:1:1: a file of words begins with"):
        check_files_in_use()
    with laid_over([own / "gone"]), pytest.raises(InputError, match=r"gone: no such folder"):
        load_characters()

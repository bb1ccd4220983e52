import re
from pathlib import Path

import pytest

from understudy.behavior.candidates.attitudes import load_attitudes
from understudy.behavior.candidates.targets import LOOK
from understudy.behavior.reading.families import load_families
from understudy.behavior.table.behavior_table import UNASKED, Anchor, BehaviorChange, load_table
from understudy.errors import AuthoringError
from understudy.model import Channel, Hand, Level

TABLE = Path(__file__).resolve().parents[3] / "lexicon" / "behaviors.yaml"

SMALLEST = """\
timings:
  nod: {preparation: [0.1, 0.2], stroke: [0.1, 0.2], hold: [0, 0], retraction: [0.1, 0.2], alignment: 0.5}
  look: {preparation: [0.1, 0.2], hold: [0, 0], retraction: [0.1, 0.2]}
behaviors:
  blink: {channel: eyes, lexeme: BLINK, timing: look, amount: 1}
"""
SMALLEST += "".join(f"  {name}: {{channel: gesture, lexeme: X, timing: nod}}\n" for name in UNASKED if name != "blink")
NEXT_LINE = len(SMALLEST.splitlines()) + 1


def written(folder: Path, text: str) -> Path:
    path = folder / "behaviors.yaml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_table_has_130_entries_on_every_channel() -> None:
    lines = load_table(TABLE).lines
    assert len(lines) >= 130
    assert {line.channel for line in lines.values()} == set(Channel)


def test_gestures_strike_at_or_before_the_vowel() -> None:
    table = load_table(TABLE)
    gestures = [name for name, line in table.lines.items() if line.channel is Channel.GESTURE]
    assert all(table.entry(name).timing.alignment == 1 for name in gestures)


def test_an_entry_has_what_its_line_says_and_nothing_else() -> None:
    entry = load_table(TABLE).entry("gesture_point_left")
    assert (entry.channel, entry.lexeme, entry.hand) == (Channel.GESTURE, "POINT_LEFT", Hand.LEFT)
    assert entry.anchor is Anchor.FIRST
    assert (entry.amount, entry.target, entry.direction, entry.repetitions) == (None, None, None, None)


def test_one_hand_makes_when_calm_what_both_make_otherwise_and_both_when_agitated_what_one_does() -> None:
    table = load_table(TABLE)
    by_both, by_one = table.entry("gesture_accept"), table.entry("gesture_give_idea")
    assert [by_both.at(level).hand for level in Level] == [None, Hand.BOTH, Hand.BOTH]
    assert [by_one.at(level).hand for level in Level] == [None, None, Hand.BOTH]


def test_a_hand_that_a_character_sets_is_the_hand_at_every_level() -> None:
    table = load_table(TABLE)
    entry = table.entry("gesture_accept", BehaviorChange(hand=Hand.BOTH))
    assert {entry.at(level).hand for level in Level} == {Hand.BOTH}


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("{channel: gesture, lexeme: X, timing: nod, one_hand_at: [low]}", "give it `hand: both`"),
        ("{channel: gesture, lexeme: X, timing: nod, hand: left, both_hands_at: [high]}", "without a `hand`"),
        ("{channel: head, lexeme: NOD, timing: nod, both_hands_at: [high]}", "is for gestures"),
        ("{channel: head, lexeme: NOD, timing: nodd}", "unknown timing 'nodd'; did you mean 'nod'"),
        ("{channel: head, lexeme: NOD, timing: nod, hand: left}", "hand is for gesture, this is head"),
        ("{channel: posture, lexeme: LEAN, timing: look, amount: 0.5}", "amount is for"),
        ("{channel: head, lexeme: nod, timing: nod}", "pattern"),
        ("{channel: head, lexeme: NOD, timing: look}", "has a stroke"),
        ("{channel: face, lexeme: RAISE_BROWS, timing: nod}", "has no stroke"),
        ("{channel: face, lexeme: RAISE_BROW, timing: look}", "did you mean 'RAISE_BROWS'"),
        ("{channel: gaze, lexeme: STARE, timing: look, target: listener}", "a gaze is one of GLANCE, LOOK, SHIFT"),
        ("{channel: gaze, lexeme: LOOK, timing: look}", "a gaze needs a target"),
        ("{channel: gaze, lexeme: LOOK, timing: look, target: sky, direction: UP}", "go together"),
        ("{channel: head, lexeme: NOD, timing: nod, amount: 1.5}", "less than or equal to 1"),
        ("{channel: head, lexeme: NOD, timing: nod, amuont: 1}", "unknown key"),
        ("{channel: knee, lexeme: NOD, timing: nod}", "'gesture', 'head'"),
        ("{lexeme: NOD, timing: nod}", "is missing"),
    ],
)
def test_a_wrong_line_is_told_with_its_place(tmp_path: Path, line: str, message: str) -> None:
    with pytest.raises(AuthoringError, match=message) as caught:
        load_table(written(tmp_path, f"{SMALLEST}  wrong: {line}\n"))
    assert {mistake.line for mistake in caught.value.mistakes} == {NEXT_LINE}


@pytest.mark.parametrize("timing", ["[0.3, 0.2]", "[-1, 0.2]", "[0.2]", "[nan, 1]", "soon"])
def test_a_wrong_duration_is_told_with_its_place(tmp_path: Path, timing: str) -> None:
    text = SMALLEST.replace("stroke: [0.1, 0.2]", f"stroke: {timing}")
    with pytest.raises(AuthoringError) as caught:
        load_table(written(tmp_path, text))
    assert {mistake.line for mistake in caught.value.mistakes} == {2}


def test_all_mistakes_are_told_at_once(tmp_path: Path) -> None:
    wrong = (
        "  a: {channel: head, lexeme: NOD, timing: no}\n  b: {channel: head, lexeme: NOD, timing: nod, hand: left}\n"
    )
    with pytest.raises(AuthoringError) as caught:
        load_table(written(tmp_path, SMALLEST + wrong))
    assert [mistake.line for mistake in caught.value.mistakes] == [NEXT_LINE, NEXT_LINE + 1]


def test_the_body_needs_its_own_entries(tmp_path: Path) -> None:
    with pytest.raises(AuthoringError, match="'blink' is missing"):
        load_table(written(tmp_path, "\n".join(SMALLEST.splitlines()[:4] + SMALLEST.splitlines()[5:])))


def test_every_behaviour_is_documented() -> None:
    page = (TABLE.parents[1] / "docs" / "behaviors.md").read_text(encoding="utf-8")
    table = load_table(TABLE)
    missing = [name for name, line in table.lines.items() if not re.search(rf"`{name}` .*\b{line.lexeme}\b", page)]
    assert missing == []


def test_every_behaviour_is_chosen_by_a_rule_or_for_a_family_or_done_unasked() -> None:
    table = load_table(TABLE)
    postures = {name for name in table.lines if name.startswith("rest_")}
    families = load_families(TABLE.parent / "acting" / "families.yaml", table.lines)
    asked = [each for part in (families.gesture, families.head, families.face) for each in part.values()]
    acted = {behavior.name for behaviors in asked for behavior in behaviors}
    rules = (TABLE.parents[1] / "app" / "rules" / "behaviors").glob("*.rules")
    called = {name for path in rules for name in re.findall(r"(\w+)\(\$\w+, \$end\)", path.read_text(encoding="utf-8"))}
    attitudes = load_attitudes(TABLE.parent / "acting" / "attitudes.yaml", table.lines, families.face)
    held = {name for attitude in attitudes.values() for name in attitude.shows}
    assert table.lines.keys() - called - acted - held - postures - {*UNASKED, LOOK} == set()

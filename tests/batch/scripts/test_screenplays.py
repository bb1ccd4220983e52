"""Screenplays: speeches with their cues, scenes, parentheticals, and nothing that is not spoken."""

from pathlib import Path

import pytest

from understudy.batch.scripts.screenplays import read_fdx, read_fountain
from understudy.errors import UndecodableError

FOUNTAIN = """Title: Lights
Author: Nobody

INT. HOUSE - DAY #1A#

ANNA looks up.

ANNA (V.O.)
(softly)
I *never* saw [[id: a12]] those,
(beat)
_never_ \\*ever\\*.

@McTeague ^
No!

EXT. HILL - NIGHT

ANNA (CONT'D)
Go.

BEN
(waits)

BEN
You go.
"""

FDX = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FinalDraft DocumentType="Script" Template="No" Version="5"><Content>
<Paragraph Number="4" Type="Scene Heading"><Text>INT. HOUSE - DAY</Text></Paragraph>
<Paragraph Type="Character"><Text>ANNA (V.O.) (CONT'D)</Text></Paragraph>
<Paragraph Type="Parenthetical"><Text>(softly)</Text></Paragraph>
<Paragraph Type="Dialogue"><Text>I </Text><Text Style="Italic">never</Text><Text> saw those.</Text></Paragraph>
<Paragraph><DualDialogue>
<Paragraph Type="Character"><Text>BEN</Text></Paragraph>
<Paragraph Type="Dialogue"><Text>No!</Text></Paragraph>
<Paragraph Type="Character"><Text>CAT</Text></Paragraph>
<Paragraph Type="Dialogue"><Text>Yes!</Text></Paragraph>
</DualDialogue></Paragraph>
</Content></FinalDraft>
"""


def test_fountain() -> None:
    script = read_fountain(FOUNTAIN.encode(), Path("lights.fountain"), {})
    told = [(line.row, line.id, line.scene, line.character, line.text, line.comment) for line in script.lines]
    assert told == [
        (8, "a12", "1A", "ANNA", "I never saw those, never *ever*.", "V.O.; softly; beat"),
        (14, "scene1A_002", "1A", "McTeague", "No!", ""),
        (19, "scene2_001", "2", "ANNA", "Go.", ""),
        (25, "scene2_002", "2", "BEN", "You go.", ""),
    ]


def test_final_draft_with_styles_and_dual_dialogue() -> None:
    script = read_fdx(FDX.encode(), Path("lights.fdx"), {})
    told = [(line.id, line.character, line.text, line.comment) for line in script.lines]
    assert told == [
        ("scene4_001", "ANNA", "I never saw those.", "V.O.; softly"),
        ("scene4_002", "BEN", "No!", ""),
        ("scene4_003", "CAT", "Yes!", ""),
    ]
    assert [line.row for line in script.lines] == [4, 8, 10]


def test_what_is_no_final_draft_file_is_told() -> None:
    with pytest.raises(UndecodableError) as raised:
        read_fdx(b"<FinalDraft>", Path("lights.fdx"), {})
    assert raised.value.code == "screenplay_undecodable"


def test_two_speeches_of_the_same_id_are_told() -> None:
    text = "ANNA\nNo. [[id: x]]\n\nBEN\nYes. [[id: X]]\n"
    script = read_fountain(text.encode(), Path("lights.fountain"), {})
    assert [line.id for line in script.lines] == ["x"]
    assert [(problem.row, problem.code) for problem in script.problems] == [(4, "id_repeated")]
